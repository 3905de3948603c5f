#include "render/uniform_blocks.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <span>

#include "scene/ray_rounding.h"
#include "shader/tape_text.h"

namespace isomotion::render {
namespace {

glm::vec4 wide(const glm::dvec3& v, double w = 0) { return glm::vec4(glm::dvec4(v, w)); }

float not_below(double x) {
    const auto near = float(x);
    return double(near) < x ? std::nextafter(near, HUGE_VALF) : near;
}

} // namespace

FrameBlock frame_block(const scene::OneSurface& one, const scene::OneSurfaceAt& now, int width,
                       int height, const scene::Aim& aim, double element_radius) {
    const scene::Rays rays = scene::rays(now, width, height, aim);
    const scene::Isolation& isolation = one.surface.isolation;
    const bool box = now.surface.bounds.shape == scene::Bounds::Shape::box;
    // The bounds are closed: a root that lies on their very face is one, however its ray is
    // rounded. What is beyond by less than rounding is nobody's to tell.
    const double face = scene::ray_rounding(rays, now.surface.bounds, scene::Norm::length)
                            .at_depth(now.surface.bounds.radius);
    FrameBlock block;
    block.ray_origin = wide(rays.origin);
    block.ray_axis = wide(rays.axis, rays.parallel ? 0 : 1);
    block.ray_right = wide(rays.right);
    block.ray_up = wide(rays.up);
    block.bounds_min = box ? wide(now.surface.bounds.min - face)
                           : wide(now.surface.bounds.centre, now.surface.bounds.radius + face);
    block.bounds_max = wide(now.surface.bounds.max + face);
    block.picture = glm::vec4(2.0 / width, 2.0 / height, 0, 0);
    const double scale = one.surface.field->scale; // of values
    block.thresholds = glm::dvec4(isolation.step, scale * isolation.near, scale * isolation.far,
                                  scale * isolation.horizon);
    const double eighth = 0.125 * now.surface.bounds.radius;
    const formula::CubicSteps& steps = now.surface.cubic_steps;
    if (scene::traits(isolation.method).steps == scene::Steps::cubics)
        block.thresholds = glm::dvec4(steps.first * eighth, 0, 0, 0);
    const double footprint = 2 * glm::length(rays.up) / height;
    const double spacing = 0x1p-21 * now.surface.bounds.radius; // some roundings of t
    // The finest step is where a root that F only touches is taken for one. An eighth of the radius
    // is the first piece of methods that bound F. Bounds shrink with the piece: those need finer
    // ones.
    const auto finest = [&](double part) { return std::max(part * footprint, spacing); };
    block.limits = glm::dvec4(isolation.bisections, isolation.limit, finest(0x1p-13), eighth);
    // No wave of F may hide within the longest step (formula/cubic_steps.h). In sums, steps of half
    // an element's radius lose some 10 pixels in a million of blobby75, those of a whole one a
    // thousand, and take as long.
    block.cubics =
        glm::dvec4(isolation.safety, std::min(steps.longest * eighth, 0.5 * element_radius),
                   spacing, finest(0x1p-10));
    return block;
}

glm::vec4 beam_range(const scene::OneSurfaceAt& now, int width, int height, const scene::Aim& aim,
                     int block) {
    // tau is the depth behind the plane of the anchors, which no aim turns or moves.
    const scene::Rays rays = scene::rays(now, width, height, aim);
    const glm::dvec3 forward = glm::normalize(glm::cross(rays.up, rays.right));
    const double depth = glm::dot(rays.axis, forward);
    const double middle = glm::dot(now.surface.bounds.centre - rays.origin, forward) / depth;
    const double half = 1.001 * now.surface.bounds.radius / depth;
    // Rays are in the bounds within `half` of the middle. Proofs of blocks begin at most as far
    // again before (shaders/proof/block_by_models.frag). Places of models that lean farther have
    // their own rounding (shaders/models/piece_of_block.glsl).
    const double reach = (std::abs(middle) + 2 * half) * depth;
    const double rounding =
        scene::ray_rounding(rays, now.surface.bounds, scene::Norm::length).at_depth(reach);
    const double pixel = 2 * glm::length(rays.up) / height;
    // Rays begin at the eye, at -1; a light's eye is outside of the bounds.
    return glm::dvec4(std::max(middle - half, -1.0), middle + half, 0.5 * block * pixel / depth,
                      beam_roundings * rounding);
}

std::vector<glm::vec4> shading_block(const scene::OneSurface& one, const scene::OneSurfaceAt& now,
                                     int width, int height) {
    const scene::PlacementAt& place = now.surface.placement;
    const auto& background = one.scene.output.background;
    std::vector<glm::vec4> block;
    block.push_back(wide(now.surface.color));
    block.emplace_back(background[0], background[1], background[2],
                       one.scene.output.transparent ? 0.0 : 1.0);
    const glm::dmat3 to_local = glm::transpose(place.rotate);
    for (const auto& light : now.scene.lights) {
        block.push_back(light.is_point ? wide(place.to_local(light.direction), 1)
                                       : wide(to_local * light.direction));
    }
    for (const auto& light : now.scene.lights) {
        block.push_back(wide(light.color, light.falloff / place.scale));
    }
    const glm::dmat3 axes = place.scale * place.rotate;
    for (int k = 0; k < 3; ++k) block.push_back(wide(axes[k]));
    block.push_back(wide(place.translate, 1));
    const scene::Rays rays = scene::rays(now, width, height);
    const double depth = glm::length(rays.axis);
    block.push_back(wide(place.scale / depth * rays.axis, place.scale * depth));
    return block;
}

std::vector<std::byte> parameter_block(const shader::Passes& passes, const scene::SurfaceAt& now,
                                       const elements::ElementGrid* grid) {
    const std::size_t vectors = std::size_t(passes.parameter_vectors);
    std::vector<std::byte> block(std::size_t(passes.vectors()) * 16);
    const auto values = std::as_bytes(std::span(now.bindings.parameters));
    std::copy(values.begin(), values.end(), block.begin());
    for (std::size_t a = 0; a < passes.arrays.size(); ++a) {
        const std::int32_t count = now.bindings.arrays[a].count;
        std::memcpy(block.data() + vectors * 16 + a * 4, &count, 4);
    }
    if (grid) {
        std::vector<glm::vec4> described{wide(grid->low, double(grid->least)),
                                         wide(grid->cell, grid->longest), wide(grid->across)};
        described.resize(std::size_t(shader::grid_vectors(passes)));
        for (std::size_t k = 0; k < grid->left_out.size(); ++k)
            described[shader::grid_vectors_of_place + k / 4][int(k % 4)] =
                not_below(grid->left_out[k]);
        const std::size_t begin = (vectors + std::size_t(passes.count_vectors)) * 16;
        std::memcpy(block.data() + begin, described.data(), described.size() * sizeof(glm::vec4));
    }
    return block;
}

std::vector<glm::vec4> array_texels(const formula::Field& field, const shader::Passes& passes,
                                    const scene::SurfaceAt& now, std::size_t index) {
    const auto& fields = field.packing[index];
    const auto& columns = now.bindings.arrays[index];
    const auto per_element = std::size_t(passes.arrays[index].texels);
    std::vector<glm::vec4> texels(std::size_t(columns.count) * per_element);
    for (std::size_t slot = 0; slot < fields.size(); ++slot) {
        const auto& column = columns.fields[std::size_t(fields[slot])];
        for (std::size_t i = 0; i < std::size_t(columns.count); ++i) {
            texels[i * per_element + slot / 4][int(slot % 4)] = column[i];
        }
    }
    return texels;
}

void describe_tapes(const shader::Passes& passes, const formula::TapeCells& tapes,
                    std::vector<std::byte>& block) {
    const std::vector<shader::FieldFunction>& functions = passes.tapes->functions();
    const auto vec = [](const std::array<double, 3>& v) { return glm::dvec3(v[0], v[1], v[2]); };
    std::array<glm::vec4, shader::tape_vectors> described{};
    described[0] = wide(vec(tapes.low), tapes.levels);
    described[1] = wide(vec(tapes.size));
    for (std::size_t k = 0; k < functions.size(); ++k) {
        const int place = int(functions[k]);
        described[std::size_t(shader::tape_vectors_of_place + place / 4)][place % 4] =
            float(int(k) * tapes.spans_of_a_function());
    }
    const std::size_t bytes = sizeof(described);
    std::memcpy(block.data() + (std::size_t(passes.vectors()) * 16 - bytes), described.data(),
                bytes);
}

} // namespace isomotion::render
