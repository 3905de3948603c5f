// Fingerprints of animation: of what a scene file states, not of the values that result.
#pragma once

#include "animation/animation.h"
#include "base/fingerprint.h"

namespace isomotion::scene {

// A track's name tells what it moves: "camera.position.x", "lights[1].falloff". The fingerprint
// uses the key's first name, so that sequences and timelines outlive a renaming.
void add(base::Fingerprint& print, const animation::Track& track);
// Includes the columns of a table that something reads.
void add_array(base::Fingerprint& print, const animation::Animation& animation, std::size_t index);

} // namespace isomotion::scene
