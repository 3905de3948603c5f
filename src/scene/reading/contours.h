// Reads the [material.contours] of a scene.
#pragma once

#include "scene/reading/document.h"
#include "scene/reading/surface.h"
#include "scene/reading/track_table.h"
#include "scene/scene.h"

namespace isomotion::scene {

// The section as read before the field exists.
struct ContourParts {
    Contours contours;                // without its expression
    std::optional<std::string> value; // none if it is wrong
    const toml::node* value_node = nullptr;
    std::string value_key; // for messages
};

// Reads the section and adds its tracks.
ContourParts read_contours(Section section, TrackTable& tracks);

// Parses the expression against the surface's names.
Contours make_contours(const ContourParts& parts, const SurfaceParts& surface);

} // namespace isomotion::scene
