#include "scene/near_elements.h"

#include <algorithm>
#include <thread>

namespace isomotion::scene {

elements::Region region_of_elements(const BoundsAt& bounds) {
    const glm::dvec3 margin(0x1p-12 * bounds.radius);
    return {bounds.min - margin, bounds.max + margin};
}
namespace {

constexpr int fewest_to_find = 200; // elements, so that finding them pays

} // namespace

ElementFinder::ElementFinder(const OneSurface& one) {
    const auto& arrays = one.surface.animation.arrays();
    if (arrays.empty()) return;
    const auto most = std::ranges::max_element(arrays, {}, &animation::Array::count);
    if (most->count < fewest_to_find) return;
    maker_ = elements::GridMaker::of(*one.surface.field, int(most - arrays.begin()));
}

std::optional<int> ElementFinder::array() const {
    return maker_ ? std::optional(maker_->array()) : std::nullopt;
}

NearElements::NearElements(const ElementFinder& finder, const SurfaceAt& now)
    : all_(formula::convert<double>(now.bindings)) {
    if (!finder.maker_) return;
    array_ = std::size_t(finder.maker_->array());
    elements::GridLimits limits;
    limits.threads = std::max(1, int(std::thread::hardware_concurrency())); // decides nothing
    grid_ = finder.maker_->make(now.bindings, {now.bounds.min, now.bounds.max}, limits);
    near_ = all_;
}

const formula::Bindings<double>& NearElements::at(const glm::dvec3& p) {
    if (!grid_) return all_;
    const elements::Cell& cell = grid_->at(grid_->place(p));
    if (&cell == cell_) return near_;
    cell_ = &cell;
    const auto& from = all_.arrays[array_];
    auto& to = near_.arrays[array_];
    const auto list = grid_->list(cell);
    to.count = int(list.size());
    for (std::size_t f = 0; f < from.fields.size(); ++f) {
        if (from.fields[f].empty()) continue; // nobody reads it
        to.fields[f].clear();
        for (const std::uint32_t element : list) to.fields[f].push_back(from.fields[f][element]);
    }
    return near_;
}

std::vector<int> NearElements::usual_counts() const {
    std::vector<int> counts = all_.counts();
    if (!grid_) return counts;
    counts[array_] = grid_->usual_count();
    return counts;
}

} // namespace isomotion::scene
