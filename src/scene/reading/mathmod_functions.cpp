#include "scene/reading/mathmod_functions.h"

#include <algorithm>
#include <cmath>

namespace isomotion::scene::mathmod {
namespace {

// clang-format off
constexpr Function functions[] = {
    {"abs", "abs", std::fabs, nullptr, true},
    {"acos", "acos", std::acos, nullptr, true},
    {"acosh", "arcosh", std::acosh, nullptr, true, false, Helper::arcosh},
    {"asin", "asin", std::asin},
    {"asinh", "asinh", std::asinh},
    {"atan", "atan", std::atan},
    {"atan2", "atan2", nullptr, std::atan2},
    {"atanh", "atanh", std::atanh},
    {"cbrt", "cbrt", std::cbrt},
    {"ceil", "ceil", std::ceil, nullptr, false, true},
    {"cos", "cos", std::cos},
    {"cosh", "cosh", std::cosh, nullptr, true},
    {"cot", "cot", [](double a) { return 1 / std::tan(a); }},
    {"csc", "csc", [](double a) { return 1 / std::sin(a); }},
    {"exp", "exp", std::exp, nullptr, true},
    {"exp2", "exp2", std::exp2, nullptr, true},
    {"floor", "floor", std::floor, nullptr, false, true},
    {"hypot", "hypot", nullptr, std::hypot, true},
    {"int", "round", std::round, nullptr, false, true},
    {"log", "log", std::log},
    {"log10", "log10", std::log10},
    {"log2", "log2", std::log2},
    {"max", "max", nullptr, [](double a, double b) { return a > b ? a : b; }},
    {"min", "min", nullptr, [](double a, double b) { return a < b ? a : b; }},
    {"sec", "sec", [](double a) { return 1 / std::cos(a); }},
    {"sin", "sin", std::sin},
    {"sinh", "sinh", std::sinh},
    {"sqrt", "sqrt", std::sqrt, nullptr, true},
    {"tan", "tan", std::tan},
    {"tanh", "tanh", std::tanh},
    {"trunc", "trunc", std::trunc, nullptr, false, true},
};
// clang-format on

constexpr std::string_view noises[] = {"NoiseW",  "NoiseP",  "MarbleP",        "fhelix1",
                                       "fhelix2", "f_hex_y", "p_skeletal_int", "fmesh"};

} // namespace

const Function* find_function(std::string_view name) {
    const auto found = std::ranges::find(functions, name, &Function::name);
    return found == std::end(functions) ? nullptr : found;
}

std::vector<std::string> function_names() {
    std::vector<std::string> names;
    for (const Function& function : functions) names.emplace_back(function.name);
    return names;
}

bool is_mathmods_own(std::string_view name) { return std::ranges::count(noises, name) > 0; }

} // namespace isomotion::scene::mathmod
