#include "render/frame_inputs.h"

#include <algorithm>
#include <limits>
#include <span>
#include <stdexcept>
#include <variant>

#include <fmt/format.h>

#include "render/light_beams.h"
#include "scene/near_elements.h"
#include "synthesis/effect.h"
#include "synthesis/tape_text.h"

namespace isomotion::render {
namespace {

template<class T> void add_value(base::Fingerprint& print, const T& value) {
    print.add_values(std::span<const T>(&value, 1));
}

// Tapes of smaller boxes are shorter by more than there are more of these: on a Menger sponge, from
// 1000 instructions for an eighth of the bounds to 90 for a thirty-second.
double longest_piece_of_tapes(const scene::BoundsAt& bounds) {
    const glm::dvec3 size = bounds.max - bounds.min;
    return std::max({size.x, size.y, size.z}) / 40;
}

void add(base::Fingerprint& print, const FieldInputs& field) {
    // The parameters describe the rest.
    const auto& [parameters, arrays, grid, tapes] = field;
    print.add(parameters);
    for (const auto& texels : arrays) print.add_values(std::span<const glm::vec4>(texels));
    if (grid) {
        print.add_words(std::as_bytes(std::span(grid->cells)));
        print.add_words(std::as_bytes(std::span(grid->listed)));
    }
    if (tapes) {
        print.add_words(std::as_bytes(std::span(tapes->spans)));
        print.add_words(std::as_bytes(std::span(tapes->words)));
    }
}

void add(base::Fingerprint& print, const ViewInputs& view) {
    const auto& [frame, beams] = view;
    add_value(print, frame);
    print.add_values(std::span<const glm::vec4>(beams));
}

void add(base::Fingerprint& print, const synthesis::Uniforms& uniforms) {
    for (const auto& [name, value] : uniforms) {
        print.add(name);
        std::visit(
            [&](const auto& v) {
                using Value = std::decay_t<decltype(v)>;
                if constexpr (std::is_same_v<Value, std::vector<glm::vec4>>) {
                    print.add_values(std::span<const glm::vec4>(v));
                } else {
                    add_value(print, v);
                }
            },
            value);
    }
}

// Where a surface and a camera are: what velocities are differences of.
void add_places(base::Fingerprint& print, const scene::SceneAt& at) {
    const auto& [translate, rotate, scale] = at.surface.placement;
    const scene::CameraAt& camera = at.camera;
    for (const glm::dvec3& v :
         {translate, rotate[0], rotate[1], rotate[2], camera.position, camera.target, camera.up}) {
        add_value(print, v);
    }
    for (const double number : {scale, camera.fov, camera.height, camera.zoom}) {
        add_value(print, number);
    }
}

elements::ElementGrid grid_of(const elements::GridMaker& maker, const scene::SceneAt& at,
                              const InputLayout& layout) {
    elements::ElementGrid grid = maker.make(
        at.surface.bindings, scene::region_of_elements(at.surface.bounds), layout.grid_limits);
    if (grid.longest > layout.most_elements_at_a_place) {
        throw std::length_error(fmt::format(
            "{} elements of an array matter at one place; a shader can sum {}: smaller kernels, "
            "or fewer elements in one place",
            grid.longest, layout.most_elements_at_a_place));
    }
    return grid;
}

formula::TapeCells tapes_of(const scene::SceneAt& at, const InputLayout& layout) {
    std::array<formula::Interval, 3> box;
    for (int k = 0; k < 3; ++k)
        box[std::size_t(k)] = {at.surface.bounds.min[k], at.surface.bounds.max[k]};
    return formula::tape_cells(layout.passes.tapes->groups(), at.surface.bindings.parameters, box,
                               layout.tape_limits);
}

FieldInputs field_inputs(const scene::Scene& scene, const scene::SceneAt& at,
                         const InputLayout& layout) {
    const synthesis::Passes& passes = layout.passes;
    FieldInputs field;
    if (layout.grid) field.grid = grid_of(*layout.grid, at, layout);
    if (passes.tapes) field.tapes = tapes_of(at, layout);
    field.parameters = parameter_block(passes, at, field.grid ? &*field.grid : nullptr);
    if (field.tapes) describe_tapes(passes, *field.tapes, field.parameters);
    for (std::size_t a = 0; a < passes.arrays.size(); ++a) {
        field.arrays.push_back(array_texels(scene, passes, at, a));
    }
    return field;
}

} // namespace

std::shared_ptr<const elements::ElementGrid> grid(const PictureInputs& inputs) {
    if (!inputs.field->grid) return nullptr;
    return {inputs.field, &*inputs.field->grid};
}

ViewInputs view_inputs(const scene::Scene& scene, const scene::SceneAt& now, int width, int height,
                       const scene::Aim& aim, const synthesis::Passes& passes,
                       ElementRadius* element_radius) {
    const bool by_cubics =
        scene::traits(scene.surface.isolation.method).steps == scene::Steps::cubics;
    double radius = by_cubics && element_radius ? element_radius->least(scene, now)
                                                : std::numeric_limits<double>::infinity();
    if (passes.tapes && passes.tapes->chooses())
        radius = std::min(radius, 2 * longest_piece_of_tapes(now.surface.bounds));
    ViewInputs view{frame_block(scene, now, width, height, aim, radius), {}};
    for (const synthesis::BeamLevel& level : passes.beams) {
        view.beams.push_back(beam_range(now, width, height, aim, level.block));
    }
    return view;
}

void PictureInputs::add_to(base::Fingerprint& print) const {
    // A member more does not compile here until it is part of the fingerprint.
    const auto& [across, up, of_eye, of_field, of_shading, of_effects, of_lights, of_proofs,
                 of_motion, told_by_eye, asked, no_pixel, of_others] = *this;
    (void)told_by_eye;
    (void)asked; // decides no pixel either
    (void)no_pixel;
    for (const PictureInputs& other : of_others) other.add_to(print);
    add_value(print, across);
    add_value(print, up);
    add(print, of_eye);
    add(print, *of_field);
    print.add_values(std::span<const glm::vec4>(of_shading));
    add(print, of_effects);
    for (const auto& [light, view, to_light] : of_lights) {
        add_value(print, light);
        add(print, view);
        add_value(print, to_light);
    }
    if (of_proofs) {
        const auto& [frame, beam, coarse_beam, floats, doubles, in_range, beyond] = *of_proofs;
        add_value(print, in_range);
        add_value(print, frame);
        add_value(print, beam);
        add_value(print, coarse_beam);
        if (beyond != 0) add_value(print, beyond); // among several surfaces
        for (const auto& [tube, shortest_piece] : {floats, doubles}) {
            add_value(print, tube);
            add_value(print, shortest_piece);
        }
    }
    if (of_motion) {
        const auto& [now, motion_about, frame_before, frame_after, before, after] = *of_motion;
        for (const scene::SceneAt* at : {&now, &motion_about.before, &motion_about.after}) {
            add_places(print, *at);
            if (!at->sections.empty())
                print.add_values(std::span<const glm::vec4>(scene::packed(at->sections)));
        }
        add_value(print, motion_about.seconds);
        add_value(print, frame_before);
        add_value(print, frame_after);
        add(print, before);
        add(print, after);
    }
}

std::shared_ptr<const FieldInputs>
SharedField::at(const scene::Scene& scene, const scene::SceneAt& now, const InputLayout& layout) {
    if (!of_ || *of_ != now.surface.bindings || bounds_ != now.surface.bounds) {
        of_ = now.surface.bindings;
        bounds_ = now.surface.bounds;
        made_ = std::make_shared<const FieldInputs>(field_inputs(scene, now, layout));
    }
    return made_;
}

PictureInputs picture_inputs(const scene::Scene& scene, const scene::SceneAt& now,
                             const scene::Aim& aim, const Motion* motion, const InputLayout& layout,
                             ElementRadius& element_radius, SharedField& field) {
    const synthesis::Passes& passes = layout.passes;
    const int width = layout.width, height = layout.height;
    PictureInputs inputs;
    inputs.width = width;
    inputs.height = height;
    inputs.aim = aim;
    inputs.eye = view_inputs(scene, now, width, height, aim, passes, &element_radius);
    inputs.field = field.at(scene, now, layout);
    inputs.shading = shading_block(scene, now, width, height);
    inputs.effects = synthesis::effect_uniforms(scene, now);
    if (passes.light_beams != 0) {
        inputs.lights = light_inputs(scene, now, passes, layout.light_pixels);
    }
    if (passes.has(synthesis::Role::proof)) {
        inputs.proofs = proof_rays(scene, now, width, height, aim);
    }
    if (motion) {
        inputs.motion = MotionInputs{now,
                                     *motion,
                                     frame_block(scene, motion->before, width, height, aim),
                                     frame_block(scene, motion->after, width, height, aim),
                                     field_inputs(scene, motion->before, layout),
                                     field_inputs(scene, motion->after, layout)};
    }
    return inputs;
}

} // namespace isomotion::render
