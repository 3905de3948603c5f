// Fills the uniform blocks of the shaders from a scene at one time.
#pragma once

#include <limits>
#include <vector>

#include <glm/glm.hpp>

#include "elements/element_grid.h"
#include "formula/tape/tape_cells.h"
#include "scene/rays.h"
#include "scene/scene_at.h"
#include "shader/pass.h"

namespace isomotion::render {

// Block Frame of shaders/frame.glsl.
struct FrameBlock {
    glm::vec4 ray_origin, ray_axis, ray_right, ray_up;
    glm::vec4 bounds_min, bounds_max;
    glm::vec4 picture, thresholds, limits, cubics;
};

// `element_radius`: see element_radius.h; cubics (the method hermite) step at most half of it.
FrameBlock frame_block(const scene::OneSurface& one, const scene::OneSurfaceAt& now, int width,
                       int height, const scene::Aim& aim = {},
                       double element_radius = std::numeric_limits<double>::infinity());

// The multiple of a ray's rounding (scene/ray_rounding.h) by which its beam is thickened: one for
// the ray that is marched; one for the box's own arithmetic, which has no more steps; and one each
// for the ends of pieces, which rays convert to distances of their own, and for those of the
// bounds.
inline constexpr double beam_roundings = 4;

// Uniform `beam` of shaders/march/beam_by_intervals.glsl: the range of tau in which the bounds may
// be, the shortest piece, and `beam_roundings` times the rounding. `block`: pixels across a beam.
glm::vec4 beam_range(const scene::OneSurfaceAt& now, int width, int height, const scene::Aim& aim,
                     int block);

// Block Shading of shaders/shade/shading.glsl; its length depends on the number of lights.
std::vector<glm::vec4> shading_block(const scene::OneSurface& one, const scene::OneSurfaceAt& now,
                                     int width, int height);

// Generated block Parameters: parameter values, the arrays' counts, the grid if there is one, and
// room for the tapes.
std::vector<std::byte> parameter_block(const shader::Passes& passes, const scene::SurfaceAt& now,
                                       const elements::ElementGrid* grid);
// Fills that room.
void describe_tapes(const shader::Passes& passes, const formula::TapeCells& tapes,
                    std::vector<std::byte>& block);

// The elements of array `index`, packed as the field reads them.
std::vector<glm::vec4> array_texels(const formula::Field& field, const shader::Passes& passes,
                                    const scene::SurfaceAt& now, std::size_t index);

} // namespace isomotion::render
