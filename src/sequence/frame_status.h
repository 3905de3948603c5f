// Whether a frame's file is what it should be.
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
    changed,  // since it was recorded: cut off, or other bytes
    stale,    // recorded with another fingerprint
    outdated, // the same, by another version of the program
    foreign,  // nobody recorded it
};
inline constexpr std::array status_names{"whole",
                                         "missing",
                                         "truncated or changed",
                                         "of other settings",
                                         "of another version",
                                         "of an earlier scene"};

constexpr std::string_view name(FrameStatus status) { return status_names[std::size_t(status)]; }

// Goes by its record and the hash of its bytes; neither dates nor what the file says of itself
// count. `version` is that of the program that would draw it.
FrameStatus frame_status(const std::filesystem::path& file,
                         const std::optional<FrameRecord>& record, std::string_view fingerprint,
                         std::string_view version);

} // namespace isomotion::sequence
