// Choices that join smoothly, written so that their pieces show it.
//
// Blends of two bodies are made of min, max and abs, but are smooth where the bodies melt together.
// At a kink that isn't one, critical points have no place: the slopes on both sides are the same,
// so the equations of the kink (kinks.h) are degenerate there.
#pragma once

#include <optional>
#include <vector>

#include "topology/field/difference.h"
#include "topology/field/motion.h"

namespace isomotion::topology {

// An expression, and another that equals it on paper, with narrower bounds.
struct Narrower {
    formula::NodeId than = 0, is = 0;
};

// The motion's field with b + t*(a - b) - k*t*(1 - t) for smoothmin(a, b, k), where t goes from 0
// to 1 while b - a goes from -k to k: its pieces have the same slopes where they meet. As it is
// written it's the least of a blend, a and b, which touch there. Only where k is above 0 at all
// times of the clock. `narrower` takes what the pieces are better written as.
formula::NodeId with_blends_in_pieces(formula::Graph& graph, const Motion& motion,
                                      std::vector<Narrower>& narrower);

// `root` without |first - second|, if it is a polynomial of that with even powers only. So are
// min(a, b) - (k - |a - b|)^2/(4*k) and others that melt from min(a, b). `fixed`: values of
// parameters. The graph folds exactly.
std::optional<formula::NodeId> without_even_height(formula::Graph& graph, formula::NodeId root,
                                                   const Difference& height,
                                                   const std::vector<formula::Interval>& fixed);

} // namespace isomotion::topology
