// Detects values by which F has no bounds or may jump anywhere: a radius of 0 that one element of a
// sum is divided by.
#pragma once

#include <optional>
#include <string>

#include "scene/scene_at.h"

namespace isomotion::probe {

// "ring.toml:9: arrays.p.r[2] is 0 at t = 0: ...", if intervals show at none of the tried points of
// the bounds that F has bounds and is continuous, and some values are the reason. No method that
// goes by bounds finds a zero then, and nothing is proved.
std::optional<std::string> why_unbounded(const scene::OneSurface& one, const scene::SurfaceAt& now);

} // namespace isomotion::probe
