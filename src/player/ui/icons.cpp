#include "player/ui/icons.h"

#include <imgui.h>

#include "player/ui/theme.h"
#include "player/ui/widget_rects.h"

namespace isomotion::player {
namespace {

class Pen {
public:
    Pen(ImVec2 middle, float radius, unsigned color)
        : list_(*ImGui::GetWindowDrawList())
        , middle_(middle)
        , radius_(radius)
        , color_(color) {}

    // Lengths are in radii from the middle, x to the right and y down.
    void triangle(float tip, float base, float half) {
        const ImVec2 a = at(tip, 0), b = at(base, -half), c = at(base, half);
        if (tip > base) {
            list_.AddTriangleFilled(a, c, b, color_);
        } else {
            list_.AddTriangleFilled(a, b, c, color_);
        }
    }
    void bar(float from, float to, float half) {
        list_.AddRectFilled(at(from, -half), at(to, half), color_);
    }
    void circular_arrow() {
        constexpr float begin = -0.9f, end = 4.6f;
        list_.PathArcTo(middle_, 0.72f * radius_, begin, end, 24);
        list_.PathStroke(color_, 0, 0.2f * radius_);
        const ImVec2 tip = at(0.62f, -0.98f), left = at(0.02f, -0.55f), right = at(0.72f, -0.22f);
        list_.AddTriangleFilled(tip, right, left, color_);
    }

private:
    ImVec2 at(float x, float y) const { return {middle_.x + x * radius_, middle_.y + y * radius_}; }

    ImDrawList& list_;
    ImVec2 middle_;
    float radius_;
    unsigned color_;
};

void draw(Icon icon, Pen pen) {
    switch (icon) {
    case Icon::play:
        return pen.triangle(0.95f, -0.65f, 0.95f);
    case Icon::pause:
        pen.bar(-0.7f, -0.2f, 0.85f);
        return pen.bar(0.2f, 0.7f, 0.85f);
    case Icon::first:
        pen.bar(-0.9f, -0.62f, 0.8f);
        return pen.triangle(-0.55f, 0.75f, 0.8f);
    case Icon::last:
        pen.triangle(0.55f, -0.75f, 0.8f);
        return pen.bar(0.62f, 0.9f, 0.8f);
    case Icon::back:
        pen.triangle(-0.65f, 0.25f, 0.7f);
        return pen.bar(0.4f, 0.65f, 0.7f);
    case Icon::forward:
        pen.bar(-0.65f, -0.4f, 0.7f);
        return pen.triangle(0.65f, -0.25f, 0.7f);
    case Icon::loop:
        return pen.circular_arrow();
    }
}

} // namespace

bool icon_button(const char* id, Icon icon, bool lit, const char* tip) {
    const float side = ImGui::GetFrameHeight();
    ImGui::PushID(id);
    const bool clicked = ImGui::Button("##icon", {1.25f * side, side});
    ImGui::PopID();
    record_widget_rect(id);
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const ImVec2 middle{0.5f * (low.x + high.x), 0.5f * (low.y + high.y)};
    draw(icon, Pen(middle, 0.24f * side, lit ? accent_color() : text_color()));
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", tip);
    return clicked;
}

} // namespace isomotion::player
