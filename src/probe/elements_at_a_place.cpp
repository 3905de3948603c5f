#include "probe/elements_at_a_place.h"

#include <algorithm>

#include "elements/grid_maker.h"
#include "scene/error.h"
#include "scene/near_elements.h"

namespace isomotion::probe {
namespace {

using scene::OneSurface, scene::SceneError, scene::SurfaceAt;

// With fewer elements all are gone through, with more they are always found by place.
constexpr int fewest = 65, most = 2000;
constexpr int frames_looked_at = 5;
constexpr double dear_frames = 1e6; // operations, of which one is looked at

double mean_of_cells(const elements::ElementGrid& grid) {
    double listed = 0, cells = 0;
    for (const elements::Cell& cell : grid.cells) {
        listed += cell.elements();
        cells += cell.elements() > 0;
    }
    return listed / std::max(cells, 1.0);
}

} // namespace

std::optional<double> elements_at_a_place(const OneSurface& one) {
    const std::vector<int> counts = one.surface.animation.counts();
    if (counts.empty()) return std::nullopt;
    const auto longest = std::ranges::max_element(counts);
    if (*longest < fewest || *longest > most) return std::nullopt;
    const auto maker = elements::GridMaker::of(*one.surface.field, int(longest - counts.begin()));
    if (!maker) return std::nullopt;
    double work = 0; // of the arrays' fields at a frame
    for (std::size_t a = 0; a < counts.size(); ++a) work += one.surface.animation.operations(a);
    const int frames =
        work > dear_frames ? 1 : std::min(one.scene.timeline.frames, frames_looked_at);
    double sum = 0;
    int looked_at = 0;
    for (int k = 0; k < frames; ++k) {
        const int frame =
            1 + int(std::int64_t(one.scene.timeline.frames - 1) * k / std::max(1, frames - 1));
        try {
            const SurfaceAt now = surface_at(one, one.scene.timeline.time(frame));
            sum += mean_of_cells(maker->make(now.bindings, region_of_elements(now.bounds), {}));
            ++looked_at;
        } catch (const SceneError&) { // said where the frame is drawn
        }
    }
    return looked_at > 0 ? std::optional(sum / looked_at) : std::nullopt;
}

} // namespace isomotion::probe
