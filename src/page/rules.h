// The rules by which values follow a slider: the expressions that relate a formula's parameters,
// the bounds and the elements of arrays, as instructions that web/rules.js runs.
//
// Other values that depend on a parameter (the camera, lights, colours) stay as the animation has
// them.
#pragma once

#include <cstddef>
#include <set>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "scene/scene.h"

namespace isomotion::page {

// Whether a page can evaluate what depends on the parameter. It can't if an element's field depends
// on a column of a file that the shaders do not read.
bool can_be_held(const scene::Surface& surface, int track);

// The parameters that a program names: tracks, and for a field's program fields of its array.
std::set<int> named_by(const formula::Program& program);
// The fields of an array that the shaders read and those they are made of, each after the latter.
std::vector<std::size_t> fields_in_order(const scene::Surface& surface, std::size_t array);
// A field's place among those that the shaders read, or -1.
int slot_of(const scene::Surface& surface, std::size_t array, std::size_t field);

// The program of a track that is an expression, in the form below.
nlohmann::ordered_json program_of_track(const animation::Animation& animation, int track);

// {"seed": decimal text, "tracks": [[place, program]], "bounds": [[number of the bounds, program]],
//  "arrays": [[field]]}, with each entry after those it depends on. The numbers of bounds are a
// sphere's centre and radius or a box's corners. A field is {"slot": place among the fields that
// shaders read, or -1}, with "program" or "values", or with neither if it is a column. The fields
// of an array are numbered in this order. A program is {"code": [[result, operation, operands...]],
// "out": register, "tracks": [the tracks that it names]}.
nlohmann::ordered_json rules_of(const scene::Surface& surface);

} // namespace isomotion::page
