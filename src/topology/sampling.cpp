#include "topology/sampling.h"

#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "topology/betti/frame_signs.h"

namespace isomotion::topology {
namespace {

// Beside F: components and loops of a grid, and fields of arrays.
constexpr double of_vertex = 8, of_value = 150, of_value_operation = 25;

double operations_of_values(const scene::OneSurface& one) {
    const animation::Animation& animation = one.surface.animation;
    double operations = of_value_operation * animation.operations();
    for (std::size_t a = 0; a < animation.arrays().size(); ++a)
        operations += of_value_operation * animation.operations(a) + of_value * animation.values(a);
    return operations;
}

// None where it takes more than `most` operations.
std::optional<Timeline> sampled_on(int grid, const scene::OneSurface& one, Side solid,
                                   const Sampling& sampling, double most) {
    const auto [first, last] = std::pair(sampling.first, sampling.last);
    Timeline timeline;
    timeline.range = {one.scene.timeline.time(first), one.scene.timeline.time(last)};
    timeline.doubts.push_back(
        fmt::format("nothing was proved: signs on a grid of {0}x{0}x{0}, frame by frame", grid));
    // The first frame tells soon where all are far too many.
    const int frames = last - first + 1;
    Work at_first(sampling.stopped, 2 * most / frames), later(sampling.stopped, most);
    const double beside = operations_of_values(one) + of_vertex * grid * grid * grid;
    if (beside * frames > most) return std::nullopt;
    const FrameSigns signs_of(*one.surface.field, one.surface.animation.counts());
    std::optional<Betti> before;
    double since = 0;
    for (int frame = first; frame <= last; ++frame) {
        Work& work = frame == first ? at_first : later;
        work.add(beside);
        if (work.is_over()) break;
        const scene::SurfaceAt now = scene::surface_at(one, one.scene.timeline.time(frame));
        const auto signs = signs_of.at(now, solid, grid, sampling.threads, work);
        if (!signs) break;
        // What some tenth of the frames took tells what all will take.
        const int done = frame - first + 1;
        if (done == frames / 10 && 0.9 * later.done() / done * frames > most) return std::nullopt;
        const Betti here = betti(*signs);
        if (before && *before != here) {
            std::array<formula::Interval, 3> where;
            for (int k = 0; k < 3; ++k)
                where[std::size_t(k)] = {now.bounds.min[k], now.bounds.max[k]};
            timeline.unresolved.push_back(
                {{since, now.values->time}, where, "these two frames differ", before, here});
        }
        if (!before) timeline.start = here;
        timeline.end = before = here;
        since = now.values->time;
        if (sampling.progress) sampling.progress(double(done) / frames);
    }
    if (at_first.is_too_much() || later.is_too_much()) return std::nullopt;
    if (at_first.is_over()) timeline.doubts.emplace_back("interrupted");
    return timeline;
}

} // namespace

Timeline sampled(const scene::OneSurface& one, Side solid, const Sampling& sampling) {
    const int finest = sampling.grid.value_or(64), coarsest = sampling.grid.value_or(16);
    const double most = sampling.grid ? HUGE_VAL : sampling.most_operations;
    for (int grid = finest; grid >= coarsest; grid /= 2) {
        if (auto timeline = sampled_on(grid, one, solid, sampling, most))
            return *std::move(timeline);
    }
    throw std::invalid_argument(fmt::format(
        "sampling frames {0} to {1} takes over {2:g} operations even on a grid of {3}x{3}x{3}: "
        "search fewer --frames at a time, or allow what it takes with --grid {3}",
        sampling.first, sampling.last, sampling.most_operations, coarsest));
}

} // namespace isomotion::topology
