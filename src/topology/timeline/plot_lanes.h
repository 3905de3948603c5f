// The part of a plot that shows when events of each kind are: a lane for each.
//
// Where each event of a lane has room, it is a triangle with its frame beside it. In a lane that
// is crowded each event is a tick, at its exact place, and bars above the ticks count how many are
// in each frame, or in each so many frames (a histogram over a rug). The highest bars have their
// numbers; each lane has its own scale.
#pragma once

#include "topology/timeline/plot_axis.h"
#include "topology/timeline/svg.h"
#include "topology/timeline/timeline_header.h"

namespace isomotion::topology {

// What a legend is to explain.
struct LanesDrawn {
    double bottom = 0;      // where the next thing goes
    bool triangles = false; // of known kinds
    double bin = 0;         // frames that a bar counts; 0: there are no bars
};

LanesDrawn draw_lanes(Svg& svg, const PlotAxis& axis, const TimelineRecord& record, double top);

// Signs in lanes and legends, around a point, as a path.
std::string triangle(double x, double y, bool up);
std::string diamond(double x, double y);

} // namespace isomotion::topology
