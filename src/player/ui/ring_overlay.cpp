#include "player/ui/ring_overlay.h"

#include <algorithm>
#include <cstdlib>
#include <string>

#include <imgui.h>

#include "topology/timeline/kind_mark.h"

namespace isomotion::player {
namespace {

constexpr const char* unresolved_colour = "#b03a00"; // as plots have it

unsigned packed(const char* colour, float opacity) {
    const auto rgb = unsigned(std::strtoul(colour + 1, nullptr, 16));
    return IM_COL32(rgb >> 16, rgb >> 8 & 255, rgb & 255, int(255 * opacity));
}

std::string words_of(const PlacedEvent& event) {
    if (!event.is_resolved) return "unresolved";
    std::string words(event.kind == topology::Kind::unknown ? "unknown"
                                                            : topology::name(event.kind));
    if (!event.is_proved) words += " (not proved)";
    return words;
}

struct Box {
    ImVec2 low, high;
    bool meets(const Box& other) const {
        return low.x < other.high.x && other.low.x < high.x && low.y < other.high.y &&
               other.low.y < high.y;
    }
};

} // namespace

void draw_rings(const std::vector<Ring>& rings, const std::vector<PlacedEvent>& events,
                glm::ivec2 corner, glm::ivec2 size) {
    const ImVec2 pixel = ImGui::GetIO().DisplayFramebufferScale;
    const float font = ImGui::GetFontSize(), radius = 0.75f * font, inset = 0.25f * font;
    const ImVec2 low{float(corner.x) / pixel.x, float(corner.y) / pixel.y};
    const ImVec2 high{float(corner.x + size.x) / pixel.x, float(corner.y + size.y) / pixel.y};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(low, high, true);
    std::vector<ImVec2> places;
    std::vector<Box> taken;
    for (const Ring& ring : rings) {
        const ImVec2 at{(low.x + high.x) / 2 + float(ring.at.x * size.y) / pixel.y,
                        (low.y + high.y) / 2 - float(ring.at.y * size.y) / pixel.y};
        places.push_back(at);
        taken.push_back({{at.x - radius, at.y - radius}, {at.x + radius, at.y + radius}});
    }
    for (std::size_t k = 0; k < rings.size(); ++k) {
        const PlacedEvent& event = events[rings[k].event];
        const ImVec2 at = places[k];
        const float shown = 0.25f + 0.75f * float(rings[k].nearness);
        const char* colour =
            event.is_resolved ? topology::mark_of(event.kind).colour : unresolved_colour;
        // White about it, so that it is seen on any surface.
        list.AddCircle(at, radius, IM_COL32(255, 255, 255, int(230 * shown)), 32, 5);
        list.AddCircle(at, radius, packed(colour, shown), 32, 3);
        const std::string text = words_of(event);
        const ImVec2 room = ImGui::CalcTextSize(text.c_str());
        ImVec2 from{at.x + radius + 2 * inset, at.y - room.y / 2 - inset};
        if (from.x + room.x + 2 * inset > high.x) // to the left of it, where there is an end
            from.x = at.x - radius - 4 * inset - room.x;
        const Box box{from, {from.x + room.x + 2 * inset, from.y + room.y + 2 * inset}};
        if (std::ranges::any_of(taken, [&](const Box& other) { return other.meets(box); }))
            continue;
        taken.push_back(box);
        list.AddRectFilled(box.low, box.high, IM_COL32(255, 255, 255, int(215 * shown)),
                           0.25f * font);
        list.AddText({from.x + inset, from.y + inset}, IM_COL32(20, 20, 24, int(255 * shown)),
                     text.c_str());
    }
    list.PopClipRect();
}

} // namespace isomotion::player
