// Betti numbers of one frame, proved.
//
// The box of the bounds is halved in all directions until each part is free of the surface
// (interval of G without 0) or the gradients of any two of its points are less than a right angle
// apart (Plantinga and Vegter 2004). Then the surface is isotopic to that of the piecewise linear
// interpolant on the grid of the smallest part, and Betti numbers are those of the grid's signs.
// The proof of this is in docs/topology-proofs.md.
//
// The solid is what the bounds hold of {G < 0}, G as in frame_field.h. A surface may reach the
// bounds; of one that reaches a sphere cells prove it (cell_frame.h).
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "scene/scene_at.h"
#include "topology/field/frame_field.h"
#include "topology/timeline/betti.h"

namespace isomotion::topology {

struct CertifiedFrame {
    std::optional<Betti> betti;
    int depth = 0; // of the smallest part: the grid has 2^depth cubes in each direction
    int boxes = 0;
    std::string why; // without Betti numbers: what could not be proved
    SpaceBox where;  // and where
};

struct FrameLimits {
    int depth = 10; // at most 10
    int boxes = 4'000'000;
    std::function<bool()> stopped{}; // asked often; once true nothing is proved
};

CertifiedFrame certify_frame(const SpaceFormula& formula, const scene::BoundsAt& bounds,
                             const FrameLimits& limits = {});

} // namespace isomotion::topology
