// Reads the [isolation] of a scene: how its roots are found.
#pragma once

#include "scene/reading/document.h"
#include "scene/scene.h"

namespace isomotion::scene {

// False where no value was given.
struct GivenThresholds {
    bool step = false, near = false, far = false, horizon = false;
};

// Call it for the catalogue's settings first, then for the scene's own, which go before these.
void read_isolation(Section& sections, Isolation& isolation, GivenThresholds& given);

} // namespace isomotion::scene
