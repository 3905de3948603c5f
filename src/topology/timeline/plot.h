// Betti numbers over time as a picture: an SVG of steps, with a lane of marks for each kind of
// event and pictures of the surface in a row above.
//
// Colours are those of Okabe and Ito (2008) and Tol's muted scheme, told apart by people who see
// fewer of them; no mark is told by its colour alone.
#pragma once

#include <string>
#include <vector>

#include "topology/timeline/timeline_header.h"

namespace isomotion::topology {

struct Thumbnail {
    double frame = 0;
    std::string picture; // what an <image> refers to: a file's name or "data:image/png;base64,..."
};

std::string plot_svg(const TimelineRecord& record, const std::vector<Thumbnail>& thumbnails = {});

} // namespace isomotion::topology
