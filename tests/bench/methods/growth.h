// What methods cost as a picture, a sum, a degree or the number of lights grows.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "methods/contest.h"

namespace isomotion::bench {

struct Growth {
    std::string kind; // "resolution", "blobs", "degree" or "lights": what `at` counts
    std::string subject;
    int size = 0; // pixels a side
    int at = 0;
    scene::Method method;
    Timing timing;
    double rays = 0;       // that meet the bounds
    double operations = 0; // of an evaluation of the field; 0: not known

    double ns_a_ray() const { return 1e6 * timing.ms / rays; }
    double evaluations_a_ray() const { return timing.evaluations / rays; }
    // What the field alone would take at so many operations a second.
    double least_ns_a_ray(double peak) const {
        return 1e9 * operations * evaluations_a_ray() / peak;
    }
};

using Tell = std::function<void(const std::string& what)>;

// Each surface at each size; time only, at the surface's step.
std::vector<Growth> by_resolution(gpu::Context& context, const std::vector<std::string>& surfaces,
                                  std::span<const int> sizes,
                                  std::span<const scene::Method> methods, int repeat,
                                  const Tell& tell);

// Chmutov's surfaces of these degrees, which the catalogue has; time only.
std::vector<Growth> by_degree(gpu::Context& context, int size, std::span<const int> degrees,
                              std::span<const scene::Method> methods, int repeat, const Tell& tell);

// A surface lit by so many lights, each of which casts shadows.
std::vector<Growth> by_lights(gpu::Context& context, int size, std::span<const int> counts,
                              std::span<const scene::Method> methods, int repeat, const Tell& tell);

// The same picture of more and smaller blobs (see blobs()).
std::vector<Growth> by_blobs(gpu::Context& context, int size, std::span<const int> counts,
                             std::span<const scene::Method> methods, int repeat, const Tell& tell);

} // namespace isomotion::bench
