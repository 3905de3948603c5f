// Plots Betti numbers over time: an SVG of steps, with a lane of markers for each kind of event and
// a row of pictures of the surface above.
//
// Colours are those of Okabe and Ito (2008) and Tol's muted scheme, which colour-blind people can
// distinguish. Colour is never the only difference between markers.
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
