// The usual grammar of frame ranges: "1-10", "1-10x2", "1,3,5-9", "9-5" (downwards).
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace isomotion::animation {

// Frames in the order given, each once. Throws std::invalid_argument with a message for the user.
std::vector<int> parse_frame_range(std::string_view text);

// Such a text, short, for these frames in ascending order: "1-10,12,20-30x2". Empty for none.
std::string frame_range(std::vector<int> frames);

} // namespace isomotion::animation
