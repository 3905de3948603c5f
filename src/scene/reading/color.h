// Reads the color of a scene's material: three animated values, or expressions of the place.
#pragma once

#include <optional>

#include "formula/paint.h"
#include "scene/reading/document.h"
#include "scene/reading/surface.h"
#include "scene/reading/track_table.h"

namespace isomotion::scene {

// The colour as read before the field exists.
struct ColorParts {
    Vec3Track tracks{};
    formula::ColorTexts of_place{}; // components that depend on the place
    bool is_given = false;          // by the scene itself
    const toml::node* node = nullptr;
    std::string key;

    bool is_of_place() const { return of_place[0] || of_place[1] || of_place[2]; }
};

// Adds the tracks; components that depend on the place get 0. An expression depends on the place if
// it can't be evaluated from the time alone.
ColorParts read_color(const toml::node& node, const std::string& key, const SurfaceParts& parts,
                      TrackTable& tracks);

// The colour at every place; null if it is the same everywhere. If the scene gives none, and the
// formula sums over an array with fields r, g and b (or red, green and blue from 0 to 255) that
// nothing else reads, the colour is their mean.
std::shared_ptr<const formula::Paint> make_color(const ColorParts& color,
                                                 const SurfaceParts& parts);

} // namespace isomotion::scene
