#include "player/ui/covering.h"

#include <algorithm>

namespace isomotion::player {
namespace {

// Whether something that a command draws lies within the rectangle.
bool reaches(const ImDrawList& list, const ImDrawCmd& command, ImVec2 low, ImVec2 high) {
    low = {std::max(low.x, command.ClipRect.x), std::max(low.y, command.ClipRect.y)};
    high = {std::min(high.x, command.ClipRect.z), std::min(high.y, command.ClipRect.w)};
    if (low.x >= high.x || low.y >= high.y) return false;
    for (unsigned k = 0; k + 2 < command.ElemCount; k += 3) {
        ImVec2 least{1e30f, 1e30f}, most{-1e30f, -1e30f};
        for (unsigned corner = 0; corner < 3; ++corner) {
            const int at = int(command.IdxOffset + k + corner);
            const ImVec2 p = list.VtxBuffer[int(command.VtxOffset) + list.IdxBuffer[at]].pos;
            least = {std::min(least.x, p.x), std::min(least.y, p.y)};
            most = {std::max(most.x, p.x), std::max(most.y, p.y)};
        }
        if (least.x < high.x && most.x > low.x && least.y < high.y && most.y > low.y) return true;
    }
    return false;
}

} // namespace

bool is_covered(const ImDrawData& frame, ImVec2 low, ImVec2 high) {
    for (int k = 0; k < frame.CmdListsCount; ++k) {
        const ImDrawList& list = *frame.CmdLists[k];
        for (const ImDrawCmd& command : list.CmdBuffer) {
            if (command.UserCallback || reaches(list, command, low, high)) return true;
        }
    }
    return false;
}

} // namespace isomotion::player
