// The [material.colormap] of a scene.
#pragma once

#include "scene/reading/document.h"
#include "scene/reading/surface.h"
#include "scene/reading/track_table.h"
#include "scene/scene.h"

namespace isomotion::scene {

// The section as it is read before the field exists.
struct PaintParts {
    Paint paint; // without its expression
    std::string value;
    const toml::node* value_node = nullptr;
    std::string value_key; // for messages
    bool takes_shown_range = false;
};

// Reads the section and adds the tracks of the range.
PaintParts read_paint(Section section, TrackTable& tracks);

// Parses the expression against the surface's names.
Paint make_paint(const PaintParts& parts, const SurfaceParts& surface);

} // namespace isomotion::scene
