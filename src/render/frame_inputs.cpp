#include "render/frame_inputs.h"

#include <algorithm>
#include <limits>
#include <span>
#include <stdexcept>
#include <variant>

#include <fmt/format.h>

#include "render/light_beams.h"
#include "scene/near_elements.h"
#include "shader/effect.h"
#include "shader/tape_text.h"

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

void add(base::Fingerprint& print, const shader::Uniforms& uniforms) {
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
void add_places(base::Fingerprint& print, const scene::OneSurfaceAt& at) {
    const auto& [translate, rotate, scale] = at.surface.placement;
    const scene::CameraAt& camera = at.scene.camera;
    for (const glm::dvec3& v :
         {translate, rotate[0], rotate[1], rotate[2], camera.position, camera.target, camera.up}) {
        add_value(print, v);
    }
    for (const double number : {scale, camera.fov, camera.height, camera.zoom}) {
        add_value(print, number);
    }
    if (!at.scene.sections.empty())
        print.add_values(std::span<const glm::vec4>(scene::packed(at.scene.sections)));
}

void add(base::Fingerprint& print, const SurfaceInputs& inputs) {
    // A member more does not compile here until it is part of the fingerprint.
    const auto& [of_eye, of_field, of_shading, of_effects, of_lights, of_proofs, of_motion] =
        inputs;
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
        const auto& [frame_before, frame_after, before, after] = *of_motion;
        add_value(print, frame_before);
        add_value(print, frame_after);
        add(print, before);
        add(print, after);
    }
}

elements::ElementGrid grid_of(const elements::GridMaker& maker, const scene::SurfaceAt& at,
                              const InputLayout& layout) {
    elements::ElementGrid grid =
        maker.make(at.bindings, scene::region_of_elements(at.bounds), layout.grid_limits);
    if (grid.longest > layout.most_elements_at_a_place) {
        throw std::length_error(fmt::format(
            "{} elements of an array matter at one place; a shader can sum {}: smaller kernels, "
            "or fewer elements in one place",
            grid.longest, layout.most_elements_at_a_place));
    }
    return grid;
}

formula::TapeCells tapes_of(const scene::SurfaceAt& at, const InputLayout& layout) {
    std::array<formula::Interval, 3> box;
    for (int k = 0; k < 3; ++k) box[std::size_t(k)] = {at.bounds.min[k], at.bounds.max[k]};
    return formula::tape_cells(layout.passes.tapes->groups(),
                               layout.passes.tapes->parameters(at.bindings), box,
                               layout.tape_limits);
}

FieldInputs field_inputs(const formula::Field& field, const scene::SurfaceAt& at,
                         const InputLayout& layout) {
    const shader::Passes& passes = layout.passes;
    FieldInputs made;
    if (layout.grid) made.grid = grid_of(*layout.grid, at, layout);
    if (passes.tapes) made.tapes = tapes_of(at, layout);
    made.parameters = parameter_block(passes, at, made.grid ? &*made.grid : nullptr);
    if (made.tapes) describe_tapes(passes, *made.tapes, made.parameters);
    for (std::size_t a = 0; a < passes.arrays.size(); ++a) {
        made.arrays.push_back(array_texels(field, passes, at, a));
    }
    return made;
}

} // namespace

std::shared_ptr<const elements::ElementGrid> grid(const SurfaceInputs& inputs) {
    const auto& grid = inputs.field->grid;
    if (!grid) return nullptr;
    return {inputs.field, &*grid};
}

ViewInputs view_inputs(const scene::OneSurface& one, const scene::OneSurfaceAt& now, int width,
                       int height, const scene::Aim& aim, const shader::Passes& passes,
                       ElementRadius* element_radius) {
    const bool by_cubics =
        scene::traits(one.surface.isolation.method).steps == scene::Steps::cubics;
    double radius = by_cubics && element_radius
                        ? element_radius->least(*one.surface.field, now.surface)
                        : std::numeric_limits<double>::infinity();
    if (passes.tapes && passes.tapes->chooses())
        radius = std::min(radius, 2 * longest_piece_of_tapes(now.surface.bounds));
    ViewInputs view{frame_block(one, now, width, height, aim, radius), {}};
    for (const shader::BeamLevel& level : passes.beams) {
        view.beams.push_back(beam_range(now, width, height, aim, level.block));
    }
    return view;
}

void PictureInputs::add_to(base::Fingerprint& print) const {
    // As above: all members but the last three decide pixels.
    const auto& [across, up, all, times, told_by_eye, asked, no_pixel] = *this;
    (void)told_by_eye;
    (void)asked;
    (void)no_pixel;
    add_value(print, across);
    add_value(print, up);
    for (const SurfaceInputs& surface : all) add(print, surface);
    if (!times) return;
    for (std::size_t k = 0; k < all.size(); ++k) {
        for (const scene::SceneAt* at : {&times->now, &times->about.before, &times->about.after})
            add_places(print, {*at, k});
    }
    add_value(print, times->about.seconds);
}

std::shared_ptr<const FieldInputs> SharedField::at(const formula::Field& field,
                                                   const scene::SurfaceAt& now,
                                                   const InputLayout& layout) {
    if (!of_ || *of_ != now.bindings || bounds_ != now.bounds) {
        of_ = now.bindings;
        bounds_ = now.bounds;
        made_ = std::make_shared<const FieldInputs>(field_inputs(field, now, layout));
    }
    return made_;
}

SurfaceInputs surface_inputs(const scene::OneSurface& one, const scene::OneSurfaceAt& now,
                             const scene::Aim& aim, const Motion* motion, const InputLayout& layout,
                             ElementRadius& element_radius, SharedField& field) {
    const shader::Passes& passes = layout.passes;
    const formula::Field& formula = *one.surface.field;
    const int width = layout.width, height = layout.height;
    SurfaceInputs inputs;
    inputs.eye = view_inputs(one, now, width, height, aim, passes, &element_radius);
    inputs.field = field.at(formula, now.surface, layout);
    inputs.shading = shading_block(one, now, width, height);
    inputs.effects = shader::effect_uniforms(one, now);
    if (passes.light_beams != 0) {
        inputs.lights = light_inputs(one, now, passes, layout.light_pixels);
    }
    if (passes.has(shader::Role::proof)) {
        inputs.proofs = proof_rays(one, now, width, height, aim);
    }
    if (motion) {
        const scene::OneSurfaceAt before(motion->before, one.index);
        const scene::OneSurfaceAt after(motion->after, one.index);
        inputs.motion = MotionInputs{frame_block(one, before, width, height, aim),
                                     frame_block(one, after, width, height, aim),
                                     field_inputs(formula, before.surface, layout),
                                     field_inputs(formula, after.surface, layout)};
    }
    return inputs;
}

} // namespace isomotion::render
