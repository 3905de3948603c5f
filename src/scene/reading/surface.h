// Reads the [surface], [parameters] and [arrays] of a scene, with those of its catalogue surface.
#pragma once

#include <set>
#include <span>

#include "base/confines.h"
#include "scene/reading/document.h"
#include "scene/reading/track_table.h"
#include "scene/scene.h"

namespace isomotion::scene {

// A surface that is being read.
struct SurfaceParts {
    explicit SurfaceParts(Surface& its_surface)
        : surface(its_surface) {}

    Surface& surface; // the field is made later, when uniform fields have their tracks
    std::optional<std::string> formula{}; // none if it is wrong
    const toml::node* formula_node = nullptr;
    std::string formula_key{}, bounds_key{}; // for messages
    bool lacks_bounds = false;               // which have to be found then
    std::vector<std::string> parameters{};
    std::vector<animation::Array> arrays{};
    bool are_arrays_known = true; // none is wrong as a whole
    formula::Vocabulary vocabulary{};
    std::size_t own_arrays = 0; // those behind them are of terms that the formula repeats
    formula::Origin origin{};   // where the field's coordinates are 0
    std::optional<toml::table> catalogue{}; // the catalogue's file, kept for places and [isolation]
};

// Reads the three sections into `surface`, all but its bounds and transform, and adds their tracks:
// parameters first, then fields that have one value for all elements.
// `section`: [surface], or one of the list; `sections`: those of its parameters and arrays.
std::unique_ptr<SurfaceParts> read_surface(Section& section, Section& sections,
                                           const animation::Timeline& timeline, TrackTable& tracks,
                                           const base::Confines& within, Surface& surface);

// Parses the formula. Terms that it repeats become arrays, behind those of the scene: whoever made
// the animation before makes it again. Returns whether it is right. A mistake is told, and another
// formula stands in for it. There is no field where the formula's names are not known, as an array
// is wrong.
bool make_field(SurfaceParts& parts, TrackTable& tracks, MistakeList& mistakes);

// Adds the array fields that paints read to the data stored for the field.
void store_elements_of(SurfaceParts& parts, std::span<const formula::Paint* const> paints);

// Tells parameters and fields that neither the formula, nor a paint, nor another value uses.
// Other surfaces may use the names in `for_others`; names used here are removed from it.
void refuse_unused(const SurfaceParts& parts, std::span<const formula::Paint* const> paints,
                   const TrackTable& tracks, std::set<std::string>* for_others,
                   MistakeList& mistakes);

} // namespace isomotion::scene
