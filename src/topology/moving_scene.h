// A scene's surface at one time or over a short span of time, with exact values. Proofs of frames
// and kinds use it.
#pragma once

#include "scene/scene_at.h"
#include "topology/betti/certified_frame.h"
#include "topology/classify/field_snapshot.h"
#include "topology/classify/kinds.h"
#include "topology/field/timed_formula.h"

namespace isomotion::topology {

class MovingScene {
public:
    MovingScene(const scene::OneSurface& one, Side solid, formula::Interval range);
    // Motions by time.
    explicit MovingScene(const Motions& all);

    struct Still {
        SpaceFormula formula;
        scene::BoundsAt bounds; // rounded
    };
    // The time must lie between two knots of the animation, or be the end of the range, where
    // values are those after a jump, as drawn.
    Still at(formula::Interval time) const;

    // Fails outside of the range.
    CertifiedFrame certify(double time, const FrameLimits& limits = {}) const;
    // Proofs for the kinds of these events, ordered by time. The proofs keep a reference to this
    // scene.
    KindProofs proofs(std::vector<Event> events, const PathOptions& seeking = {},
                      const FrameLimits& limits = {}) const;

private:
    const TimedFormula& piece_at(formula::Interval time) const;

    std::vector<TimedFormula> pieces_;
    std::optional<TimedFormula> at_end_;
};

} // namespace isomotion::topology
