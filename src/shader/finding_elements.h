// Chooses how shaders find the elements that matter where they evaluate F: in lists that beams of
// rays make, by place in a grid, or by going through all.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"
#include "shader/assemble.h"
#include "shader/field_text.h"

namespace isomotion::shader {

// `keeps_copies`: where shaders can write no lists, these may be copies.
FieldStorage storage_of_elements(const scene::OneSurface& one, const Drawing& drawing,
                                 bool keeps_copies);

// The same for shaders that go through all elements, wherever they evaluate F.
FieldStorage storage_of_all_elements(const scene::OneSurface& one);

// Numbers of pixels from which on pictures have other shaders than below, since beams are wider in
// small pictures and lists longer: one for each surface of the scene whose elements are found by
// place in smaller pictures.
std::vector<std::int64_t> sizes_of_change(const scene::Scene& scene, const Drawing& drawing = {});

} // namespace isomotion::shader
