// Draws scenes with several surfaces. Each surface is marched by its own passes, the nearest hit
// counts, and rays that begin on one surface see all. Passes share data in textures:
// shaders/surfaces/.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "gpu/target.h"
#include "render/ray_marcher.h"
#include "render/surface_passes.h"

namespace isomotion::render {

// Uniforms of one surface among several, which relate its rays and places to those of the others.
// `now` is the first surface's.
synthesis::Uniforms uniforms_among(const scene::SceneAt& now, int index, int width, int height,
                                   const scene::Aim& aim);

class SeveralSurfaces {
public:
    // `all` must outlive this object; the first surface comes first.
    explicit SeveralSurfaces(std::vector<SurfacePasses*> all);

    // Draws a tile, whose inputs are uploaded, into `result`. Adds its march draws to `draws`.
    void draw(const PictureInputs& inputs, const gpu::Rectangle& tile, const gpu::Target& result,
              const gpu::Texture* environment, int& draws);

private:
    // Two alternating targets: the pass of each surface reads what the passes before it drew.
    struct Relay {
        explicit Relay(const MarchPlan& tile, int attachments);
        const gpu::Target& last() const { return targets[std::size_t(at)]; }
        const gpu::Target& next() { return targets[std::size_t(at = 1 - at)]; }

        std::array<gpu::Target, 2> targets;
        int at = 1;
    };

    void find_ends(const PictureInputs& inputs, const gpu::Rectangle& tile,
                   const gpu::Target& result, int& draws);
    void see_in_mirrors(const gpu::Rectangle& tile, const gpu::Target& result,
                        const gpu::Texture* environment, int& draws);
    const gpu::Target* cast_shadows(const gpu::Rectangle& tile, const gpu::Target& result,
                                    int& draws);
    void look_around(const gpu::Rectangle& tile);

    std::vector<SurfacePasses*> all_;
    std::vector<RayTargets> eye_, shadow_, mirror_;
    std::vector<const gpu::Target*> rays_; // where the eye's rays ended
    Relay ends_;
    std::optional<Relay> mirrored_, open_;
    std::optional<gpu::Target> seen_;
};

} // namespace isomotion::render
