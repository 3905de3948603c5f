// What methods cost as a picture or a sum grows.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "methods/contest.h"

namespace isomotion::bench {

struct Growth {
    std::string kind; // "resolution" or "blobs": what `at` counts
    std::string subject;
    int size = 0; // pixels a side
    int at = 0;
    scene::Method method;
    Timing timing;
    double rays = 0; // that meet the bounds

    double ns_a_ray() const { return 1e6 * timing.ms / rays; }
    double evaluations_a_ray() const { return timing.evaluations / rays; }
};

using Tell = std::function<void(const std::string& what)>;

// Each surface at each size; time only, at the surface's step.
std::vector<Growth> by_resolution(gpu::Context& context, const std::vector<std::string>& surfaces,
                                  std::span<const int> sizes,
                                  std::span<const scene::Method> methods, int repeat,
                                  const Tell& tell);

// The same picture of more and smaller blobs (see blobs()).
std::vector<Growth> by_blobs(gpu::Context& context, int size, std::span<const int> counts,
                             std::span<const scene::Method> methods, int repeat, const Tell& tell);

} // namespace isomotion::bench
