// The rules by which values follow a slider: the expressions that relate a formula's parameters,
// the bounds and the elements of arrays, as instructions that web/rules.js runs.
//
// Other values that depend on a parameter (the camera, lights, colours) stay as the animation has
// them.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "scene/scene.h"

namespace isomotion::page {

// Whether a page can evaluate what depends on the parameter. It can't if an element's field depends
// on a column of a file that the shaders do not read.
bool can_be_held(const scene::Scene& scene, int track);

// {"seed": decimal text, "tracks": [[place, program]], "bounds": [[number of the bounds, program]],
//  "arrays": [[field]]}, with each entry after those it depends on. The numbers of bounds are a
// sphere's centre and radius or a box's corners. A field is {"slot": place among the fields that
// shaders read, or -1}, with "program" or "values", or with neither if it is a column. The fields
// of an array are numbered in this order. A program is {"code": [[result, operation, operands...]],
// "out": register, "tracks": [the tracks that it names]}.
nlohmann::ordered_json rules_of(const scene::Scene& scene);

} // namespace isomotion::page
