// Reads the [time] of a scene.
#pragma once

#include <cstdint>

#include "animation/timeline.h"
#include "scene/reading/document.h"

namespace isomotion::scene {

struct TimeParts {
    animation::Timeline timeline;
    std::uint64_t seed = 0; // of random numbers in expressions
};

TimeParts read_time(Section& document);

} // namespace isomotion::scene
