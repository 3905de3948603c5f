#include "shader/inlined_size.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace isomotion::shader {
namespace {

constexpr double usual_largest = 40'000;

constexpr std::string_view letters =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_";

std::string_view line_of(std::string_view& rest) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    return line;
}

struct Function {
    bool is_of_field = false; // generated from a formula
    int overloads = 0;
    double operators = 0;
    std::map<std::string_view, int> calls; // of words before a parenthesis: no functions among them
};

// `float im_exp(float x) {`, or empty.
std::string_view function_begun_by(std::string_view line) {
    if (line.empty() || !std::isalpha(static_cast<unsigned char>(line[0]))) return {};
    const std::size_t parenthesis = line.find('(');
    if (parenthesis == line.npos || line.find(';') != line.npos) return {};
    const std::string_view before = line.substr(0, parenthesis);
    const std::size_t space = before.find_last_not_of(letters);
    return space == before.npos ? std::string_view() : before.substr(space + 1);
}

// Numbers and parameters of a formula: Mesa keeps each in a register of its own, and its time for
// registers grows with all of them. A polynomial of 1000 coefficients took twice as long as a sum
// of as many operations without.
constexpr double operators_of_a_number = 1.5;

bool begins_number(std::string_view line, std::size_t k) {
    const bool is_digit = std::isdigit(static_cast<unsigned char>(line[k])) != 0;
    return is_digit &&
           (k == 0 || (letters.find(line[k - 1]) == letters.npos && line[k - 1] != '.'));
}

void add_body(Function& function, std::string_view line) {
    line = line.substr(0, line.find("//"));
    for (std::size_t k = 0; k < line.size(); ++k) {
        function.operators += std::string_view("-+*/<>=?").find(line[k]) != std::string_view::npos;
        // That of a parameter is its place.
        if (function.is_of_field && begins_number(line, k))
            function.operators += operators_of_a_number;
        if (line[k] != '(') continue;
        const std::size_t before = line.substr(0, k).find_last_not_of(letters) + 1;
        if (before < k) ++function.calls[line.substr(before, k - before)];
    }
}

std::map<std::string_view, Function> functions_of(std::string_view shader) {
    std::map<std::string_view, Function> functions;
    Function* open = nullptr;
    while (!shader.empty()) {
        const std::string_view line = line_of(shader);
        if (line.starts_with('}')) {
            open = nullptr;
        } else if (const auto name = function_begun_by(line); !name.empty()) {
            open = &functions[name];
            ++open->overloads;
            open->is_of_field = name.starts_with("field");
        } else if (open) {
            add_body(*open, line);
        }
    }
    return functions;
}

// How much of a function is left to compile, as fits the times of Mesa. Drivers throw away ends of
// bounds whose signs they know, and a part of sines and cosines is cheap operations on integers.
double part_left(std::string_view name) {
    if (name == "im_sin_cos") return 0.4;
    // Limits were measured with the loop of a march counted twice.
    if (name == "march_part") return 2;
    const bool bounds = name.ends_with("_interval") || name.ends_with("_rough");
    return name.starts_with("field_") && bounds ? 0.5 : 1;
}

class Sizes {
public:
    explicit Sizes(const std::map<std::string_view, Function>& functions)
        : functions_(functions) {}

    double of(std::string_view name) {
        const auto found = functions_.find(name);
        if (found == functions_.end()) return 0;
        const auto [known, is_new] = sizes_.emplace(name, 0);
        if (!is_new) return known->second; // while it is summed: of an overload that calls another
        double size = found->second.operators;
        for (const auto& [called, times] : found->second.calls) size += times * of(called);
        return sizes_[name] = part_left(name) * size / found->second.overloads;
    }

private:
    const std::map<std::string_view, Function>& functions_;
    std::map<std::string_view, double> sizes_;
};

} // namespace

double inlined_size(std::string_view shader) {
    const auto functions = functions_of(shader);
    return Sizes(functions).of("main");
}

double inlined_size(const Passes& passes) {
    double size = 0;
    for (const Pass& pass : passes.list) {
        if (!is_exceptional(pass.when)) size += inlined_size(pass.text);
    }
    return size;
}

double largest_shaders() {
    const char* const given = std::getenv("ISOMOTION_LARGEST_SHADERS");
    if (!given) return usual_largest;
    const std::string_view text(given);
    double size = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), size);
    if (error != std::errc{} || end != text.data() + text.size() || !(size > 0))
        throw std::invalid_argument(
            fmt::format("ISOMOTION_LARGEST_SHADERS={}: write a number of operations, {:.0f}", text,
                        usual_largest));
    return size;
}

void check_size(const Passes& passes) {
    const double size = inlined_size(passes);
    // A limit of 1 runs each formula as tapes; what is left to compile may be as long as usual.
    const double largest =
        passes.tapes ? std::max(largest_shaders(), usual_largest) : largest_shaders();
    if (size <= largest) return;
    throw std::length_error(fmt::format(
        "the scene's shaders have {:.0f} operations once every call is in its place, and a driver "
        "compiles {:.0f} in some ten seconds, twice as many in four times as long; sum over an "
        "array "
        "what repeats itself, shorten what colours the surface, or set "
        "ISOMOTION_LARGEST_SHADERS={:.0f} and wait",
        std::ceil(size), std::max(largest, usual_largest), std::ceil(size)));
}

} // namespace isomotion::shader
