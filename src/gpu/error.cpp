#include "gpu/error.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <set>
#include <vector>

namespace isomotion::gpu {
namespace {

constexpr int context_lines = 2;

/// A place as the compiler counts: string and line, both as `#line` sets them.
struct Place {
    int string = 0;
    int line = 0;
    bool operator==(const Place&) const = default;
};

struct SourceLine {
    Place place;
    std::string_view text;
};

std::string_view trim(std::string_view text) {
    const auto start = text.find_first_not_of(" \t\r");
    return start == std::string_view::npos ? std::string_view{} : text.substr(start);
}

std::optional<int> take_number(std::string_view& text) {
    int number = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (failure != std::errc{}) return std::nullopt;
    text.remove_prefix(std::size_t(end - text.data()));
    return number;
}

template<typename Visit> void for_each_line(std::string_view text, Visit visit) {
    while (!text.empty()) {
        const auto end = std::min(text.find('\n'), text.size());
        visit(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
}

std::vector<SourceLine> number_lines(std::string_view source) {
    std::vector<SourceLine> lines;
    Place place{0, 1};
    for_each_line(source, [&](std::string_view text) {
        lines.push_back({place, text});
        ++place.line;
        std::string_view directive = trim(text);
        if (!directive.starts_with("#line")) return;
        directive = trim(directive.substr(5));
        if (const auto line = take_number(directive)) place.line = *line;
        directive = trim(directive);
        if (const auto string = take_number(directive)) place.string = *string;
    });
    return lines;
}

/// Drivers write "0:12(5): error", "0(12) : error" or "ERROR: 0:12: ...".
std::optional<Place> place_in(std::string_view message) {
    if (message.starts_with("ERROR:")) message = trim(message.substr(6));
    const auto string = take_number(message);
    if (!string || message.empty() || (message[0] != ':' && message[0] != '(')) return std::nullopt;
    message.remove_prefix(1);
    const auto line = take_number(message);
    if (!line) return std::nullopt;
    return Place{*string, *line};
}

std::string excerpt(std::string_view log, std::string_view source) {
    const std::vector<SourceLine> lines = number_lines(source);
    std::set<std::size_t> wrong, shown;
    for_each_line(log, [&](std::string_view message) {
        const auto place = place_in(message);
        if (!place) return;
        const bool exact = std::ranges::find(lines, *place, &SourceLine::place) != lines.end();
        for (std::size_t i = 0; i < lines.size(); ++i) {
            // Mesa heeds the line of a `#line` and not its string.
            const Place at{exact ? lines[i].place.string : place->string, lines[i].place.line};
            if (at != *place) continue;
            wrong.insert(i);
            const auto first = i - std::min<std::size_t>(i, context_lines);
            const auto last = std::min(i + context_lines, lines.size() - 1);
            for (auto j = first; j <= last; ++j) shown.insert(j);
        }
    });
    std::string text;
    std::optional<std::size_t> previous;
    for (const std::size_t i : shown) {
        if (previous && i != *previous + 1) text += "       ...\n";
        text += fmt::format("{} {:5} | {}\n", wrong.contains(i) ? '>' : ' ', lines[i].place.line,
                            lines[i].text);
        previous = i;
    }
    return text;
}

std::string_view error_name(GLenum code) {
    switch (code) {
    case GL_INVALID_ENUM:
        return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
        return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
        return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
        return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY:
        return "out of graphics memory";
    default:
        return "an unknown OpenGL error";
    }
}

} // namespace

CompileError::CompileError(std::string_view label, std::string stage, std::string log,
                           std::string_view source)
    : Error(Code::device, fmt::format("{}: the {} {} failed\n{}{}{}", label, stage,
                                      stage == "link" ? "step" : "shader", log,
                                      log.ends_with('\n') ? "" : "\n", excerpt(log, source)))
    , stage_(std::move(stage))
    , log_(std::move(log)) {}

void forget_errors() {
    while (glGetError() != GL_NO_ERROR) {
    }
}

void expect_success(std::string_view what) {
    const GLenum code = glGetError();
    if (code != GL_NO_ERROR) throw ResourceError(fmt::format("{}: {}", what, error_name(code)));
}

} // namespace isomotion::gpu
