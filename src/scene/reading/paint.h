// Reads the [material.colormap] of a scene.
#pragma once

#include "scene/reading/document.h"
#include "scene/reading/surface.h"
#include "scene/reading/track_table.h"
#include "scene/scene.h"

namespace isomotion::scene {

// The section as read before the field exists.
struct PaintParts {
    Paint paint;                      // without its expression
    std::optional<std::string> value; // none if it is wrong
    const toml::node* value_node = nullptr;
    std::string value_key, range_key; // for messages
    // The node of `range = "auto"`, the range that the surface shows; null for another range.
    const toml::node* shown_node = nullptr;
};

// Reads the section and adds the tracks of the range.
PaintParts read_paint(Section section, TrackTable& tracks);

// Refuses an expression with too many operations at one point; the field has the same check.
void check_work(const formula::Paint& paint, const SurfaceParts& surface, const toml::node& node,
                const std::string& key);

// Parses the expression against the surface's names.
Paint make_paint(const PaintParts& parts, const SurfaceParts& surface);

// Sets the range of the surface's paint to the values that it shows, if the scene asks for that.
// Call it after all else is read.
void find_shown_range(const PaintParts& parts, const OneSurface& one, Paint& paint);

} // namespace isomotion::scene
