// Fingerprints of how things move: of what a scene file says, not of the values it gives.
#pragma once

#include "animation/animation.h"
#include "base/fingerprint.h"

namespace isomotion::scene {

void add(base::Fingerprint& print, const animation::TrackSource& source);
void add(base::Fingerprint& print, const animation::Array& array);

} // namespace isomotion::scene
