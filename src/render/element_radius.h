// How small the elements of a scene's array are, as what a ray must not step over.
//
// Between small blobs a sum of them stands still, and samples of it tell nothing of a blob that
// lies between two. An element's own size does: bounds of F over ever smaller boxes lead to where
// it matters most, and F around that place tells how far it does.
#pragma once

#include <optional>

#include "scene/scene_at.h"

namespace isomotion::render {

// The least distance, of some elements evenly out of all, from where an element changes F most to
// where F without the others comes to 0 on the way out; or to half of its change, where it is too
// weak to take F to 0. Infinite if the scene has no array or several, or if all its elements reach
// a quarter of the bounds' radius; never less than a 64th of that. Takes some hundred evaluations
// of F with one element for each.
double least_element_radius(const scene::Scene& scene, const scene::SceneAt& now);

// The same, remembered for as long as the elements and the bounds stay: a frame is made of many
// pictures, one for each sample of a pixel.
class ElementRadius {
public:
    double least(const scene::Scene& scene, const scene::SceneAt& now);

private:
    struct Known {
        formula::Bindings<float> elements;
        scene::BoundsAt bounds;
        double least;
    };
    std::optional<Known> known_;
};

} // namespace isomotion::render
