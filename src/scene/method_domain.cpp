#include "scene/method_domain.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "formula/graph/degree.h"

namespace isomotion::scene {

std::string refusal(Method method, const formula::Field& field) {
    if (method != Method::chebyshev) return {};
    const auto degree = formula::degree(field.graph, field.root);
    if (degree && *degree <= highest_solved_degree) return {};
    const std::string is =
        degree ? fmt::format("is one of degree {}", *degree) : std::string("is none");
    return fmt::format("'{}' solves polynomials in x, y and z of degree up to {}, and the formula "
                       "{}; take '{}' or another method",
                       name(method), highest_solved_degree, is, name(Method::hermite));
}

std::vector<Method> methods_for(const formula::Field& field) {
    std::vector<Method> methods;
    for (const MethodTraits& entry : method_traits) {
        if (refusal(entry.method, field).empty()) methods.push_back(entry.method);
    }
    return methods;
}

int solved_degree(const formula::Field& field) {
    const std::string why = refusal(Method::chebyshev, field);
    if (!why.empty()) throw std::invalid_argument(why);
    return std::max(1, *formula::degree(field.graph, field.root));
}

} // namespace isomotion::scene
