// The first root on a ray that meets several surfaces, from the certified first root on each.
//
// A pixel's ray is one ray in the world, and has different coordinates for each surface. Results
// are in the coordinates of the first surface.
#pragma once

#include <span>
#include <vector>

#include "roots/first_root.h"
#include "roots/tube.h"
#include "scene/scene_at.h"

namespace isomotion::roots {

// The rays of a picture in each surface's coordinates.
class RaysOfSurfaces {
public:
    RaysOfSurfaces(const scene::SceneAt& now, int width, int height, const scene::Aim& aim = {});

    std::size_t surfaces() const { return tubes_.size(); }
    const Tubes& of(std::size_t surface) const { return tubes_[surface]; }

    // The nearest of the surfaces' own first roots on a pixel's ray.
    FirstRoot nearest(int column, int row, std::span<const FirstRoot> of_surfaces) const;

private:
    std::vector<scene::PlacementAt> places_;
    std::vector<Tubes> tubes_;
};

// The nearest of several roots on one ray. `surface` is known only if the nearest root is at least
// `apart` before all others.
FirstRoot nearest(std::span<const FirstRoot> roots, double apart);

} // namespace isomotion::roots
