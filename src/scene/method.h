// The methods that find the first root along a ray, one row of traits each. A method consists of
// its row here and its files of shaders/march/.
#pragma once

#include <optional>
#include <string_view>

namespace isomotion::scene {

enum class Method {
    marching,   // uniform steps, sign test
    amp_sign,   // adaptive steps (Singh & Narayanan 2010, Eq. 2), sign test
    amp_taylor, // adaptive steps, Taylor test (Eq. 3): sees touching roots too
    hermite,    // steps and tests by cubics with an estimated error
    interval,   // pieces with bounds on F and dF/dt (after Knoll et al. 2009)
    affine,     // pieces with F in the middle and bounds on dF/dt: first order, interval Newton
    sphere,     // steps by |F| and bounds on dF/dt (Hart 1996, Galin et al. 2020)
};

// What decides the distance from a sample to the next one.
enum class Steps {
    scene_step, // a length that the scene gives, adapted to F or not
    cubics,     // the estimated error of a cubic
    bounds,     // bounds on F and dF/dt over pieces of the ray, by interval arithmetic
};

// What one step of the march evaluates of the field.
enum class Samples { value, directional, value_and_bounds };

struct MethodTraits {
    Method method;
    std::string_view name;
    std::string_view summary;
    Steps steps;
    Samples samples;
    int state_textures; // textures that hold a ray's state between passes
};

inline constexpr MethodTraits method_traits[] = {
    {Method::marching,
     "marching",
     "uniform steps; a root where the sign changes",
     Steps::scene_step,
     Samples::value,
     2},
    {Method::amp_sign,
     "amp-sign",
     "steps adapted to |F| and |dF/dt| (the paper's Eq. 2); a root where the sign changes",
     Steps::scene_step,
     Samples::directional,
     2},
    {Method::amp_taylor,
     "amp-taylor",
     "the same steps; a root where values or linear extensions enclose 0 (Eq. 3)",
     Steps::scene_step,
     Samples::directional,
     2},
    {Method::hermite,
     "hermite",
     "cubics with an error estimate: steps as long as it allows",
     Steps::cubics,
     Samples::directional,
     3},
    {Method::interval,
     "interval",
     "proofs: pieces halved until bounds on F and dF/dt decide",
     Steps::bounds,
     Samples::value_and_bounds,
     2},
    {Method::affine,
     "affine",
     "proofs: the same with F in a piece's middle and bounds on dF/dt",
     Steps::bounds,
     Samples::value_and_bounds,
     2},
    {Method::sphere,
     "sphere",
     "proofs: steps of |F| over the steepest dF/dt ahead",
     Steps::bounds,
     Samples::value_and_bounds,
     2},
};

constexpr const MethodTraits& traits(Method method) {
    for (const auto& entry : method_traits) {
        if (entry.method == method) return entry;
    }
    return method_traits[0];
}

constexpr std::string_view name(Method method) { return traits(method).name; }

// Whether the scene's step decides where the ray is sampled.
constexpr bool takes_steps(Method method) { return traits(method).steps == Steps::scene_step; }

constexpr std::optional<Method> parse_method(std::string_view text) {
    for (const auto& entry : method_traits) {
        if (entry.name == text) return entry.method;
    }
    return std::nullopt;
}

} // namespace isomotion::scene
