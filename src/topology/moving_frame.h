// A scene's surface at one time or over a short span of time, with exact values: what frames and
// kinds are proved of.
#pragma once

#include "scene/scene_at.h"
#include "topology/certified_frame.h"
#include "topology/kinds.h"
#include "topology/motion.h"

namespace isomotion::topology {

class MovingFrames {
public:
    MovingFrames(const scene::Scene& scene, Side solid, formula::Interval range);

    struct Frame {
        SpaceFormula formula;
        scene::BoundsAt bounds; // rounded
    };
    // The time lies between two knots of the animation.
    Frame at(formula::Interval time) const;

    CertifiedFrame certify(double time, const FrameLimits& limits = {}) const;
    // Refers to this.
    KindProofs proofs(const FrameLimits& limits = {}) const;

private:
    Motions motions_;
};

} // namespace isomotion::topology
