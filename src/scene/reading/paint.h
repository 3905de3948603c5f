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
    std::string value_key, range_key;       // for messages
    const toml::node* shown_node = nullptr; // of the range, where it is what the surface shows
};

// Reads the section and adds the tracks of the range.
PaintParts read_paint(Section section, TrackTable& tracks);

// Refuses what takes too many operations at one point, as is done of the field.
void check_work(const formula::Paint& paint, const SurfaceParts& surface, const toml::node& node,
                const std::string& key);

// Parses the expression against the surface's names.
Paint make_paint(const PaintParts& parts, const SurfaceParts& surface);

// Sets what the surface shows as the paint's range, where that is asked for: once all else is read.
void find_shown_range(const PaintParts& parts, Scene& scene);

} // namespace isomotion::scene
