// The size of the smallest elements of a scene's array, which a ray must not step over.
//
// Between small blobs their sum is constant, so samples don't show a blob that lies between two of
// them. An element's own size does. Bounds of F over ever smaller boxes lead to the place where the
// element matters most, and F around that place gives its size.
#pragma once

#include <optional>

#include "scene/scene_at.h"

namespace isomotion::render {

// The least distance, among an even selection of elements, from the place where an element changes
// F most to the place further out where F without the others is 0; or to the place of half its
// change, if it is too weak to take F to 0. Infinite if the scene has no array or several, or if
// all its elements reach a quarter of the bounds' radius; never less than a 64th of that. Takes
// some hundred evaluations of F with one element for each.
double least_element_radius(const formula::Field& field, const scene::SurfaceAt& now);

// The same, cached as long as the elements and the bounds stay, since a frame consists of many
// pictures, one for each sample of a pixel.
class ElementRadius {
public:
    double least(const formula::Field& field, const scene::SurfaceAt& now);

private:
    struct Known {
        formula::Bindings<float> elements;
        scene::BoundsAt bounds;
        double least;
    };
    std::optional<Known> known_;
};

} // namespace isomotion::render
