#include "topology/betti/separable_frame.h"

#include <algorithm>
#include <vector>

#include "topology/betti/sign_grid.h"
#include "topology/field/separable.h"

namespace isomotion::topology {
namespace {

using formula::Interval;

constexpr std::size_t most_levels = 1025; // of a grid along each axis

// The values of a term at both ends of a span and where it turns; it is monotone in between. None
// if that can't be proved.
std::vector<Interval> levels(Term& term, Interval span) {
    const auto turns = stationary_points(term, span);
    if (!turns || turns->size() + 2 > most_levels) return {};
    std::vector<Interval> levels{term.over(Interval(span.lo)).value};
    for (const Root& turn : *turns) {
        if (!(span.lo < turn.where.lo && turn.where.hi < span.hi)) return {};
        levels.push_back(term.over(turn.where).value);
    }
    levels.push_back(term.over(Interval(span.hi)).value);
    return levels;
}

} // namespace

CertifiedFrame certify_separable(const SpaceFormula& formula, const scene::BoundsAt& bounds) {
    CertifiedFrame frame;
    frame.why = not_settled;
    if (bounds.shape != scene::Bounds::Shape::box) return frame;
    formula::Graph graph = formula.graph;
    const auto terms = separated(graph, formula.root, 3);
    if (!terms) return frame;
    std::array<std::vector<Interval>, 3> along;
    std::size_t side = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Term term(graph, (*terms)[axis], axis, formula.bindings);
        along[axis] = levels(term, {bounds.min[int(axis)], bounds.max[int(axis)]});
        if (along[axis].empty()) return frame;
        side = std::max(side, along[axis].size());
    }
    // The grid is as long as the longest of its sides: beyond the others there is no solid.
    SignGrid grid{int(side)};
    for (std::size_t z = 0; z < along[2].size(); ++z) {
        for (std::size_t y = 0; y < along[1].size(); ++y) {
            const Interval both = along[1][y] + along[2][z];
            for (std::size_t x = 0; x < along[0].size(); ++x) {
                const Interval f = along[0][x] + both;
                if (contains(f, 0.0)) return frame;
                const bool is_solid = (f.hi < 0) == (formula.solid == Side::negative);
                if (is_solid) grid.set(int(x), int(y), int(z));
            }
        }
    }
    frame.boxes = int(side);
    frame.betti = betti(grid);
    frame.why.clear();
    return frame;
}

} // namespace isomotion::topology
