// What a scene may name, as the reader of scenes takes it.
#pragma once

#include "isomotion/scene.h"
#include "scene/reading/reach.h"

namespace isomotion::api {

inline scene::Reach reach_of(Reach reach) {
    return reach == Reach::anywhere ? scene::Reach::anywhere : scene::Reach::own_folder;
}

} // namespace isomotion::api
