// Rays that start where the eye's rays ended: shadow rays and mirrored ones.
#pragma once

#include <functional>
#include <optional>

#include "gpu/draw.h"
#include "gpu/program.h"
#include "gpu/target.h"
#include "render/effect_uniforms.h"
#include "synthesis/assemble.h"

namespace isomotion::render {

// Two targets that hold the states of a tile's rays, before and after a pass.
struct RayTargets {
    RayTargets(int width, int height, int textures)
        : even(width, height, textures)
        , odd(width, height, textures) {}
    gpu::Target even, odd;
};

// Marches rays to their ends, by passes of a program; returns the target that holds them.
using MarchRays = std::function<const gpu::Target&(const gpu::Program&, const RayTargets&)>;

// Of scenes that keep where rays ended (Shaders::surface is not empty).
class SecondaryRays {
public:
    static constexpr int units = 7;
    // So many texture units from `first_unit` on are its own.
    SecondaryRays(const synthesis::Shaders& shaders, int width, int height, int first_unit);

    // Each program that samples the field, for its uniforms and blocks.
    void for_each_program(const std::function<void(const gpu::Program&)>& visit) const;
    // Marches the shadow rays, of scenes that have some.
    const gpu::Program& shadows() const { return shadow_->march; }
    // Names its textures to a program that reads them: its own, and the shade pass.
    void connect(const gpu::Program& program) const;

    // Traces what starts on the ends of a tile's rays, whose states are bound, and binds what the
    // shade pass reads.
    void trace(const gpu::Rectangle& tile, const gpu::Target& eye_rays, const MarchRays& march);

private:
    struct Mirror {
        gpu::Program march, surface;
        RayTargets rays;
        gpu::Target ends;
    };
    struct Shadow {
        gpu::Program march;
        RayTargets rays;
    };

    void keep_ends(const gpu::Program& program, const gpu::Rectangle& tile, const gpu::Target& rays,
                   const gpu::Target& into) const;

    int first_unit_;
    gpu::Program surface_;
    gpu::Target ends_;
    std::optional<Mirror> mirror_;
    std::optional<Shadow> shadow_;
    gpu::Fullscreen triangle_;
};

} // namespace isomotion::render
