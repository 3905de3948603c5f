// A scene's surface at one time or over a short span of time, with exact values: what frames and
// kinds are proved of.
#pragma once

#include "scene/scene_at.h"
#include "topology/betti/certified_frame.h"
#include "topology/classify/field_snapshot.h"
#include "topology/classify/kinds.h"
#include "topology/field/timed_formula.h"

namespace isomotion::topology {

class MovingScene {
public:
    MovingScene(const scene::Scene& scene, Side solid, formula::Interval range);

    struct Still {
        SpaceFormula formula;
        scene::BoundsAt bounds; // rounded
    };
    // The time lies between two knots of the animation, or is the end of the range: there values
    // are those after a jump, as they are drawn.
    Still at(formula::Interval time) const;

    CertifiedFrame certify(double time, const FrameLimits& limits = {}) const;
    // For the kinds of these events, ordered by time. The proofs refer to this scene.
    KindProofs proofs(std::vector<Event> events, const PathOptions& seeking = {},
                      const FrameLimits& limits = {}) const;

private:
    const TimedFormula& piece_at(formula::Interval time) const;

    std::vector<TimedFormula> pieces_;
    std::optional<TimedFormula> at_end_;
};

} // namespace isomotion::topology
