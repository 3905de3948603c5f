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
    {Method::chebyshev, "chebyshev",
     "for polynomials of degree 1 to 12: the polynomial along the ray, solved"},
};

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
