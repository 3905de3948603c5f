// Contact of two surfaces in words.
#pragma once

#include <array>
#include <functional>
#include <string>

#include "animation/timeline.h"
#include "topology/timeline/event.h"

namespace isomotion::topology {

struct NamedPair {
    std::string first, second;
    // A place, in the first one's coordinates at that time (seconds), in the world's.
    std::function<std::array<double, 3>(double time, const std::array<double, 3>& place)> to_world;
};

// Lines: when and where the two touch and part, by a timeline of what they have in common
// (analyse_contact); whether that is all and proved, or the reasons why not.
std::string contact_text(const NamedPair& pair, const Timeline& timeline, animation::FrameRate fps);

} // namespace isomotion::topology
