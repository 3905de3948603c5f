// Proves Betti numbers of one frame.
//
// The box of the bounds is halved in all directions until each part is free of the surface (the
// interval of G doesn't hold 0), or the gradients at any two of its points differ by less than a
// right angle (Plantinga and Vegter 2004). Then the surface is isotopic to that of the piecewise
// linear interpolant on the grid of the planes of all parts' faces, and the Betti numbers are those
// of the grid's signs. The proof is in docs/topology-frames.md.
//
// The solid is the part of {G < 0} within the bounds, with G as in frame_field.h. A surface may
// reach the bounds; if it reaches a sphere, the ball is taken for a cube (ball_as_cube.h). What
// this doesn't prove, cells may (cell_frame.h).
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "scene/scene_at.h"
#include "topology/field/frame_field.h"
#include "topology/timeline/betti.h"

namespace isomotion::topology {

// Why a frame is not proved: CertifiedFrame::why.
inline constexpr const char not_settled[] =
    "the surface is singular, or finer than the smallest box of the proof";
inline constexpr const char too_many_boxes[] =
    "the proof takes too many boxes, as where the surface is close to singular along a curve";

struct CertifiedFrame {
    std::optional<Betti> betti;
    int depth = 0; // of the smallest part: its sides are those of the box, divided by 2^depth
    int boxes = 0;
    bool is_by_cells = false; // which takes several times as long
    std::string why;          // if there are no Betti numbers: what could not be proved
    SpaceBox where;           // and where
};

struct FrameLimits {
    int depth = 14; // at most 14
    int boxes = 4'000'000;
    std::size_t cells = std::size_t(-1); // at most, and no more than cells take anyway
    std::function<bool()> stopped{};     // called often; once it returns true nothing is proved
};

CertifiedFrame certify_frame(const SpaceFormula& formula, const scene::BoundsAt& bounds,
                             const FrameLimits& limits = {});

} // namespace isomotion::topology
