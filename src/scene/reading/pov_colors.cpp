#include "scene/reading/pov_colors.h"

#include <algorithm>
#include <cctype>
#include <iterator>

namespace isomotion::scene {
namespace {

struct NamedColor {
    std::string_view name;
    double red, green, blue;
};

constexpr NamedColor named_colors[] = {
    {"White", 1, 1, 1},
    {"Black", 0, 0, 0},
    {"Red", 1, 0, 0},
    {"Green", 0, 1, 0},
    {"Blue", 0, 0, 1},
    {"Yellow", 1, 1, 0},
    {"Cyan", 0, 1, 1},
    {"Magenta", 1, 0, 1},
    {"Orange", 1, 0.5, 0},
    {"OrangeRed", 1, 0.25, 0},
    {"Coral", 1, 0.498039, 0},
    {"Gold", 0.8, 0.498039, 0.196078},
    {"OldGold", 0.81, 0.71, 0.23},
    {"BrightGold", 0.85, 0.85, 0.1},
    {"Silver", 0.9, 0.91, 0.98},
    {"Copper", 0.72, 0.45, 0.2},
    {"Brass", 0.71, 0.65, 0.26},
    {"Bronze", 0.55, 0.47, 0.14},
    {"Gray", 0.752941, 0.752941, 0.752941},
    {"DimGray", 0.329412, 0.329412, 0.329412},
    {"LightGray", 0.658824, 0.658824, 0.658824},
    {"VLightGray", 0.8, 0.8, 0.8},
    {"Aquamarine", 0.439216, 0.858824, 0.576471},
    {"Brown", 0.647059, 0.164706, 0.164706},
    {"CadetBlue", 0.372549, 0.623529, 0.623529},
    {"DarkGreen", 0.184314, 0.309804, 0.184314},
    {"DarkOrchid", 0.6, 0.196078, 0.8},
    {"DarkTurquoise", 0.439216, 0.576471, 0.858824},
    {"Firebrick", 0.556863, 0.137255, 0.137255},
    {"ForestGreen", 0.137255, 0.556863, 0.137255},
    {"Goldenrod", 0.858824, 0.858824, 0.439216},
    {"GreenYellow", 0.576471, 0.858824, 0.439216},
    {"Khaki", 0.623529, 0.623529, 0.372549},
    {"LightBlue", 0.74902, 0.847059, 0.847059},
    {"LightSteelBlue", 0.560784, 0.560784, 0.737255},
    {"LimeGreen", 0.196078, 0.8, 0.196078},
    {"Maroon", 0.556863, 0.137255, 0.419608},
    {"MediumBlue", 0.196078, 0.196078, 0.8},
    {"MediumTurquoise", 0.439216, 0.858824, 0.858824},
    {"MidnightBlue", 0.184314, 0.184314, 0.309804},
    {"Navy", 0.137255, 0.137255, 0.556863},
    {"NavyBlue", 0.137255, 0.137255, 0.556863},
    {"Orchid", 0.858824, 0.439216, 0.858824},
    {"Pink", 0.737255, 0.560784, 0.560784},
    {"Plum", 0.917647, 0.678431, 0.917647},
    {"Salmon", 0.435294, 0.258824, 0.258824},
    {"Scarlet", 0.55, 0.09, 0.09},
    {"SeaGreen", 0.137255, 0.556863, 0.419608},
    {"Sienna", 0.556863, 0.419608, 0.137255},
    {"SkyBlue", 0.196078, 0.6, 0.8},
    {"SlateBlue", 0, 0.498039, 1},
    {"SpringGreen", 0, 1, 0.498039},
    {"SteelBlue", 0.137255, 0.419608, 0.556863},
    {"SummerSky", 0.22, 0.69, 0.87},
    {"Tan", 0.858824, 0.576471, 0.439216},
    {"Thistle", 0.847059, 0.74902, 0.847059},
    {"Turquoise", 0.678431, 0.917647, 0.917647},
    {"Violet", 0.309804, 0.184314, 0.309804},
    {"VioletRed", 0.8, 0.196078, 0.6},
    {"Wheat", 0.847059, 0.847059, 0.74902},
    {"YellowGreen", 0.6, 0.8, 0.196078},
};

} // namespace

std::optional<std::array<double, 4>> pov_color(const std::string& name) {
    if (name == "Clear") return std::array{1.0, 1.0, 1.0, 1.0};
    // Gray05 to Gray95, in steps of five hundredths.
    if (name.size() == 6 && name.starts_with("Gray") && std::isdigit(name[4]) &&
        (name[5] == '0' || name[5] == '5')) {
        const double part = ((name[4] - '0') * 10 + (name[5] - '0')) / 100.0;
        if (part > 0) return std::array{part, part, part, 0.0};
    }
    std::string american = name;
    if (name.ends_with("Grey")) american.replace(name.size() - 4, 4, "Gray");
    const auto* const found = std::ranges::find(named_colors, american, &NamedColor::name);
    if (found == std::end(named_colors)) return std::nullopt;
    return std::array{found->red, found->green, found->blue, 0.0};
}

int pov_color_part(std::string_view word) {
    static constexpr std::string_view parts[] = {"red", "green", "blue", "filter", "transmit"};
    const auto* const found = std::ranges::find(parts, word);
    return found == std::end(parts) ? -1 : int(found - std::begin(parts));
}

bool is_pov_color_word(std::string_view word) {
    return word == "rgb" || word == "rgbf" || word == "rgbt" || word == "rgbft" ||
           word == "color" || word == "colour" || word == "srgb" || pov_color_part(word) >= 0;
}

} // namespace isomotion::scene
