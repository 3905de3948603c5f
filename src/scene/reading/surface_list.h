// The [[surfaces]] of a document. Each is read with what all share, over which its own values go.
#pragma once

#include <set>
#include <string>
#include <vector>

#include <toml++/toml.h>

#include "scene/reading/mistakes.h"

namespace isomotion::scene {

// The sections that a listed surface may have itself.
inline constexpr const char* own_sections[] = {"parameters", "arrays", "material", "isolation"};

bool lists_surfaces(const toml::table& document);

// The surfaces' names, or numbers if they have none, or a wrong one, which is told. Throws
// PlacedError if the list is not a list or is too long, and if there is a [surface] beside it.
std::vector<std::string> listed_names(toml::table& document, MistakeList& mistakes);

// The listed surface with this name or number, or null.
toml::table* listed_surface(toml::table& document, const std::string& name);

// The table of the surface with that index.
toml::table& listed(toml::table& document, std::size_t index);

// Names in [parameters], and names that the surface has itself.
std::set<std::string> shared_parameters(const toml::table& document);
std::set<std::string> own_parameters(toml::table& document, std::size_t index);

// --set name=value: sets the value in surfaces that have a parameter of this name themselves.
// Returns whether that is all, because nothing else has the name.
bool put_own_parameter(toml::table& document, const std::string& name, const toml::node& value);

} // namespace isomotion::scene
