#include "methods/growth.h"

#include <fmt/format.h>

namespace isomotion::bench {
namespace {

void add(std::vector<Growth>& grown, gpu::Context& context, const Growth& what, Subject subject,
         std::span<const scene::Method> methods, int repeat) {
    const Certified on = uncertified(std::move(subject), what.size);
    const scene::Isolation& own = on.subject.scene.surfaces[0].isolation;
    std::vector<Entrant> entrants;
    for (const scene::Method method : methods) {
        entrants.push_back({&on, {method, own.step, 1, own.bisections}});
    }
    const std::vector<Timing> timings = race(context, entrants, repeat);
    const auto meeting = double(rays(on));
    for (std::size_t k = 0; k < methods.size(); ++k) {
        grown.push_back(what);
        grown.back().method = methods[k];
        grown.back().timing = timings[k];
        grown.back().rays = meeting;
        // Sums go by lists: how many elements an evaluation takes is not known.
        if (timings[k].refused.empty() && on.subject.scene.surfaces[0].animation.counts().empty())
            grown.back().operations = operations(on.subject.scene, methods[k]);
    }
}

} // namespace

std::vector<Growth> by_resolution(gpu::Context& context, const std::vector<std::string>& surfaces,
                                  std::span<const int> sizes,
                                  std::span<const scene::Method> methods, int repeat,
                                  const Tell& tell) {
    std::vector<Growth> grown;
    for (const std::string& name : surfaces) {
        for (const int size : sizes) {
            tell(fmt::format("{} at {}x{}", name, size, size));
            add(grown, context, {"resolution", name, size, size, {}, {}, 0, 0}, surface(name),
                methods, repeat);
        }
    }
    return grown;
}

std::vector<Growth> by_degree(gpu::Context& context, int size, std::span<const int> degrees,
                              std::span<const scene::Method> methods, int repeat,
                              const Tell& tell) {
    std::vector<Growth> grown;
    for (const int degree : degrees) {
        tell(fmt::format("degree {} at {}x{}", degree, size, size));
        add(grown, context, {"degree", "Chmutov", size, degree, {}, {}, 0, 0},
            surface(fmt::format("chmutov_{}", degree)), methods, repeat);
    }
    return grown;
}

std::vector<Growth> by_lights(gpu::Context& context, int size, std::span<const int> counts,
                              std::span<const scene::Method> methods, int repeat,
                              const Tell& tell) {
    std::vector<Growth> grown;
    for (const int count : counts) {
        tell(fmt::format("{} lights at {}x{}", count, size, size));
        add(grown, context, {"lights", "tangle", size, count, {}, {}, 0, 0}, lit("tangle", count),
            methods, repeat);
    }
    return grown;
}

std::vector<Growth> by_blobs(gpu::Context& context, int size, std::span<const int> counts,
                             std::span<const scene::Method> methods, int repeat, const Tell& tell) {
    std::vector<Growth> grown;
    for (const int count : counts) {
        tell(fmt::format("{} blobs at {}x{}", count, size, size));
        add(grown, context, {"blobs", "blobs", size, count, {}, {}, 0, 0}, blobs(count), methods,
            repeat);
    }
    return grown;
}

} // namespace isomotion::bench
