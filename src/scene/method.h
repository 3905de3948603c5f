// How the first root along a ray is found.
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
    chebyshev,  // the polynomial that F is along the ray, from its degree + 1 samples
};

struct MethodName {
    Method method;
    std::string_view name;
    std::string_view summary;
};

inline constexpr MethodName method_names[] = {
    {Method::marching, "marching", "uniform steps; a root where the sign changes"},
    {Method::amp_sign, "amp-sign",
     "steps adapted to |F| and |dF/dt| (the paper's Eq. 2); a root where the sign changes"},
    {Method::amp_taylor, "amp-taylor",
     "the same steps; a root where values or linear extensions enclose 0 (Eq. 3)"},
    {Method::hermite, "hermite", "cubics with an error estimate: steps as long as it allows"},
    {Method::interval, "interval", "proofs: pieces halved until bounds on F and dF/dt decide"},
    {Method::affine, "affine", "proofs: the same with F in a piece's middle and bounds on dF/dt"},
    {Method::sphere, "sphere", "proofs: steps of |F| over the steepest dF/dt ahead"},
    {Method::chebyshev, "chebyshev",
     "for polynomials of degree 1 to 12: the polynomial along the ray, solved"},
};

// Whether a step of the scene's decides where the ray is sampled.
constexpr bool takes_steps(Method method) {
    return method == Method::marching || method == Method::amp_sign || method == Method::amp_taylor;
}

// Whether interval arithmetic bounds F and dF/dt over pieces of the ray.
constexpr bool bounds_pieces(Method method) {
    return method == Method::interval || method == Method::affine || method == Method::sphere;
}

constexpr std::string_view name(Method method) {
    for (const auto& entry : method_names) {
        if (entry.method == method) return entry.name;
    }
    return "?";
}

constexpr std::optional<Method> parse_method(std::string_view text) {
    for (const auto& entry : method_names) {
        if (entry.name == text) return entry.method;
    }
    return std::nullopt;
}

} // namespace isomotion::scene
