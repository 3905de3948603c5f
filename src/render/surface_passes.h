// Draws one surface: its passes, compiled once, and their inputs.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "gpu/context.h"
#include "render/beam_pass.h"
#include "render/field_buffers.h"
#include "render/frame_inputs.h"
#include "render/light_beams.h"
#include "render/pass_table.h"
#include "render/ray_marcher.h"
#include "render/renderer.h"
#include "render/scene_plan.h"

namespace isomotion::render {

// A surface's passes with the plan that divides pictures into draws.
struct PlannedSurface {
    PlannedSurface(const scene::OneSurface& one, const RenderOptions& options,
                   const gpu::ContextInfo& info);

    scene::OneSurface drawn;
    shader::Passes passes;
    ScenePlan plan;
};

// Plans all surfaces of a scene, which must outlive the plans, with tiles of one size.
std::vector<PlannedSurface> plan_surfaces(const scene::Scene& scene, const RenderOptions& options,
                                          const gpu::ContextInfo& info);

class SurfacePasses {
public:
    SurfacePasses(PlannedSurface planned, const RenderOptions& options,
                  const gpu::ContextInfo& info, std::function<void()> stop_if_asked);

    InputLayout layout(int width, int height) const;
    SurfaceInputs prepare(const scene::SceneAt& now, const scene::Aim& aim, const Motion* motion,
                          int width, int height, SharedField& field_of_frame);

    // Uploads and binds a picture's inputs.
    void upload(const SurfaceInputs& inputs, int width, int height);
    // Binds them again, since passes of another surface bind their own to the same places.
    void bind();
    void draw_beams(const SurfaceInputs& inputs, const gpu::Rectangle& tile);

private:
    PlannedSurface planned_;

public:
    const scene::OneSurface& drawn;
    const shader::Passes& passes;
    const ScenePlan& plan;
    PassTable table;
    RayMarcher marcher;
    std::optional<BeamPass> beams;
    bool keeps_beams = false;
    std::optional<LightBeams> light_beams;
    FieldBuffers field;

private:
    gpu::UniformBuffer frame_, shading_;
    ElementRadius element_radius_;
    std::optional<elements::GridMaker> grid_maker_;
    int threads_;
    std::vector<bool> tapes_are_run_;
    std::size_t most_listed_;
};

} // namespace isomotion::render
