#include "elements/grid_maker.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/workers.h"
#include "elements/element_terms.h"
#include "elements/least_in_cells.h"
#include "elements/tolerance.h"

namespace isomotion::elements {
namespace {

constexpr int together = 1024; // elements that one thread takes at a time

// The sizes of the level sets of some elements, taken evenly out of all; infinite for a set without
// bounds.
std::vector<double> some_sizes(const ElementTerms& terms, std::span<const double> tolerance) {
    constexpr int asked = 16;
    std::vector<LevelSet> sets(std::size_t(terms.quadrics()));
    std::vector<double> sizes;
    for (int k = 0; k < std::min(asked, terms.count()); ++k) {
        const int element = int(std::int64_t(k) * terms.count() / asked);
        terms.level_sets(tolerance, element, element + 1, sets);
        double sum = 0;
        for (const LevelSet& set : sets) {
            if (set.kind == LevelSet::Kind::unbounded)
                sum = std::numeric_limits<double>::infinity();
            for (int axis = 0; axis < 3; ++axis) sum += set.is_flat[axis] ? 0 : set.half[axis];
        }
        sizes.push_back(sum);
    }
    return sizes;
}

// How many times as large they are by one tolerance as by another, in the mean: each counts as
// much as any other, however large.
double times_as_large(std::span<const double> by_one, std::span<const double> by_other) {
    double sum = 0, count = 0;
    for (std::size_t k = 0; k < by_one.size(); ++k) {
        if (by_other[k] == 0 && by_one[k] == 0) continue;
        sum += std::isinf(by_other[k]) ? 1 : by_one[k] / by_other[k];
        count += 1;
    }
    return count > 0 ? sum / count : 1;
}

// What the largest term of each sum can be; from 0 on where none is negative.
std::vector<Interval> units_of(const ElementTerms& terms) {
    std::vector<Interval> units;
    for (int k = 0; k < terms.sums(); ++k) {
        const Interval term = terms.bounds(k, 0);
        units.emplace_back(term.lo >= 0 ? 0.0 : -magnitude(term), magnitude(term));
    }
    return units;
}

// Multiples of them; 0 where they have no bounds.
std::vector<double> times(const std::vector<Interval>& units, auto&& multiple) {
    const bool are_finite =
        std::ranges::all_of(units, [](const Interval& u) { return u.hi > 0 && u.hi < 1e300; });
    const double factor = are_finite ? multiple() : 0.0;
    std::vector<double> sizes;
    sizes.reserve(units.size());
    for (const Interval& unit : units) sizes.push_back(factor > 0 ? factor * unit.hi : 0);
    return sizes;
}

} // namespace

// Leaves nothing out where terms are 0 beyond a support.
Tolerances GridMaker::choose(const ElementTerms& terms, std::vector<double> little,
                             const Region& region) {
    constexpr double support_at_most = 1.5; // times the size where little is left out
    const std::vector<double> nothing(std::size_t(terms.sums()), 0.0);
    Tolerances exact{nothing, nothing};
    for (double& size : little) size *= part_left_out;
    if (std::ranges::all_of(little, [](double a) { return a == 0; })) return exact;
    if (times_as_large(some_sizes(terms, nothing), some_sizes(terms, little)) <= support_at_most)
        return exact;
    const double widest = glm::length(region.high - region.low);
    return tolerances(terms, little, widest);
}

std::optional<GridMaker> GridMaker::of(const formula::Field& field, int array) {
    auto kernels = formula::element_kernels(field, array);
    if (!kernels) return std::nullopt;
    return GridMaker(field, std::move(*kernels));
}

GridMaker::GridMaker(const formula::Field& field, formula::ElementKernels kernels)
    : kernels_(std::move(kernels))
    , roots_(field, kernels_.array) {
    if (kernels_.is_least) least_.emplace(field, kernels_.array);
}

// Elements are known out to a little beyond where they matter: F has its slopes around its roots.
float GridMaker::least_left_out(const LeastAtRoots& at_roots, const ElementTerms& terms,
                                const formula::Bindings<float>& bindings, const Region& region,
                                RootFree& root_free) const {
    constexpr double beyond = 1.5; // times the size where elements matter
    constexpr int halvings = 10;
    const float none = formula::Operations<float>::least_of_none();
    const Interval range = terms.bounds(0, 0);
    const auto enough = at_roots.enough(bindings, region, range);
    if (!enough) return none;
    const std::vector<double> enough_sizes = some_sizes(terms, {&*enough, 1});
    const auto grown = [&](double key) {
        return times_as_large(some_sizes(terms, {&key, 1}), enough_sizes);
    };
    double low = *enough - range.lo, high = range.hi - range.lo;
    for (int k = 0; k < halvings && low < high; ++k) {
        const double middle = std::sqrt(low * high);
        (grown(range.lo + middle) <= beyond ? low : high) = middle;
    }
    const double least = range.lo + low;
    const Interval above(*enough, formula::infinity);
    if (roots_.exclude(bindings, region, {&above, 1})) {
        root_free.at_least = *enough;
        root_free.is_emptiness = true;
    }
    // Rounded up, within what there is.
    return std::min(std::nextafter(float(std::clamp(least, -double(none), double(none))), none),
                    none);
}

// What sums, or the least key, tell of roots; left_out as of all terms.
RootFree GridMaker::root_free(const ElementTerms& terms, const formula::Bindings<float>& bindings,
                              const Region& region, Tolerances& left_out) const {
    RootFree free{.quadric_of = kernels_.quadric_of};
    if (least_) {
        free.at_most = {0};
        free.at_least = formula::infinity;
        free.least = least_left_out(*least_, terms, bindings, region, free);
        left_out = {{double(free.least)}, {0}};
        free.left_out = {Interval(0.0)};
    } else {
        const std::vector<Interval> units = units_of(terms);
        free.at_most = times(units, [&] { return roots_.least(bindings, region, units); });
        // How large sums are where little is left out of them.
        std::vector<double> at_roots = free.at_most;
        if (std::ranges::all_of(at_roots, [](double size) { return size == 0; }))
            at_roots = times(units, [&] { return roots_.sensitivity(bindings, region, units); });
        left_out = choose(terms, std::move(at_roots), region);
        for (std::size_t k = 0; k < units.size(); ++k) {
            free.signs.emplace_back(units[k].lo < 0 ? -1.0 : 0.0, 1.0);
            free.left_out.push_back(free.signs[k] * Interval(0.0, left_out.of_sum[k]));
        }
        free.is_emptiness = roots_.exclude(bindings, region, free.left_out);
    }
    for (std::size_t k = 0; k < left_out.of_sum.size(); ++k) free.at_most[k] -= left_out.of_sum[k];
    if (roots_.depend_on_place()) {
        free.roots = &roots_;
        free.bindings = &bindings;
    }
    return free;
}

// The elements' terms are gone when their lists are made, unless some sets are boxes or a least is
// looked for.
GridMaker::Measured GridMaker::measure(const formula::Bindings<float>& bindings,
                                       const Region& region, int threads) const {
    auto owned = std::make_unique<const ElementTerms>(kernels_, bindings, region, threads);
    const ElementTerms& terms = *owned;
    Measured found;
    found.root_free = root_free(terms, bindings, region, found.left_out);
    const std::size_t each = std::size_t(terms.quadrics()),
                      of_sizes = std::size_t(terms.sums()) * ElementTerms::shells,
                      elements = std::size_t(terms.count());
    found.sets.resize(elements * each);
    found.sizes.resize(elements * of_sizes);
    const std::size_t turns = (elements + together - 1) / together;
    base::share({turns, threads}, [&] {
        return [&](std::size_t turn) {
            const std::size_t first = turn * together;
            const std::size_t count = std::min(std::size_t(together), elements - first);
            const auto own = std::span(found.sets).subspan(first * each, count * each);
            const int begin = int(first), end = int(first + count);
            terms.level_sets(found.left_out.of_term, begin, end, own);
            terms.sizes(own, begin, end,
                        std::span(found.sizes).subspan(first * of_sizes, count * of_sizes));
        };
    });
    found.root_free.sizes = found.sizes;
    const bool any_box = std::ranges::any_of(found.sets, &LevelSet::is_box);
    if (any_box || terms.is_least()) found.terms = std::move(owned);
    if (any_box) {
        found.root_free.terms = found.terms.get();
        found.root_free.tolerance = found.left_out.of_term;
    }
    return found;
}

ElementGrid GridMaker::make(const formula::Bindings<float>& bindings, const Region& region,
                            const GridLimits& limits) const {
    const Measured measured = measure(bindings, region, limits.threads);
    ElementGrid grid =
        make_grid(region, measured.sets, kernels_.quadrics, measured.root_free, limits);
    grid.array = array();
    grid.left_out = measured.left_out.of_sum;
    if (kernels_.is_least) {
        grid.least = measured.root_free.least;
        keep_possible_least(grid, region, *measured.terms, flat_axes(measured.sets), limits);
    }
    return grid;
}

} // namespace isomotion::elements
