// The color of a scene's material: three values that move, or expressions of the place.
#pragma once

#include <optional>

#include "formula/paint.h"
#include "scene/reading/document.h"
#include "scene/reading/surface.h"
#include "scene/reading/track_table.h"

namespace isomotion::scene {

// As it is read before the field exists.
struct ColorParts {
    Vec3Track tracks{};
    formula::ColorTexts of_place{}; // the parts that no value over time can say
    bool is_given = false;          // by the scene itself
    const toml::node* node = nullptr;
    std::string key;

    bool is_of_place() const { return of_place[0] || of_place[1] || of_place[2]; }
};

// Adds the tracks; those of parts that are of the place are 0. An expression is of the place where
// it can't be said of the time alone.
ColorParts read_color(const toml::node& node, const std::string& key, const SurfaceParts& parts,
                      TrackTable& tracks);

// The colour at every place; null where it is the same everywhere. Where the scene gives none, and
// an array that the formula sums over has fields r, g and b (or red, green and blue from 0 to 255)
// that nothing else reads, it is their mean.
std::shared_ptr<const formula::Paint> make_color(const ColorParts& color, const SurfaceParts& parts,
                                                 const animation::Animation& animation);

} // namespace isomotion::scene
