// What gzip packed.
#pragma once

#include <string>
#include <string_view>

#include "scene/particles/particle_table.h"

namespace isomotion::scene {

bool is_gzip(std::string_view bytes);

// Throws SceneError for what is cut off or damaged, and for more than `most` bytes. With
// request.count_alone the first of `most` bytes, or as many as there are.
std::string gunzip(const ParticleRequest& request, std::string_view packed, std::size_t most);

} // namespace isomotion::scene
