// Where widgets are, for those who drive the window from outside: tests, and tools that record it.
#pragma once

#include <array>
#include <map>
#include <string>

namespace isomotion::player {

// Pixels of the window: left, top, width, height.
using Landmarks = std::map<std::string, std::array<int, 4>>;

// The widget made last is called so. Noted only where somebody asks.
void landmark(const std::string& name);

// From now on they are noted; until then landmark() does nothing.
void note_landmarks();
// Those since the last call.
Landmarks take_landmarks();

} // namespace isomotion::player
