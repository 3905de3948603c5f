// Fingerprints of how things move: of what a scene file says, not of the values it gives.
#pragma once

#include "animation/animation.h"
#include "base/fingerprint.h"

namespace isomotion::scene {

// A track's name says what moves by it: "camera.position.x", "lights[1].falloff". The print has it
// as it was first called, so that sequences and timelines outlive a key's renaming.
void add(base::Fingerprint& print, const animation::Track& track);
// With the columns of a table that something reads.
void add_array(base::Fingerprint& print, const animation::Animation& animation, std::size_t index);

} // namespace isomotion::scene
