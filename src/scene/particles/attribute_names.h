// What the components of a file's attributes are called as columns.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace isomotion::scene {

// Adds the names of an attribute's components: x y z of a position, vx vy vz of a velocity, r g b
// of a colour, nx ny nz of a normal, id of particles' ids, whatever of their usual names they have;
// of others the name, or name_0, name_1, ... So are those whose short names are taken.
void add_names(std::vector<std::string>& names, std::string_view attribute, std::size_t components);

// The names of columns that a file has none for: x y z [vx vy vz [c6 ...]], or x y z c3 ...
std::vector<std::string> names_without_names(std::size_t columns);

} // namespace isomotion::scene
