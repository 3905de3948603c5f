#include "scene/reading/pov_functions.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "formula/graph/noise.h"

namespace isomotion::scene {
namespace {

using Numbers = std::span<const double>;
using Value = double (*)(Numbers);

template<double (*function)(double)> double of_one(Numbers a) { return function(a[0]); }

double least(Numbers a) { return *std::ranges::min_element(a); }
double greatest(Numbers a) { return *std::ranges::max_element(a); }

struct PovFunction {
    std::string_view name;
    std::size_t arguments;
    std::string_view text; // with $0, $1 for the arguments
    Value value = nullptr; // of numbers
    // functions.inc: the text is a field F, of $0 $1 $2 for POV-Ray's x y z. The function is
    // strength*F within 10 on either side, and the strength is $3.
    bool is_field = false;
};

constexpr PovFunction pov_functions[] = {
    {"abs", 1, "abs($0)", of_one<std::fabs>},
    {"acos", 1, "acos($0)", of_one<std::acos>},
    {"acosh", 1, "acosh($0)", of_one<std::acosh>},
    {"asin", 1, "asin($0)", of_one<std::asin>},
    {"asinh", 1, "asinh($0)", of_one<std::asinh>},
    {"atan", 1, "atan($0)", of_one<std::atan>},
    {"atan2", 2, "atan2($0, $1)", [](Numbers a) { return std::atan2(a[0], a[1]); }},
    {"atanh", 1, "atanh($0)", of_one<std::atanh>},
    {"ceil", 1, "(-floor(-$0))", of_one<std::ceil>},
    {"cos", 1, "cos($0)", of_one<std::cos>},
    {"cosh", 1, "cosh($0)", of_one<std::cosh>},
    {"degrees", 1, "($0*180/pi)", [](Numbers a) { return a[0] * 180 / std::numbers::pi; }},
    {"div", 2, "trunc($0/$1)", [](Numbers a) { return std::trunc(a[0] / a[1]); }},
    {"exp", 1, "exp($0)", of_one<std::exp>},
    {"f_noise3d", 3, "(0.5 + 0.5*noise($0, $1, $2))",
     [](Numbers a) { return 0.5 + 0.5 * formula::noise(a[0], a[1], a[2], {}); }},
    {"floor", 1, "floor($0)", of_one<std::floor>},
    {"int", 1, "trunc($0)", of_one<std::trunc>},
    {"ln", 1, "log($0)", of_one<std::log>},
    {"log", 1, "(log($0)/log(10))", of_one<std::log10>},
    {"mod", 2, "($0 - $1*trunc($0/$1))", [](Numbers a) { return std::fmod(a[0], a[1]); }},
    {"pow", 2, "($0^$1)", [](Numbers a) { return std::pow(a[0], a[1]); }},
    {"radians", 1, "($0*pi/180)", [](Numbers a) { return a[0] * std::numbers::pi / 180; }},
    {"select", 3, "if($0 < 0, $1, $2)", [](Numbers a) { return a[0] < 0 ? a[1] : a[2]; }},
    {"select", 4, "if($0 < 0, $1, if($0 > 0, $3, $2))",
     [](Numbers a) { return a[0] < 0   ? a[1]
                            : a[0] > 0 ? a[3]
                                       : a[2]; }},
    {"sin", 1, "sin($0)", of_one<std::sin>},
    {"sinh", 1, "sinh($0)", of_one<std::sinh>},
    {"sqr", 1, "($0^2)", [](Numbers a) { return a[0] * a[0]; }},
    {"sqrt", 1, "sqrt($0)", of_one<std::sqrt>},
    {"tan", 1, "tan($0)", of_one<std::tan>},
    {"tanh", 1, "tanh($0)", of_one<std::tanh>},

    {"f_r", 3, "length($0, $1, $2)"},
    {"f_th", 3, "atan2($0, $2)"},
    {"f_ph", 3, "atan2(length($0, $2), $1)"},
    {"f_sphere", 4, "(length($0, $1, $2) - $3)"},
    {"f_ellipsoid", 6, "length($0*$3, $1*$4, $2*$5)"},
    {"f_torus", 5, "(length(length($0, $2) - $3, $1) - $4)"},
    {"f_rounded_box", 7,
     "(length(max(abs($0) - $4 + $3, 0), max(abs($1) - $5 + $3, 0), max(abs($2) - $6 + $3, 0)) - "
     "$3 - 1e-6)"},
    {"f_superellipsoid", 5,
     "(1 - ((abs($0)^(2/$3) + abs($1)^(2/$3))^($3/$4) + abs($2)^(2/$4))^($4/2))"},
    {"f_poly4", 8, "(length($0, $2) - max($3 + $4*$1 + $5*$1^2 + $6*$1^3 + $7*$1^4, -5))"},
    {"f_blob", 8,
     "(-$4*(1 - min((($0 + $3/2)^2 + $1^2 + $2^2)*$5^2, 1))^2 - "
     "$6*(1 - min((($0 - $3/2)^2 + $1^2 + $2^2)*$7^2, 1))^2)"},
    {"f_blob2", 7,
     "($6 - $5*(exp(-$4*($0^2 + $1^2 + $2^2)) + exp(-$4*(($0 - $3)^2 + $1^2 + $2^2))))"},
    {"f_cross_ellipsoids", 7,
     "($6 - $5*max(exp(-$4*($3*$0^2 + $3*$1^2 + $2^2)), exp(-$4*($3*$0^2 + $1^2 + $3*$2^2)), "
     "exp(-$4*($0^2 + $3*$1^2 + $3*$2^2))))"},
    {"f_flange_cover", 7,
     "($6 - $5*(exp(-$4*($3*$0^2 + $3*$1^2 + $2^2)) + exp(-$4*($3*$0^2 + $1^2 + $3*$2^2)) + "
     "exp(-$4*($0^2 + $3*$1^2 + $3*$2^2))))"},
    {"f_isect_ellipsoids", 7,
     "($6 - $5*min(exp(-$4*($3*$0^2 + $3*$1^2 + $2^2)), exp(-$4*($3*$0^2 + $1^2 + $3*$2^2)), "
     "exp(-$4*($0^2 + $3*$1^2 + $3*$2^2))))"},
    {"f_spikes_2d", 7, "($1 - $3*cos($4*$0)*cos($5*$2)*exp(-$6*($0^2 + $2^2)))"},

    {"f_bicorn", 5, "$1^2*($4^2 - $0^2 - $2^2) - ($0^2 + $2^2 + 2*$4*$1 - $4^2)^2", nullptr, true},
    {"f_bifolia", 5, "$4*($0^2 + $2^2)*$1 - ($0^2 + $1^2 + $2^2)^2", nullptr, true},
    {"f_crossed_trough", 4, "$0^2*$2^2 - $1", nullptr, true},
    {"f_cubic_saddle", 4, "$1^3 - $0^3 + $2", nullptr, true},
    {"f_devils_curve", 4, "$1^4 - 0.25*$1^2 - ($0^2 + $2^2)^2 + 0.36*$0^2", nullptr, true},
    {"f_folium_surface", 6, "($1^2 + $2^2)*(1 + ($5 - 4*$4)*$0) + (1 + $5)*$0^2", nullptr, true},
    {"f_glob", 4, "0.5*$0^5 + 0.5*$0^4 - $1^2 - $2^2", nullptr, true},
    {"f_heart", 4, "0.1*$0^2*$2^3 + $1^2*$2^3 - (2*$0^2 + $1^2 + $2^2 - 1)^3", nullptr, true},
    {"f_hunt_surface", 4, "-4*($0^2 + $1^2 + $2^2 - 13)^3 - 27*(3*$0^2 + $1^2 - 4*$2^2 - 12)^2",
     nullptr, true},
    {"f_klein_bottle", 4,
     "-(($0^2 + $1^2 + $2^2 + 2*$1 - 1)*(($0^2 + $1^2 + $2^2 - 2*$1 - 1)^2 - 8*$2^2) + "
     "16*$0*$2*($0^2 + $1^2 + $2^2 - 2*$1 - 1))",
     nullptr, true},
    {"f_kummer_surface_v1", 4,
     "$0^2 + $1^2 + $2^2 + $0^2*$1^2 + $0^2*$2^2 + $1^2*$2^2 - $0^4 - $1^4 - $2^4 - 1", nullptr,
     true},
    {"f_lemniscate_of_gerono", 4, "$0^2 - $0^4 - $1^2 - $2^2", nullptr, true},
    {"f_mitre", 4, "$1^2*(1 - $1^2 - $2^2) - 4*$0^2*($0^2 + $1^2 + $2^2)", nullptr, true},
    {"f_nodal_cubic", 4, "6*$1*$2 - $1^3 - $2^3", nullptr, true},
    {"f_ovals_of_cassini", 7, "$6*$4^2*($0^2 + $2^2) + $5^2 - ($0^2 + $1^2 + $2^2 + $4^2)^2",
     nullptr, true},
    {"f_paraboloid", 4, "$1 - $0^2 - $2^2", nullptr, true},
    {"f_pillow", 4, "$0^4 + $1^4 + $2^4 - $0^2 - $1^2 - $2^2", nullptr, true},
    {"f_quartic_cylinder", 6, "$5^2*$4^2 - ($0^2 + $2^2)*($1^2 + $5^2)", nullptr, true},
    {"f_quartic_paraboloid", 4, "$1 - $0^4 - $2^4", nullptr, true},
    {"f_quartic_saddle", 4, "$1 - $0^4 + $2^4", nullptr, true},
    {"f_steiners_roman", 4, "-($0^2*$1^2 + $0^2*$2^2 + $1^2*$2^2 + $0*$1*$2)", nullptr, true},
    {"f_strophoid", 7, "$6^2*$0^2*($4 + $0) - ($5 - $0)*($1^2 + $2^2)", nullptr, true},
    {"f_torus2", 6,
     "2*($4^2 + $5^2)*($0^2 + $2^2) - 2*($4^2 - $5^2)*$1^2 - ($4^2 - $5^2)^2 - "
     "($0^2 + $1^2 + $2^2)^2",
     nullptr, true},
    {"f_torus_gumdrop", 4,
     "20*($0^2 + $1^2 + $2^2) - 4*($0^4 + ($1^2 + $2^2)^2) - 17*$0^2*($1^2 + $2^2) - 17", nullptr,
     true},
    {"f_umbrella", 4, "$1*$2^2 - $0^2", nullptr, true},
    {"f_witch_of_agnesi", 5, "-$4*($1 - 1) - ($0^2 + $2^2)*$1", nullptr, true},
};

bool takes_any(std::string_view name) { return name == "min" || name == "max"; }

// Arguments are put in as they are where they are one letter, number or call.
std::string put_in(std::string_view text, const std::vector<PovNumber>& arguments) {
    std::string all;
    for (std::size_t k = 0; k < text.size(); ++k) {
        if (text[k] != '$') {
            all += text[k];
            continue;
        }
        const PovNumber& argument = arguments[std::size_t(text[++k] - '0')];
        const bool is_atom = argument.strength == PovNumber::Strength::atom;
        all += is_atom ? argument.text : fmt::format("({})", argument.text);
        if (all.size() > longest_pov_text) break; // the caller refuses it
    }
    return all;
}

} // namespace

bool is_pov_function(std::string_view name) {
    return takes_any(name) || std::ranges::count(pov_functions, name, &PovFunction::name) > 0;
}

std::string pov_function_refusal(const std::string& name) {
    if (is_pov_function(name)) return {};
    if (name == "f_noise_generator" || name == "f_ridged_mf" || name == "f_ridge" ||
        name == "f_hetero_mf") {
        return fmt::format("the function {} is not read: there is no formula for it; write a sum "
                           "of f_noise3d",
                           name);
    }
    std::string words = "min, max";
    std::string_view last;
    for (const PovFunction& one : pov_functions) {
        if (one.name != last) words += fmt::format(", {}", one.name);
        last = one.name;
    }
    return fmt::format("the function {} is not read; read are {}, and those that the file declares",
                       name, words);
}

std::string pov_function_arguments(const std::string& name) {
    if (takes_any(name)) return "at least 2 numbers";
    if (name == "select") return "3 or 4 numbers";
    const auto* const found = std::ranges::find(pov_functions, name, &PovFunction::name);
    return fmt::format("{} number{}", found->arguments, found->arguments == 1 ? "" : "s");
}

namespace {

// Numbers alone are computed; what parameters make of numbers has a value beside its text.
PovNumber called(std::string text, Value value, const std::vector<PovNumber>& arguments) {
    PovNumber all{std::move(text), PovNumber::Strength::atom, std::nullopt};
    std::vector<double> numbers;
    for (const PovNumber& argument : arguments) {
        if (!argument.value) return all;
        numbers.push_back(*argument.value);
    }
    const double number = value(numbers);
    if (!std::isfinite(number)) return all;
    if (std::ranges::all_of(arguments, &PovNumber::is_plain)) return PovNumber::of(number);
    all.value = number;
    return all;
}

} // namespace

std::optional<PovNumber> called_pov_function(const std::string& name,
                                             const std::vector<PovNumber>& arguments) {
    if (takes_any(name)) {
        if (arguments.size() < 2) return std::nullopt;
        std::vector<std::string> texts;
        texts.reserve(arguments.size());
        for (const PovNumber& argument : arguments) texts.push_back(argument.text);
        return called(fmt::format("{}({})", name, fmt::join(texts, ", ")),
                      name == "min" ? least : greatest, arguments);
    }
    const auto* const found = std::ranges::find_if(pov_functions, [&](const PovFunction& one) {
        return one.name == name && one.arguments == arguments.size();
    });
    if (found == std::end(pov_functions)) return std::nullopt;
    std::string text = put_in(found->text, arguments);
    if (found->value) return called(std::move(text), found->value, arguments);
    if (found->is_field)
        text = fmt::format("clamp({}*({}), -10, 10)", put_in("$3", arguments), text);
    return PovNumber{text, PovNumber::Strength::atom, std::nullopt};
}

bool is_pov_word_of_formulas(std::string_view name) {
    static constexpr std::string_view words[] = {"if",    "length", "trunc",
                                                 "clamp", "atanh",  "noise"};
    return std::ranges::count(words, name) > 0;
}

} // namespace isomotion::scene
