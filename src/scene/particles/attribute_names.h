// Names of columns for the components of a file's attributes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace isomotion::scene {

// Adds the names of an attribute's components. Attributes with usual names get short ones: x y z
// for a position, vx vy vz for a velocity, r g b for a colour, nx ny nz for a normal, id for ids.
// Other attributes get their own name, or name_0, name_1, ...; so do those whose short names are
// taken.
void add_names(std::vector<std::string>& names, std::string_view attribute, std::size_t components);

// The names of columns in a file without names: x y z [vx vy vz [c6 ...]], or x y z c3 ...
std::vector<std::string> names_without_names(std::size_t columns);

} // namespace isomotion::scene
