// NAME.timeline.json: a timeline as a file, for people, other programs and later comparison.
//
// docs/topology.md has the schema. Numbers are written as the shortest decimals that read back as
// the same doubles; enclosures as [lo, hi], with null for an infinite end. Redundant values that
// only help readers (frames, points, Betti numbers of the surface) are checked against the rest on
// reading, so that no edit goes unnoticed.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "topology/timeline/timeline_header.h"

namespace isomotion::topology {

inline constexpr std::string_view timeline_format = "isomotion topology timeline";
inline constexpr int timeline_version = 1;
inline constexpr std::size_t most_timeline_bytes = 16 << 20; // of a file that is read

std::string to_json(const TimelineRecord& record);

// read(to_json(record), ...) == record. `file` is for messages. Throws base::InputError.
TimelineRecord parse_timeline(std::string_view text, const std::string& file);
// Also throws base::InputError if there is no such file.
TimelineRecord read_timeline(const std::filesystem::path& file);

} // namespace isomotion::topology
