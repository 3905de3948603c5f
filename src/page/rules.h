// What follows a slider: the expressions by which a formula's parameters, the bounds and the
// elements of arrays depend on one another, as instructions that web/rules.js runs.
//
// All else that an expression may say of a parameter (the camera, lights, colours) stays as the
// animation has it.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "scene/scene.h"

namespace isomotion::page {

// Whether what depends on the parameter can be worked out on a page: not where an element's field
// is made of a column of a file that the shaders do not read.
bool can_be_held(const scene::Scene& scene, int track);

// {"seed": decimal text, "tracks": [[place, program]], "bounds": [[number of the bounds, program]],
//  "arrays": [[field]]}, each after what it depends on. The numbers of bounds are a sphere's centre
// and radius or a box's corners. A field is {"slot": place among what shaders read, or -1} with
// "program", "values" or neither, where it is a column; its siblings are numbered in this order.
// A program is {"code": [[result, operation, operands...]], "out": register, "tracks": [those that
// it names]}.
nlohmann::ordered_json rules_of(const scene::Scene& scene);

} // namespace isomotion::page
