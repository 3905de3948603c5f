#include "player/ui/widget_rects.h"

#include <optional>
#include <utility>

#include <imgui.h>

namespace isomotion::player {
namespace {

// Global as Dear ImGui's own state is; only the main thread uses it.
std::optional<WidgetRects> recorded;

} // namespace

void record_widget_rect(const std::string& name) {
    if (!recorded) return;
    const ImVec2 low = ImGui::GetItemRectMin(), size = ImGui::GetItemRectSize();
    const ImVec2 pixel = ImGui::GetIO().DisplayFramebufferScale;
    (*recorded)[name] = {int(low.x * pixel.x), int(low.y * pixel.y), int(size.x * pixel.x),
                         int(size.y * pixel.y)};
}

void start_recording_widget_rects() { recorded.emplace(); }

WidgetRects take_widget_rects() {
    return recorded ? std::exchange(*recorded, WidgetRects{}) : WidgetRects{};
}

} // namespace isomotion::player
