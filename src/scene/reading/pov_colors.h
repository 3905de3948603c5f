// The colours that colors.inc of POV-Ray names.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace isomotion::scene {

// Red, green, blue, and the part of light that passes.
std::optional<std::array<double, 4>> pov_color(const std::string& name);

// Words that begin a colour: rgb, color, red.
bool is_pov_color_word(std::string_view word);
// Which part of a colour a word states: 0 to 4 for red, green, blue, filter and transmit, else -1.
int pov_color_part(std::string_view word);

} // namespace isomotion::scene
