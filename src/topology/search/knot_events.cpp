#include "topology/search/knot_events.h"

#include <algorithm>

#include "topology/search/critical_system.h"
#include "topology/search/morse.h"

namespace isomotion::topology {
namespace {

using formula::Interval;

// What is certain of the one critical point in a box, at all times of its clock.
struct Passing {
    int index = 0, rises = 0;
    bool changes_solid = true;
};

std::optional<Passing> passing(const KnotPoint& point, const Box& around) {
    const MovingField& field = *point.field;
    const std::size_t d = field.clock();
    Enclosures enclosures(field);
    Box middle = around;
    for (std::size_t k = 0; k < d; ++k) middle[k] = mid(around[k]);
    const Jet<Interval> jet = enclosures.jet(around), at_middle = enclosures.jet(middle);
    const auto y = middle_inverse(jet.hessian, int(d));
    if (!y) return std::nullopt;
    Point m{};
    for (std::size_t k = 0; k < d; ++k) m[k] = mid(around[k]);
    if (!krawczyk(around, m, at_middle.gradient, jet.hessian, *y, int(d)).is_inside)
        return std::nullopt;
    const auto index = negative_eigenvalues(jet.hessian, int(d));
    Passing sure;
    sure.rises = sign_of(jet.gradient[d]);
    if (!index || sure.rises == 0) return std::nullopt;
    sure.index = *index;
    if (enclosures.place(around) != Enclosures::Place::inside) return std::nullopt;
    for (const Interval& inward : enclosures.inward(around)) {
        if (sign_of(inward) == 0) return std::nullopt;
        sure.changes_solid &= inward.lo > 0;
    }
    return sure;
}

// The box around both, on the clock of one.
Box around(const KnotPoint& one, const KnotPoint& other, double margin) {
    const MovingField& field = *one.field;
    const std::size_t d = field.clock();
    Box box{};
    for (std::size_t k = 0; k < d; ++k) {
        const Interval both = hull(one.where[k], other.where[k]);
        const double by = margin * (field.domain()[k].hi - field.domain()[k].lo);
        box[k] = {both.lo - by, both.hi + by};
    }
    box[d] = hull(one.where[d], Interval(one.knot));
    return box;
}

} // namespace

std::optional<AtKnot> meet(const KnotPoint& before, const KnotPoint& after) {
    const int variables = before.field->variables(), dimension = before.field->dimension();
    const bool is_one_formula =
        before.part == after.part && before.field->stratum() == after.field->stratum() &&
        variables == after.field->variables() && before.index_across == after.index_across &&
        before.path == after.path;
    if (!is_one_formula) return std::nullopt;
    // Parts of the domain.
    for (const double margin : {1e-9, 1e-7, 1e-5}) {
        const auto a = passing(before, around(before, after, margin));
        if (!a) continue;
        const auto b = passing(after, around(after, before, margin));
        if (!b || a->index != b->index || a->changes_solid != b->changes_solid) continue;
        const int multipliers = variables - 1 - dimension;
        return AtKnot{a->index - multipliers + before.index_across, a->changes_solid,
                      a->rises == b->rises ? a->rises : 0};
    }
    return std::nullopt;
}

} // namespace isomotion::topology
