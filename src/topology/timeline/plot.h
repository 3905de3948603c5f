// Plots Betti numbers over time: an SVG of steps, with a lane for each kind of event and a row of
// pictures of the surface above. It can be read from three events to thousands: plot_lanes.h says
// how lanes show many, kind_mark.h which marks they have.
#pragma once

#include <string>
#include <vector>

#include "topology/timeline/timeline_header.h"

namespace isomotion::topology {

struct Thumbnail {
    double frame = 0;
    std::string picture; // reference for an <image>: a file's name or "data:image/png;base64,..."
};

std::string plot_svg(const TimelineRecord& record, const std::vector<Thumbnail>& thumbnails = {});

} // namespace isomotion::topology
