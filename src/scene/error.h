#pragma once

#include "base/input_error.h"

namespace isomotion::scene {

// A mistake in a scene.
using SceneError = base::InputError;

} // namespace isomotion::scene
