// Unpacks gzip.
#pragma once

#include <string>
#include <string_view>

#include "scene/particles/particle_table.h"

namespace isomotion::scene {

bool is_gzip(std::string_view bytes);

// Throws SceneError if the data is cut off or damaged, or has more than `most` bytes. With
// request.count_alone it returns the first `most` bytes, or all if there are fewer.
std::string gunzip(const ParticleRequest& request, std::string_view packed, std::size_t most);

} // namespace isomotion::scene
