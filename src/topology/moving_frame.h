// A scene's surface at one time or over a short span of time, with exact values: what frames and
// kinds are proved of.
#pragma once

#include "scene/scene_at.h"
#include "topology/certified_frame.h"
#include "topology/field_moment.h"
#include "topology/kinds.h"
#include "topology/timed_formula.h"

namespace isomotion::topology {

class MovingFrames {
public:
    MovingFrames(const scene::Scene& scene, Side solid, formula::Interval range);

    struct Frame {
        SpaceFormula formula;
        scene::BoundsAt bounds; // rounded
    };
    // The time lies between two knots of the animation, or is the end of the range: there values
    // are those after a jump, as they are drawn.
    Frame at(formula::Interval time) const;

    CertifiedFrame certify(double time, const FrameLimits& limits = {}) const;
    // Of these events, by time. Refer to this.
    KindProofs proofs(std::vector<Event> events, const SeekingPaths& seeking = {},
                      const FrameLimits& limits = {}) const;

private:
    const TimedFormula& piece_at(formula::Interval time) const;

    std::vector<TimedFormula> pieces_;
    std::optional<TimedFormula> at_end_;
};

} // namespace isomotion::topology
