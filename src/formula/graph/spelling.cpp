#include "formula/graph/spelling.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "formula/graph/functions.h"
#include "formula/graph/vocabulary.h"

namespace isomotion::formula {
namespace {

struct Pair {
    std::string_view word, plain;
};

constexpr std::array others{
    Pair{"tg", "tan"},        Pair{"ctg", "cot"},       Pair{"cotan", "cot"},
    Pair{"cosec", "csc"},     Pair{"sgn", "sign"},      Pair{"signum", "sign"},
    Pair{"arsinh", "asinh"},  Pair{"arcsinh", "asinh"}, Pair{"arcosh", "acosh"},
    Pair{"arccosh", "acosh"}, Pair{"artanh", "atanh"},  Pair{"arctanh", "atanh"},
    Pair{"arctg", "atan"},    Pair{"power", "pow"},     Pair{"ceiling", "ceil"},
    Pair{"fabs", "abs"},      Pair{"fmin", "min"},      Pair{"fmax", "max"},
    Pair{"minimum", "min"},   Pair{"maximum", "max"},   Pair{"where", "if"},
    Pair{"iif", "if"},        Pair{"ifelse", "if"},     Pair{"lerp", "mix"},
    Pair{"norm", "length"},   Pair{"log_2", "log2"},    Pair{"log_10", "log10"},
};

constexpr std::array advice{
    Pair{"piecewise", "write if(condition, a, b)"},
    Pair{"cases", "write if(condition, a, b)"},
    Pair{"sqr", "write a^2 for a square, sqrt(a) for a root"},
    Pair{"frac", "write fract(a) for a - floor(a), or a - trunc(a)"},
    Pair{"lg", "write log10(a), or log2(a)"},
    Pair{"fmod", "write mod(a, b), whose value has the sign of b"},
    Pair{"int", "write floor(a), or trunc(a)"},
    Pair{"sinc", "write sin(a)/a; it has no value where a is 0"},
    Pair{"sech", "write 1/cosh(a)"},
    Pair{"csch", "write 1/sinh(a)"},
    Pair{"coth", "write 1/tanh(a)"},
    Pair{"arg", "write atan2(y, x) for the angle of the point (x, y)"},
    Pair{"t", "write t for the time"},
    Pair{"theta", "write atan2(y, x) for an angle about the z axis"},
    Pair{
        "phi",
        "write atan2(y, x) for an angle about the z axis, acos(z/length(x, y, z)) for one from it"},
    Pair{"r",
         "write length(x, y, z) for the distance from the origin, length(x, y) from the z axis"},
    Pair{"rho", "write length(x, y) for the distance from the z axis"},
    Pair{"p", "write x, y and z for the point's parts; length(p), dot(p, p) and noise(p) are read"},
    Pair{"re", "a formula has real numbers only"},
    Pair{"im", "a formula has real numbers only"},
    Pair{"vec2", "a formula has numbers and no vectors: length(vec2(a, b)) is read"},
    Pair{"vec3", "a formula has numbers and no vectors: length(vec3(a, b, c)) is read"},
    Pair{"vec4", "a formula has numbers and no vectors"},
    Pair{"float3", "a formula has numbers and no vectors: length(vec3(a, b, c)) is read"},
    Pair{"cross", "a formula has numbers and no vectors: write its parts"},
    Pair{"normalize", "a formula has numbers and no vectors: write its parts"},
};

std::string_view find(std::span<const Pair> pairs, std::string_view word) {
    const auto found = std::ranges::find(pairs, word, &Pair::word);
    return found == pairs.end() ? std::string_view{} : found->plain;
}

std::string in_small_letters(std::string_view word) {
    std::string small(word);
    std::ranges::transform(small, small.begin(),
                           [](unsigned char c) { return char(std::tolower(c)); });
    return small;
}

} // namespace

std::string plain_spelling(std::string_view word) {
    std::string small = in_small_letters(word);
    if (const std::string_view plain = find(others, small); !plain.empty()) small = plain;
    const bool has_meaning = small == "pi" || small == "tau" || small == "e" ||
                             std::ranges::count(coordinate_names, small) > 0 ||
                             find_function(plain_name(small));
    return has_meaning ? small : std::string(word);
}

std::string_view advice_for(std::string_view word) { return find(advice, in_small_letters(word)); }

} // namespace isomotion::formula
