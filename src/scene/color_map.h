// Colour maps: colours for numbers from 0 to 1.
#pragma once

#include <optional>
#include <string_view>

namespace isomotion::scene {

// Both maps have steps of equal size in OKLab. Lightness alone tells their colours apart, so they
// work in every kind of colour blindness.
enum class ColorMap {
    blue_yellow, // sequential: from dark to light
    blue_orange, // diverging: light in the middle, for signed numbers
};

struct ColorMapName {
    ColorMap map;
    std::string_view name;
};

inline constexpr ColorMapName color_map_names[] = {
    {ColorMap::blue_yellow, "blue-yellow"},
    {ColorMap::blue_orange, "blue-orange"},
};

constexpr std::optional<ColorMap> parse_color_map(std::string_view text) {
    for (const auto& entry : color_map_names) {
        if (entry.name == text) return entry.map;
    }
    return std::nullopt;
}

} // namespace isomotion::scene
