// Where a formula is wrong, as its author sees it: the line, and a caret below the place.
#include <algorithm>

#include <fmt/format.h>

#include "formula/graph/parser.h"
#include "formula/graph/utf8.h"

namespace isomotion::formula {
namespace {

struct Place {
    int line = 1;
    int column = 1;
    std::string_view text_of_line;
};

// The length of the first `count` UTF-8 characters.
std::size_t bytes_of(std::string_view text, int count) {
    std::size_t bytes = 0;
    for (; bytes < text.size(); ++bytes) {
        if (!continues_character(text[bytes]) && --count < 0) break;
    }
    return bytes;
}

Place locate(std::string_view text, std::size_t offset) {
    Place place;
    offset = std::min(offset, text.size());
    std::size_t begin = 0;
    for (std::size_t k = 0; k < offset; ++k) {
        if (text[k] == '\n') {
            ++place.line;
            begin = k + 1;
        }
    }
    // Columns count characters, not bytes: UTF-8 continuation bytes don't move the caret.
    for (std::size_t k = begin; k < offset; ++k) {
        if (!continues_character(text[k])) ++place.column;
    }
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    place.text_of_line = text.substr(begin, end - begin);
    return place;
}

std::string with_caret(std::string_view text, std::size_t offset, const std::string& message) {
    // Long formulas are cut to a window around the place.
    constexpr int before = 60, width = 96;
    const Place place = locate(text, offset);
    std::string_view line = place.text_of_line;
    int column = place.column;
    std::string lead;
    if (column > before + 4) {
        line.remove_prefix(bytes_of(line, column - before));
        column = before;
        lead = "...";
    }
    const std::size_t shown = bytes_of(line, width);
    const std::string tail = line.size() > shown ? "..." : "";
    line = line.substr(0, shown);
    return fmt::format("{}\n    {}{}{}\n    {:>{}}", message, lead, line, tail, "^",
                       int(lead.size()) + column);
}

} // namespace

ParseError::ParseError(std::string_view text, std::size_t offset, const std::string& message)
    : Error(Code::formula, with_caret(text, offset, message))
    , message_(message) {
    const Place place = locate(text, offset);
    line_ = place.line;
    column_ = place.column;
}

} // namespace isomotion::formula
