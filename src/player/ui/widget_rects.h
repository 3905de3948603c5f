// The places of widgets, for programs that control the window from outside: tests, and tools that
// record it.
#pragma once

#include <array>
#include <map>
#include <string>

namespace isomotion::player {

// Rectangles in pixels of the window: left, top, width, height.
using WidgetRects = std::map<std::string, std::array<int, 4>>;

// Records the place of the last widget; has no effect before recording has started.
void record_widget_rect(const std::string& name);

void start_recording_widget_rects();
// The places recorded since the last call.
WidgetRects take_widget_rects();

} // namespace isomotion::player
