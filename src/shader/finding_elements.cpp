#include "shader/finding_elements.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>
#include <vector>

#include "formula/element_kernels.h"
#include "formula/linear_sum.h"
#include "shader/assemble.h"
#include "shader/beam_text.h"
#include "shader/effect.h"

namespace isomotion::shader {
namespace {

// Where nothing is known of how crowded elements are: with more than these a grid finds those that
// matter faster than beams do.
constexpr int most_by_lists = 500;
// The same in GLSL ES where beams keep neither lists nor bits: with more elements than these, a
// grid is faster than beams that go through all.
constexpr int most_in_beams_of_a_page = 24;

// Whether rays ask for bounds of F over pieces of them.
bool goes_by_bounds(const scene::OneSurface& one) {
    switch (one.surface.isolation.method) {
    case scene::Method::interval:
    case scene::Method::affine:
    case scene::Method::sphere:
        return true;
    case scene::Method::hermite:
        return !one.surface.measured.smoothness.is_smooth();
    default:
        return false;
    }
}

// The array with the most elements, if its sums' terms are kernels of a distance and looking for
// them pays. A scene that calls beams off looks at all elements, and so do the paper's methods, as
// far as a shader can.
std::optional<int> array_to_find_by_place(const scene::OneSurface& one, std::span<const int> counts,
                                          Platform platform) {
    constexpr int fewest_on_desktops = 64, most_in_a_shader = 20'000;
    const int fewest = platform == Platform::webgl ? most_in_beams_of_a_page : fewest_on_desktops;
    if (counts.empty()) return std::nullopt;
    const int array = int(std::ranges::max_element(counts) - counts.begin());
    const int count = counts[std::size_t(array)];
    const bool looks_at_all = one.surface.isolation.beam == false;
    const bool is_hermite = one.surface.isolation.method == scene::Method::hermite;
    // Bounds over a box take all other arrays in each of its cells, of which a draw has
    // MOST_ELEMENTS at most (field_text.cpp): proofs come to boxes of two cells, marches by bounds
    // need some eight.
    constexpr int most_of_others = 2000, most_by_bounds = 500;
    const int others = std::accumulate(counts.begin(), counts.end(), 0) - count;
    if (others > most_of_others && one.surface.isolation.certify) return std::nullopt;
    if (others > most_by_bounds && goes_by_bounds(one)) return std::nullopt;
    const int from = looks_at_all ? most_in_a_shader : is_hermite ? fewest : most_by_lists;
    if (count <= from || !formula::element_kernels(*one.surface.field, array)) return std::nullopt;
    return array;
}

// Whether beams may keep lists of array 0.
bool may_keep_lists(const scene::OneSurface& one, std::span<const int> counts) {
    // With more elements than most the loops of a beam's shader might end too soon (beam_text.cpp).
    // Bounds of noise have loops of their own.
    constexpr int fewest = 9, most = 15'000;
    const formula::Field& field = *one.surface.field;
    return uses_beams(one) && !counts.empty() && counts[0] >= fewest && counts[0] <= most &&
           formula::cost(field.value, counts).noises == 0 && formula::linear_sum(field).has_value();
}

// Pixels along a side from which on lists are faster; 0 if nothing is known of the crowd.
//
// A beam holds the elements along it, a cell those at a place, of which there are the fewer the
// smaller they are; but rays of a beam share its list, and looking up a cell takes as long as some
// ten elements. Where elements are crowded, they merge, and beams end early. Bounds are taken over
// boxes of several cells. The factors are from families of soft balls, 75 to 2000 of several sizes,
// in pictures of 64 to 512 pixels a side (tests/bench/lists_or_grid.py), in fragment shaders; the
// compute stage is for hardware, where none was measured.
double side_for_lists(const scene::OneSurface& one, int count, Stage stage) {
    if (!one.surface.measured.elements_at_a_place || one.surface.isolation.certify ||
        one.surface.isolation.method != scene::Method::hermite || stage != Stage::fragment)
        return 0;
    const double at_a_place = *one.surface.measured.elements_at_a_place;
    const double merging = std::min(1.0, 30 / at_a_place);
    return merging * count * (goes_by_bounds(one) ? 6 / (at_a_place + 3) : 41 / (at_a_place + 10));
}

bool is_faster_by_place(const scene::OneSurface& one, int count, const Drawing& drawing) {
    if (one.surface.isolation.beam == true) return false;
    const double side = drawing.pixels > 0 ? side_for_lists(one, count, drawing.stage) : 0;
    return side > 0 ? double(drawing.pixels) < side * side : count > most_by_lists;
}

} // namespace

FieldStorage storage_of_elements(const scene::OneSurface& one, const Drawing& drawing,
                                 bool keeps_copies) {
    const bool on_web = drawing.platform == Platform::webgl;
    const std::vector<int> counts = one.surface.animation.counts();
    const auto by_place = array_to_find_by_place(one, counts, drawing.platform);
    Finding finding;
    // Rays that begin on a surface have no beams there, and find elements faster by place.
    finding.by_copies = keeps_copies && on_web && !keeps_surfaces(one) &&
                        by_place.value_or(0) == 0 && !counts.empty() && counts[0] <= most_in_copies;
    const bool keeps_lists = (drawing.writes_buffers && !on_web) || finding.by_copies;
    finding.by_lists =
        keeps_lists && may_keep_lists(one, counts) &&
        !(by_place && is_faster_by_place(one, counts[std::size_t(*by_place)], drawing));
    if (!finding.by_lists) finding.by_place = by_place;
    return field_storage(*one.surface.field, one.surface.parameters, counts, finding);
}

FieldStorage storage_of_all_elements(const scene::OneSurface& one) {
    return field_storage(*one.surface.field, one.surface.parameters,
                         one.surface.animation.counts());
}

std::vector<std::int64_t> sizes_of_change(const scene::Scene& scene, const Drawing& drawing) {
    std::vector<std::int64_t> sizes;
    if (!drawing.writes_buffers || drawing.platform == Platform::webgl) return sizes;
    for (std::size_t k = 0; k < scene.surfaces.size(); ++k) {
        const scene::OneSurface one(scene, k);
        const std::vector<int> counts = one.surface.animation.counts();
        const auto by_place = array_to_find_by_place(one, counts, drawing.platform);
        if (!by_place || one.surface.isolation.beam == true || !may_keep_lists(one, counts))
            continue;
        const double side = side_for_lists(one, counts[std::size_t(*by_place)], drawing.stage);
        if (side > 0) sizes.push_back(std::int64_t(std::ceil(side * side)));
    }
    return sizes;
}

} // namespace isomotion::shader
