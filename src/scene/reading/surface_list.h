// The [[surfaces]] of a document: each is read as a document of that surface alone, in which what
// is its own goes before what all share.
#pragma once

#include <set>
#include <string>
#include <vector>

#include <toml++/toml.h>

namespace isomotion::scene {

// The sections that a listed surface may have itself.
inline constexpr const char* own_sections[] = {"parameters", "arrays", "material", "isolation"};

bool lists_surfaces(const toml::table& document);

// What the surfaces are called: their names, else their numbers. Throws PlacedError for a list that
// is none, is too long or has a name twice, and for a [surface] beside it.
std::vector<std::string> listed_names(const toml::table& document);

// The listed surface of this name or number, or null.
toml::table* listed_surface(toml::table& document, const std::string& name);

// Leaves of the document one surface, and what all share.
void keep_surface(toml::table& document, std::size_t index);

// Names in [parameters], and those that the surface has itself.
std::set<std::string> shared_parameters(const toml::table& document);
std::set<std::string> own_parameters(const toml::table& document, std::size_t index);

// --set name=value: puts it where surfaces have a parameter of this name themselves. Whether that
// is all, as nothing else has it.
bool put_own_parameter(toml::table& document, const std::string& name, const toml::node& value);

} // namespace isomotion::scene
