#include "topology/betti/cell_frame.h"

#include <algorithm>
#include <map>

#include "topology/betti/cell_complex.h"
#include "topology/field/pieces.h"
#include "topology/field/rising.h"

namespace isomotion::topology {
namespace {

using formula::Interval;

// A formula with kinks has no other proof.
constexpr std::size_t most_cells = 100'000, most_cells_with_kinks = 400'000;

// Where the cells are. What is symmetric or has round numbers would touch faces of equal cells:
// sides are divided a little off the middle.
class CellPlaces {
public:
    explicit CellPlaces(const scene::BoundsAt& bounds)
        : bounds_(bounds) {}

    SpaceBox box(const CellKey& key) const {
        SpaceBox box;
        for (std::size_t k = 0; k < 3; ++k) box[k] = {place(k, key.at[k]), place(k, key.end(k))};
        return box;
    }

    // Places outside of and inside of the bounds, if these are a sphere.
    bool is_outside(const SpaceBox& box) const {
        return is_sphere() && squared_distance(box).lo > squared_radius().hi;
    }
    bool is_inside(const SpaceBox& box) const {
        return !is_sphere() || squared_distance(box).hi <= squared_radius().lo;
    }

private:
    // Ascending in `at`.
    double place(std::size_t axis, int at) const {
        constexpr std::array<double, 3> bends{0.0413, 0.0379, 0.0531};
        const int k = int(axis);
        if (at == 0) return bounds_.min[k];
        if (at == CellKey::whole) return bounds_.max[k];
        const double part = double(at) / CellKey::whole;
        const double bent = part + bends[axis] * part * (1 - part);
        return bounds_.min[k] + bent * (bounds_.max[k] - bounds_.min[k]);
    }
    bool is_sphere() const { return bounds_.shape == scene::Bounds::Shape::sphere; }
    Interval squared_radius() const { return formula::square(bounds_.radius); }
    Interval squared_distance(const SpaceBox& box) const {
        Interval sum = 0;
        for (std::size_t k = 0; k < 3; ++k)
            sum = sum + formula::square(box[k] - Interval(bounds_.centre[int(k)]));
        return sum;
    }

    const scene::BoundsAt& bounds_;
};

std::vector<std::size_t> axes_of(const CellKey& key) {
    std::vector<std::size_t> axes;
    for (std::size_t k = 0; k < 3; ++k) {
        if (key.is_along(k)) axes.push_back(k);
    }
    return axes;
}

// The elements that matter in a cell: those of the box that it is a facet of, which are among those
// of the box twice its size.
class NearElements {
public:
    NearElements(Pieces& pieces, const CellPlaces& places)
        : pieces_(pieces)
        , places_(places) {}

    const Elements& of(const CellKey& key) {
        if (pieces_.has_kinks() || key.level == 0) return pieces_.everything();
        CellKey around = key;
        around.axes = 7;
        for (int& at : around.at) at = std::min(at, CellKey::whole - 1) & ~(around.length() - 1);
        const auto [made, is_new] = known_.try_emplace({around.level, around.at});
        if (is_new) {
            CellKey twice = around;
            --twice.level;
            made->second = pieces_.nearer(of(twice), places_.box(around));
        }
        return made->second;
    }

private:
    Pieces& pieces_;
    const CellPlaces& places_;
    std::map<std::pair<int, std::array<int, 3>>, Elements> known_;
};

CellFact fact_of(Pieces& pieces, NearElements& near, const CellPlaces& places, const CellKey& key) {
    using Kind = CellFact::Kind;
    const SpaceBox box = places.box(key);
    if (places.is_outside(box)) return {Kind::outside, {}};
    if (key.axes == 0) {
        const Interval value = pieces.value(box);
        if (value.lo >= 0) return {Kind::outside, {}};
        // The solid must keep off a sphere.
        const bool is_inside = value.hi < 0 && places.is_inside(box);
        return {is_inside ? Kind::inside : Kind::unknown, {}};
    }
    Pieces::Over over = pieces.over(box, near.of(key));
    // What is left out of sums blurs where the surface nearly touches a small face or edge.
    const bool is_blurred = key.dimension() < 3 && key.level > 9 && !pieces.has_kinks() &&
                            over.sign == Pieces::Sign::mixed &&
                            !rising_direction(over.gradients, axes_of(key));
    if (is_blurred) over = pieces.over(box, pieces.everything());
    if (over.sign == Pieces::Sign::positive) return {Kind::outside, {}};
    if (!places.is_inside(box)) return {};
    if (over.sign == Pieces::Sign::negative) return {Kind::inside, {}};
    const auto direction = rising_direction(over.gradients, axes_of(key));
    if (!direction) return {};
    CellFact fact{Kind::sinking, {}};
    for (std::size_t k = 0; k < 3; ++k)
        fact.sinks_to[k] = (*direction)[k] > 0 ? -1 : (*direction)[k] < 0 ? 1 : 0;
    return fact;
}

} // namespace

CertifiedFrame certify_by_cells(const SpaceFormula& formula, const scene::BoundsAt& bounds,
                                const FrameLimits& limits) {
    Pieces pieces(formula);
    const CellPlaces places(bounds);
    NearElements near(pieces, places);
    CellComplex complex([&](const CellKey& key) { return fact_of(pieces, near, places, key); });
    CertifiedFrame frame;
    const std::size_t most = pieces.has_kinks() ? most_cells_with_kinks : most_cells;
    frame.betti = complex.betti({.cells = most, .stopped = limits.stopped});
    frame.depth = complex.depth();
    frame.boxes = int(complex.asked());
    if (frame.betti) return frame;
    frame.why = limits.stopped && limits.stopped() ? "interrupted"
                : complex.asked() > most           ? "too many boxes"
                                                   : "not settled at the greatest depth";
    frame.where = places.box(complex.failed());
    return frame;
}

} // namespace isomotion::topology
