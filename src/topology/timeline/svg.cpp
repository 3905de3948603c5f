#include "topology/timeline/svg.h"

#include <algorithm>

namespace isomotion::topology {
namespace {

// The width of a character, in parts of the font's size.
double advance(char c) {
    if (std::string_view("ijlI.,:;'!| ").find(c) != std::string_view::npos) return 0.35;
    if (std::string_view("ftr()[]-/\\\"").find(c) != std::string_view::npos) return 0.47;
    if (std::string_view("mwMW%@+=<>~^#&_OQGD").find(c) != std::string_view::npos) return 1.0;
    return c >= 'A' && c <= 'Z' ? 0.76 : 0.64;
}

bool continues(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

Rect box_of(double x, double y, std::string_view words, const TextStyle& style) {
    const double width = text_width(words, style.size, style.is_bold);
    const double left = style.anchor == Anchor::start    ? x
                        : style.anchor == Anchor::middle ? x - width / 2
                                                         : x - width;
    return {left, y - 0.8 * style.size, left + width, y + 0.25 * style.size};
}

} // namespace

double text_width(std::string_view utf8, double size, bool is_bold) {
    double width = 0;
    for (const char c : utf8) {
        if (continues(c)) continue;
        width += static_cast<unsigned char>(c) < 0x80 ? advance(c) : 1.0;
    }
    return width * size * (is_bold ? 1.13 : 1);
}

std::string cut_to(const std::string& utf8, double width, double size, bool is_bold) {
    if (text_width(utf8, size, is_bold) <= width) return utf8;
    const std::string ellipsis = "\u2026";
    std::string text = utf8;
    while (!text.empty() && text_width(text + ellipsis, size, is_bold) > width) {
        while (continues(text.back())) text.pop_back();
        text.pop_back();
    }
    return text + ellipsis;
}

std::vector<std::string> wrapped(const std::string& utf8, double width, double size,
                                 std::size_t most) {
    std::vector<std::string> lines;
    std::string rest = utf8;
    while (!rest.empty()) {
        if (lines.size() + 1 == most || text_width(rest, size) <= width) {
            lines.push_back(cut_to(rest, width, size));
            break;
        }
        std::size_t at = 0;
        for (std::size_t space = rest.find(' '); space != std::string::npos;
             space = rest.find(' ', space + 1)) {
            if (text_width(std::string_view(rest).substr(0, space), size) > width) break;
            at = space;
        }
        if (at == 0) at = std::min(rest.find(' '), rest.size());
        lines.push_back(cut_to(rest.substr(0, at), width, size));
        rest.erase(0, std::min(at + 1, rest.size()));
    }
    return lines;
}

std::string escaped(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        safe += c == '<'   ? "&lt;"
                : c == '>' ? "&gt;"
                : c == '&' ? "&amp;"
                : c == '"' ? "&quot;"
                           : std::string(1, c);
    }
    return safe;
}

void Svg::text(double x, double y, const std::string& words, const TextStyle& style) {
    texts_.push_back(box_of(x, y, words, style));
    std::string attributes;
    if (style.anchor != Anchor::start) {
        attributes +=
            fmt::format(" text-anchor=\"{}\"", style.anchor == Anchor::middle ? "middle" : "end");
    }
    if (style.is_bold) attributes += " font-weight=\"bold\"";
    draw("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{:g}\" fill=\"{}\"{}>{}</text>", x, y,
         style.size, style.fill, attributes, escaped(words));
}

bool Svg::text_where_free(double x, double y, const std::string& words, const TextStyle& style) {
    constexpr double air = 2;
    Rect box = box_of(x, y, words, style);
    if (box.left < 0 || box.right > width_) return false;
    box = {box.left - air, box.top, box.right + air, box.bottom};
    if (std::ranges::any_of(texts_, [&](const Rect& text) { return text.meets(box); }))
        return false;
    text(x, y, words, style);
    return true;
}

std::string Svg::file(double height, const std::string& defs) const {
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
        "width=\"{0:g}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:g} {1:.0f}\" "
        "font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\">\n<defs>{2}</defs>\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n{3}{4}</svg>\n",
        width_, height, defs, behind_, body_);
}

} // namespace isomotion::topology
