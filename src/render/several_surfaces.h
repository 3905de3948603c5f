// Draws scenes with several surfaces. Each surface is marched by its own passes, the nearest hit
// counts, and rays that begin on one surface see all. Passes share data in textures:
// shaders/surfaces/.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "gpu/target.h"
#include "render/drawing_route.h"
#include "render/light_paths.h"
#include "render/ray_marcher.h"
#include "render/surface_passes.h"

namespace isomotion::render {

// Uniforms of one surface among several, which relate its rays and places to those of the others.
shader::Uniforms uniforms_among(const scene::OneSurface& one, const scene::SceneAt& now, int width,
                                int height, const scene::Aim& aim);

class SeveralSurfaces : public InPasses {
public:
    // `all` must outlive this object; the first surface comes first.
    explicit SeveralSurfaces(std::vector<SurfacePasses*> all);

    void draw(const PictureInputs& inputs, const gpu::Rectangle& tile, const gpu::Target& result,
              const gpu::Texture* environment, int& draws) override;
    const gpu::Target& rays(std::size_t surface) const override { return *rays_[surface]; }
    std::vector<int> seen(const gpu::Rectangle& tile) const override;

private:
    void begin_mirrors(const MarchPlan& tile);
    void begin_paths(const MarchPlan& tile);
    void find_ends(const PictureInputs& inputs, const gpu::Rectangle& tile,
                   const gpu::Target& result, int& draws);
    void see_in_mirrors(const gpu::Rectangle& tile, const gpu::Texture* environment, int& draws);
    const gpu::Target* cast_shadows(const gpu::Target& ends, const gpu::Rectangle& tile,
                                    const gpu::Target& counted_into, int& draws);
    void look_around(const gpu::Rectangle& tile);
    void follow_paths(const gpu::Rectangle& tile, const gpu::Texture* environment, int& draws);

    std::vector<SurfacePasses*> all_;
    std::vector<RayTargets> eye_, shadow_, mirror_;
    std::vector<const gpu::Target*> rays_; // where the eye's rays ended
    Relay ends_;
    std::optional<Relay> mirrored_, open_;
    std::optional<gpu::Target> seen_;
    std::optional<gpu::DepthMask> mirrors_; // where mirrored rays begin
    std::optional<LightPaths> paths_;
};

} // namespace isomotion::render
