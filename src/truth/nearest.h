// The first root on a ray that meets several surfaces, from the certified ones on each.
//
// A pixel's ray is one in the world and has coordinates of its own for each surface. What is said
// of all is said in those of the first.
#pragma once

#include <span>
#include <vector>

#include "scene/scene_at.h"
#include "truth/first_root.h"
#include "truth/tube.h"

namespace isomotion::truth {

// The rays of a picture as each surface has them.
class RaysOfSurfaces {
public:
    RaysOfSurfaces(const scene::SceneAt& now, int width, int height, const scene::Aim& aim = {});

    std::size_t surfaces() const { return tubes_.size(); }
    const Tubes& of(std::size_t surface) const { return tubes_[surface]; }

    // The first of the surfaces' own first roots on a pixel's ray.
    FirstRoot nearest(int column, int row, std::span<const FirstRoot> of_surfaces) const;

private:
    std::vector<scene::PlacementAt> places_;
    std::vector<Tubes> tubes_;
};

// The first of roots on one ray. `apart`: how far before all others one must be for `surface` to
// tell which it is of.
FirstRoot nearest(std::span<const FirstRoot> roots, double apart);

} // namespace isomotion::truth
