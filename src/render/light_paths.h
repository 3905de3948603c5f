// Traces the light of a tile's pixels through glass and mirrors of several surfaces:
// shaders/paths/.
#pragma once

#include <memory>
#include <vector>

#include "gpu/depth_mask.h"
#include "gpu/rectangles.h"
#include "gpu/target.h"
#include "render/ray_marcher.h"
#include "render/relay.h"
#include "render/surface_passes.h"

namespace isomotion::render {

// Uniform `matters` of shaders/paths/matter.glsl for a surface whose formula's unit is `unit`.
std::vector<glm::vec4> matters_at(const scene::Scene& scene, const scene::SceneAt& now,
                                  double unit);

// For scenes whose surfaces have Role::glass.
class LightPaths {
public:
    // `all` must outlive it.
    explicit LightPaths(std::vector<SurfacePasses*> all);

    // Follows the paths that begin where the eye's rays ended. Adds its draws to `draws`.
    void trace(const gpu::Target& eye_ends, const gpu::Rectangle& tile,
               const gpu::Texture* environment, int& draws);
    // The light found, as glass textures.
    const gpu::Target& light() const { return kept_; }
    // Where paths ended on the ground and on surfaces that they don't go on from, as ends of rays.
    // Then the mask has these pixels, for targets that it serves.
    const gpu::Target& draw_ends(const gpu::Rectangle& tile);
    const gpu::DepthMask& mask() const { return mask_; }
    // A target that the mask serves, for pixels that nothing reads.
    const gpu::Target& spare() const { return gone_on_; }

private:
    void bind(SurfacePasses& one, const gpu::Target& ends, const gpu::Texture* environment) const;
    void begin(const gpu::Target& eye_ends, const gpu::Rectangle& tile,
               const gpu::Texture* environment);
    gpu::Rectangle around_in_targets() const;
    bool any_goes_on(const gpu::Rectangle& tile);
    void draw_open(SurfacePasses& one, shader::Role role, const gpu::Rectangle& tile);
    void find_ends(const gpu::Rectangle& tile, int& draws);
    void look_beyond(const gpu::Target& ends, const gpu::Rectangle& tile);
    void go_on(const gpu::Rectangle& tile, const gpu::Texture* environment);

    std::vector<SurfacePasses*> all_;
    std::vector<RayTargets> rays_;
    gpu::Target kept_, gone_on_; // all paths, and those that a ray continued
    Relay ends_;                 // of their rays
    gpu::Target beyond_, ended_;
    gpu::DepthMask mask_;      // where paths continue
    gpu::Rectangle around_;    // all of these in the tile,
    gpu::Rectangles open_;     // and squares of pixels with any
    std::vector<float> codes_; // of paths, as the shaders pack them
};

} // namespace isomotion::render
