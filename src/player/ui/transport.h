// The bar at the bottom: play, step, speed, loop, and the timeline with its markers.
#pragma once

#include <string>
#include <vector>

#include "animation/timeline.h"
#include "player/model/playback.h"
#include "player/model/timeline_markers.h"

namespace isomotion::player {

class Transport {
public:
    // Shows the bar in Dear ImGui's current window and returns the changed playback.
    Playback show(const Playback& playback, const animation::Timeline& timeline,
                  const std::vector<TimelineMarker>& markers, double now);

    static float height(); // of the bar, in the current style

private:
    Playback buttons(Playback playback, double now);
    Playback speed(Playback playback, double now);
    Playback place(Playback playback, const animation::Timeline& timeline, double now);
    Playback scrubber(Playback playback, const std::vector<TimelineMarker>& markers, double now);

    bool scrubbing_ = false, played_ = false; // whether it played when the scrubbing began
};

} // namespace isomotion::player
