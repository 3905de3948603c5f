// Reads the [material] of a scene: how its surface reflects light.
#pragma once

#include "scene/reading/color.h"
#include "scene/reading/contours.h"
#include "scene/reading/paint.h"
#include "scene/reading/surface.h"

namespace isomotion::scene {

// The section as read before the field exists.
struct MaterialParts {
    ColorParts color;
    std::optional<PaintParts> colormap;
    std::optional<ContourParts> contours;
};

// Reads the section into the surface, without its expressions, and adds its tracks. The catalogue
// provides colours that the scene leaves out; a model and its values come only from the scene.
MaterialParts read_material(Section& sections, SurfaceParts& surface, TrackTable& tracks);

// Compiles the material's expressions with the names of the surface. Mistakes in them are told.
void make_paints(const MaterialParts& parts, SurfaceParts& surface, MistakeList& mistakes);
// The paints that the material has.
std::vector<const formula::Paint*> paints_of(const Material& material);

} // namespace isomotion::scene
