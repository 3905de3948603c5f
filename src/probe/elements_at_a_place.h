// How many elements of an array matter at a place. It decides how shaders find them.
#pragma once

#include <optional>

#include "scene/scene.h"

namespace isomotion::probe {

// The mean over some frames, and over the cells of a grid of elements that are not empty, for the
// array with the most elements. None if that has few elements or very many, or if its sums' terms
// are no kernels of a distance.
std::optional<double> elements_at_a_place(const scene::OneSurface& one);

} // namespace isomotion::probe
