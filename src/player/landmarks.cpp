#include "player/landmarks.h"

#include <optional>
#include <utility>

#include <imgui.h>

namespace isomotion::player {
namespace {

// As Dear ImGui's own: there is one of it, of the main thread.
std::optional<Landmarks> noted;

} // namespace

void landmark(const std::string& name) {
    if (!noted) return;
    const ImVec2 low = ImGui::GetItemRectMin(), size = ImGui::GetItemRectSize();
    const ImVec2 pixel = ImGui::GetIO().DisplayFramebufferScale;
    (*noted)[name] = {int(low.x * pixel.x), int(low.y * pixel.y), int(size.x * pixel.x),
                      int(size.y * pixel.y)};
}

void note_landmarks() { noted.emplace(); }

Landmarks take_landmarks() { return noted ? std::exchange(*noted, Landmarks{}) : Landmarks{}; }

} // namespace isomotion::player
