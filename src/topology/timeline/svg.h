// A picture as SVG text that knows where its labels are.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace isomotion::topology {

// A rectangle in a picture, in the picture's units; y counts down.
struct Rect {
    double left = 0, top = 0, right = 0, bottom = 0;

    bool meets(const Rect& other) const {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
};

enum class Anchor { start, middle, end };

struct TextStyle {
    double size = 12;
    Anchor anchor = Anchor::start;
    const char* fill = "#222";
    bool is_bold = false;
};

// At least what the text takes in DejaVu Sans, the widest of the fonts that pictures name.
double text_width(std::string_view utf8, double size, bool is_bold = false);
// The text, or as much of its beginning as is not wider, and an ellipsis.
std::string cut_to(const std::string& utf8, double width, double size, bool is_bold = false);
// Lines that are not wider, broken at spaces; a longer word is cut. At most `most`: the last one
// ends in an ellipsis where there was more.
std::vector<std::string> wrapped(const std::string& utf8, double width, double size,
                                 std::size_t most);
// The text with the characters that mean something in SVG written out.
std::string escaped(const std::string& text);

class Svg {
public:
    explicit Svg(double width)
        : width_(width) {}

    double width() const { return width_; }

    template<class... Args> void draw(fmt::format_string<Args...> format, Args&&... args) {
        body_ += fmt::format(format, std::forward<Args>(args)...) + "\n";
    }
    // Draws under all else.
    template<class... Args> void draw_behind(fmt::format_string<Args...> format, Args&&... args) {
        behind_ += fmt::format(format, std::forward<Args>(args)...) + "\n";
    }
    // `y` is that of the base line.
    void text(double x, double y, const std::string& words, const TextStyle& style = {});
    // Only where it is within the picture's width and meets no other text. Whether it was drawn.
    bool text_where_free(double x, double y, const std::string& words, const TextStyle& style = {});

    // The whole file. `defs`: what <defs> holds.
    std::string file(double height, const std::string& defs) const;

private:
    double width_;
    std::string behind_, body_;
    std::vector<Rect> texts_;
};

} // namespace isomotion::topology
