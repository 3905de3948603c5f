// NAME.timeline.json: a timeline as a file, for people, other programs and later comparison.
//
// docs/topology.md has the schema. Numbers are written as the shortest decimals that read back as
// the same doubles; enclosures as [lo, hi], null in place of an infinite end. What is written for
// readers' ease alone (frames, points, Betti numbers of the surface) is checked against the rest
// when it is read, so that no edit is without effect.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "topology/timeline/timeline_header.h"

namespace isomotion::topology {

inline constexpr std::string_view timeline_format = "isomotion topology timeline";
inline constexpr int timeline_version = 1;

std::string to_json(const TimelineRecord& record);

// read(to_json(record), ...) == record. `file` is for messages. Throws DocumentError.
TimelineRecord parse_timeline(std::string_view text, const std::string& file);
// Also throws DocumentError where there is no such file.
TimelineRecord read_timeline(const std::filesystem::path& file);

} // namespace isomotion::topology
