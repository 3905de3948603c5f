#include "fuzz/generated_glsl.h"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <set>

#include <fmt/format.h>

#include "fuzz/targets.h"

namespace isomotion::fuzz {
namespace {

bool is_digit(char c) { return '0' <= c && c <= '9'; }
bool is_letter(char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '_'; }

// A word is its letters with all numbers as '#': v12 is "v#", a0_1 "a#_#".
std::string shape(std::string_view word) {
    std::string result;
    for (const char c : word) {
        if (!is_digit(c)) result += c;
        if (is_digit(c) && (result.empty() || result.back() != '#')) result += '#';
    }
    return result;
}

const std::set<std::string>& generated_words() {
    static const std::set<std::string> words{
        // the language
        "float", "int", "void", "vec#", "out", "for", "return", "abs", "sign", "floor", "min",
        "max",
        // inputs and outputs of the functions
        "p", "d", "x", "y", "z", "w", "dx", "dy", "dz", "gx", "gy", "gz", "rest", "factor",
        "element", "texel", "xy", "yx", "n", "curvature", "evaluations", "paint_time",
        // registers, results of kernels, elements, loops, storage
        "v#", "w#", "a#_#", "e#", "array#_texel", "array#_count", "array#_least", "parameters",
        // what is made
        "field", "field_directional", "field_gradient", "field_interval",
        "field_directional_interval", "field_gradient_interval", "rest_and_factor_interval",
        "term_interval"};
    return words;
}

// Numbers as glsl_literal writes them: GLSL reads none that is no finite float.
void check_number(std::string_view text) {
    const double value = std::strtod(std::string(text).c_str(), nullptr);
    if (!std::isfinite(float(value))) throw Violation(fmt::format("the number {}", text));
}

} // namespace

void check_generated(std::string_view glsl) {
    for (std::size_t at = 0; at < glsl.size();) {
        const char c = glsl[at];
        std::size_t end = at + 1;
        if (is_letter(c)) {
            while (end < glsl.size() && (is_letter(glsl[end]) || is_digit(glsl[end]))) ++end;
            const std::string_view word = glsl.substr(at, end - at);
            const bool own = word.starts_with("im_") || word.starts_with("IM_");
            if (!own && !generated_words().count(shape(word))) {
                throw Violation(fmt::format("the word {}", word));
            }
        } else if (is_digit(c) || c == '.') {
            while (end < glsl.size() &&
                   (is_digit(glsl[end]) || glsl[end] == '.' || glsl[end] == 'e' ||
                    ((glsl[end] == '-' || glsl[end] == '+') && glsl[end - 1] == 'e'))) {
                ++end;
            }
            if (end > at + 1 || c != '.') check_number(glsl.substr(at, end - at));
            if (c == '.' && end == at + 1 && !(end < glsl.size() && is_letter(glsl[end]))) {
                throw Violation("a point before no component");
            }
        } else if (std::string_view(" \n+-*/<>?:;,=(){}[]").find(c) == std::string_view::npos) {
            throw Violation(fmt::format("the character {:#x}", static_cast<unsigned char>(c)));
        } else if (c == '/' && end < glsl.size() && (glsl[end] == '/' || glsl[end] == '*')) {
            throw Violation("a comment");
        }
        at = end;
    }
}

namespace {

template<class Code, class Comment>
void split(std::string_view glsl, const Code& code, const Comment& comment) {
    while (!glsl.empty()) {
        const std::size_t slash = std::min(glsl.find("//"), glsl.find("/*"));
        code(glsl.substr(0, slash));
        if (slash == glsl.npos) return;
        const bool to_line_end = glsl[slash + 1] == '/';
        const std::size_t end = glsl.find(to_line_end ? "\n" : "*/", slash + 2);
        comment(glsl.substr(slash + 2, end == glsl.npos ? end : end - slash - 2));
        if (end == glsl.npos) return;
        glsl.remove_prefix(to_line_end ? end : end + 2);
    }
}

} // namespace

std::string without_comments(std::string_view glsl) {
    std::string result;
    split(
        glsl, [&](std::string_view code) { result += code; }, [](std::string_view) {});
    return result;
}

std::vector<std::string> comments(std::string_view glsl) {
    std::vector<std::string> found;
    split(
        glsl, [](std::string_view) {}, [&](std::string_view text) { found.emplace_back(text); });
    return found;
}

} // namespace isomotion::fuzz
