// Colour maps: colours for numbers from 0 to 1.
#pragma once

namespace isomotion::scene {

// Both maps have steps of equal size in OKLab. Lightness alone tells their colours apart, so they
// work in every kind of colour blindness.
enum class ColorMap {
    blue_yellow, // sequential: from dark to light
    blue_orange, // diverging: light in the middle, for signed numbers
};

} // namespace isomotion::scene
