// What rays of each kind took, and which of them gave up.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace isomotion::render {

// Eye rays; those from what is seen to the lights; mirrored and refracted ones; and the samples
// that tell how open a place is.
enum class RayKind { eye, shadow, path, occlusion };
inline constexpr std::array<std::string_view, 4> ray_kind_names{"eye", "shadow", "path",
                                                                "occlusion"};

struct RayCount {
    std::int64_t evaluations = 0; // of the field
    std::int64_t most = 0;        // of these, for one pixel of one picture
    std::int64_t undecided = 0;   // rays that reached their limit; but for shadows, also NaN
    int column = 0, row = 0;      // of one pixel with such a ray, if there is any
};
using RayCounts = std::array<RayCount, ray_kind_names.size()>; // by RayKind

void add(const RayCounts& from, RayCounts& to);

// Of all kinds together.
std::int64_t evaluations(const RayCounts& of);

// One of the counts, by kind.
std::array<std::int64_t, ray_kind_names.size()> each(const RayCounts& of,
                                                     std::int64_t RayCount::*count);

// "eye 2.1 a pixel, at most 60; shadow 0.4, at most 212, 3 rays undecided". Kinds without any
// evaluation are left out.
std::string words(const RayCounts& counts, std::int64_t pixels);

} // namespace isomotion::render
