// The status of a frame's file.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "sequence/record.h"

namespace isomotion::sequence {

enum class FrameStatus {
    whole,
    missing,
    changed,  // since it was recorded: cut off, or with other bytes
    stale,    // recorded with another fingerprint
    outdated, // the same, by another version of the program
    foreign,  // not recorded
};
inline constexpr std::array status_names{"whole",
                                         "missing",
                                         "truncated or changed",
                                         "of other settings",
                                         "of another version",
                                         "of an earlier scene"};

constexpr std::string_view name(FrameStatus status) { return status_names[std::size_t(status)]; }

// Uses the frame's record and the hash of its bytes, neither dates nor the file's own entries.
// `version` is that of the program that would draw it.
FrameStatus frame_status(const std::filesystem::path& file,
                         const std::optional<FrameRecord>& record, std::string_view fingerprint,
                         std::string_view version);

} // namespace isomotion::sequence
