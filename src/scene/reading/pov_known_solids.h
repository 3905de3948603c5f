// The objects that shapes.inc and shapesq.inc of POV-Ray declare.
#pragma once

#include <optional>
#include <string>

#include "scene/reading/pov_solids.h"

namespace isomotion::scene {

std::optional<PovSolid> known_pov_solid(const std::string& name);

} // namespace isomotion::scene
