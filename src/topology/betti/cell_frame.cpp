#include "topology/betti/cell_frame.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "topology/betti/cell_complex.h"
#include "topology/field/pieces.h"
#include "topology/field/rising.h"

namespace isomotion::topology {
namespace {

using formula::Interval;

// There is no other proof of a formula with kinks, nor of a surface that reaches a sphere.
constexpr std::size_t most_cells = 100'000, most_cells_without_other_proof = 400'000;

// The places of cells. What is symmetric or has round numbers would touch faces of equal cells:
// sides are divided a little off the middle. If the bounds are a sphere, the cells fill a box that
// it doesn't touch.
class CellPlaces {
public:
    explicit CellPlaces(const scene::BoundsAt& bounds)
        : bounds_(bounds) {
        constexpr double margin = 0x1p-6;
        if (!is_sphere()) return;
        bounds_.min -= margin * bounds.radius;
        bounds_.max += margin * bounds.radius;
    }

    SpaceBox box(const CellKey& key) const {
        SpaceBox box;
        for (std::size_t k = 0; k < 3; ++k) box[k] = {place(k, key.at[k]), place(k, key.end(k))};
        return box;
    }

    // Whether a place is outside of the bounds, or inside of them, if these are a sphere. The
    // sphere itself is outside.
    bool is_outside(const SpaceBox& box) const {
        return is_sphere() && squared_distance(box).lo >= squared_radius().hi;
    }
    bool is_inside(const SpaceBox& box) const {
        return !is_sphere() || squared_distance(box).hi < squared_radius().lo;
    }
    // The slopes of the squared distance from the sphere's centre.
    Box outwards(const SpaceBox& box) const {
        Box slopes{};
        for (std::size_t k = 0; k < 3; ++k)
            slopes[k] = Interval(2) * (box[k] - Interval(bounds_.centre[int(k)]));
        return slopes;
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

    scene::BoundsAt bounds_;
};

double length_of_middle(const Box& gradient) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += mid(gradient[k]) * mid(gradient[k]);
    return std::sqrt(sum);
}

// Slopes in a unit like that of the others: a direction is sought from all of them.
Box alike(Box slopes, std::span<const Box> others) {
    double sum = 0;
    for (const Box& other : others) sum += length_of_middle(other);
    const double scale = sum / (double(others.size()) * length_of_middle(slopes));
    if (!(scale > 0) || !std::isfinite(scale)) return slopes;
    for (std::size_t k = 0; k < 3; ++k) slopes[k] = Interval(scale) * slopes[k];
    return slopes;
}

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

// The solid in cells: where G < 0 inside of the bounds. For a sphere that is where the greater one
// of G and h, the squared distance from its centre less its radius squared, is negative.
class SolidInCells {
public:
    SolidInCells(const SpaceFormula& formula, const scene::BoundsAt& bounds)
        : pieces_(formula)
        , places_(bounds)
        , near_(pieces_, places_) {}

    CellFact fact(const CellKey& key);

    SpaceBox box(const CellKey& key) const { return places_.box(key); }
    bool has_kinks() const { return pieces_.has_kinks(); }
    bool may_reach_sphere() const { return may_reach_sphere_; } // in a cell that was asked for

private:
    using Kind = CellFact::Kind;
    using Sign = Pieces::Sign;

    Pieces::Over over(const CellKey& key, const SpaceBox& box);

    Pieces pieces_;
    CellPlaces places_;
    NearElements near_;
    bool may_reach_sphere_ = false;
};

Pieces::Over SolidInCells::over(const CellKey& key, const SpaceBox& box) {
    Pieces::Over over = pieces_.over(box, near_.of(key));
    // What is left out of sums blurs where the surface nearly touches a small face or edge.
    const bool is_blurred = key.dimension() < 3 && key.level > 9 && !pieces_.has_kinks() &&
                            over.sign == Sign::mixed &&
                            !rising_direction(over.gradients, axes_of(key));
    return is_blurred ? pieces_.over(box, pieces_.everything()) : over;
}

CellFact SolidInCells::fact(const CellKey& key) {
    const SpaceBox box = places_.box(key);
    const CellFact outside{.kind = Kind::outside, .holds_of_closed_cell = true};
    const CellFact inside{.kind = Kind::inside, .holds_of_closed_cell = true};
    if (places_.is_outside(box)) return outside;
    const bool is_inside = places_.is_inside(box);
    if (key.axes == 0) {
        const Interval value = pieces_.value(box);
        if (value.lo >= 0) return outside;
        return value.hi < 0 && is_inside ? inside : CellFact{};
    }
    Pieces::Over over = this->over(key, box);
    if (over.sign == Sign::positive) return outside;
    if (over.sign == Sign::negative) {
        if (is_inside) return inside;
        over.gradients.clear();
    } else if (over.gradients.empty()) {
        return {};
    }
    if (!is_inside) {
        may_reach_sphere_ = true;
        over.gradients.push_back(alike(places_.outwards(box), over.gradients));
    }
    CellFact fact;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto rises = [&](const Box& g) { return g[k].lo > 0; };
        const auto falls = [&](const Box& g) { return g[k].hi < 0; };
        if (std::ranges::all_of(over.gradients, rises)) fact.sinks_along[k] = -1;
        if (std::ranges::all_of(over.gradients, falls)) fact.sinks_along[k] = 1;
    }
    const auto direction = rising_direction(over.gradients, axes_of(key));
    if (!direction) return fact;
    fact.kind = Kind::sinking;
    for (std::size_t k = 0; k < 3; ++k)
        fact.sinks_to[k] = (*direction)[k] > 0 ? -1 : (*direction)[k] < 0 ? 1 : 0;
    return fact;
}

} // namespace

CertifiedFrame certify_by_cells(const SpaceFormula& formula, const scene::BoundsAt& bounds,
                                const FrameLimits& limits) {
    SolidInCells solid(formula, bounds);
    CellComplex complex([&](const CellKey& key) { return solid.fact(key); });
    std::size_t most = 0;
    const auto count = [&](std::size_t cells) {
        most = std::min(cells, limits.cells);
        return complex.betti({.cells = most, .stopped = limits.stopped});
    };
    const auto has_other_proof = [&] { return !solid.has_kinks() && !solid.may_reach_sphere(); };
    CertifiedFrame frame;
    frame.betti = count(solid.has_kinks() ? most_cells_without_other_proof : most_cells);
    if (!frame.betti && complex.known() > most && !has_other_proof())
        frame.betti = count(most_cells_without_other_proof);
    frame.depth = complex.depth();
    frame.boxes = int(complex.known());
    frame.is_by_cells = true;
    if (frame.betti) return frame;
    frame.why = limits.stopped && limits.stopped() ? "interrupted"
                : complex.known() > most           ? too_many_boxes
                                                   : not_settled;
    frame.where = solid.box(complex.failed());
    return frame;
}

} // namespace isomotion::topology
