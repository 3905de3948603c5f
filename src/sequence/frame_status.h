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
    changed, // since it was recorded: cut off, or other bytes
    stale,   // recorded with another fingerprint
    foreign, // nobody recorded it
};
inline constexpr std::array status_names{"whole", "missing", "truncated or changed",
                                         "of other settings", "foreign"};

constexpr std::string_view name(FrameStatus status) { return status_names[std::size_t(status)]; }

// By its record and the hash of its bytes; neither dates nor what the file says of itself count.
FrameStatus frame_status(const std::filesystem::path& file,
                         const std::optional<FrameRecord>& record, std::string_view fingerprint);

} // namespace isomotion::sequence
