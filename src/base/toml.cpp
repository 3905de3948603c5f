#include "base/toml.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/input_error.h"
#include "base/printable.h"

namespace isomotion::base {
namespace {

// The place behind the closing quote of the string whose opening quote is at `begin`.
std::size_t end_of_string(std::string_view text, std::size_t begin) {
    const char quote = text[begin];
    const std::string_view three = text.substr(begin, 3);
    const bool has_lines = three.size() == 3 && three[1] == quote && three[2] == quote;
    for (std::size_t at = begin + (has_lines ? 3 : 1); at < text.size(); ++at) {
        if (text[at] == '\\' && quote == '"') {
            ++at;
        } else if (!has_lines && text[at] == '\n') {
            return at; // a mistake
        } else if (text[at] == quote && (!has_lines || text.substr(at, 3) == three)) {
            at += has_lines ? 3 : 1;
            // Up to two quotes may stand before the three that close.
            while (has_lines && at < text.size() && text[at] == quote) ++at;
            return at;
        }
    }
    return text.size();
}

} // namespace

int first_line_nested_beyond(std::string_view text, int most) {
    int brackets = 0, dots = 0, line = 1;
    for (std::size_t at = 0; at < text.size();) {
        const char c = text[at];
        std::size_t end = at + 1;
        switch (c) {
        case '#':
            end = std::min(text.find('\n', at), text.size());
            break;
        case '"':
        case '\'':
            end = end_of_string(text, at);
            break;
        case '[':
        case '{':
            ++brackets;
            dots = 0;
            break;
        case ']':
        case '}':
            brackets = std::max(0, brackets - 1);
            dots = 0;
            break;
        case '.':
            ++dots;
            break;
        case '\n':
        case ',':
        case '=':
            dots = 0;
            break;
        default:
            break;
        }
        if (brackets + dots > most) return line;
        line += int(std::count(text.begin() + std::ptrdiff_t(at),
                               text.begin() + std::ptrdiff_t(end), '\n'));
        at = end;
    }
    return 0;
}

toml::table parse_toml(std::string_view text, const std::string& file) {
    if (const int line = first_line_nested_beyond(text, toml_nesting)) {
        throw InputError(
            fmt::format("{}:{}: tables and lists are nested too deeply; {} deep are read",
                        printable_line(file), line, toml_nesting));
    }
    try {
        return toml::parse(text, file);
    } catch (const toml::parse_error& error) {
        throw InputError(fmt::format("{}:{}: not valid TOML: {}", printable_line(file),
                                     error.source().begin.line, error.description()));
    }
}

} // namespace isomotion::base
