// Reads the [material] of a scene: how its surface reflects light.
#pragma once

#include "scene/reading/color.h"
#include "scene/reading/contours.h"
#include "scene/reading/paint.h"
#include "scene/reading/surface.h"

namespace isomotion::scene {

// The section as read before the field exists.
struct MaterialParts {
    Material material; // without its expressions
    ColorParts color;
    std::optional<PaintParts> colormap;
    std::optional<ContourParts> contours;
};

// Reads the section and adds its tracks. The catalogue provides colours that the scene leaves out;
// a model and its values come only from the scene.
MaterialParts read_material(Section& document, const SurfaceParts& parts, TrackTable& tracks);

// Compiles the material's expressions with the names of the surface.
void make_paints(const MaterialParts& parts, const SurfaceParts& surface,
                 const animation::Animation& animation, Material& material);
// The paints that the material has.
std::vector<const formula::Paint*> paints_of(const Material& material);

} // namespace isomotion::scene
