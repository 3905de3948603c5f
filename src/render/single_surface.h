// Draws scenes of a single surface in passes: the march of the eye's rays, the rays that begin
// where these end, and the shading.
#pragma once

#include <optional>

#include "render/drawing_route.h"
#include "render/ray_marcher.h"
#include "render/secondary_rays.h"
#include "render/surface_passes.h"

namespace isomotion::render {

class SingleSurface : public InPasses {
public:
    // `only` must outlive it.
    explicit SingleSurface(SurfacePasses& only);

    void draw(const PictureInputs& inputs, const gpu::Rectangle& tile, const gpu::Target& result,
              const gpu::Texture* environment, int& draws) override;
    const gpu::Target& rays(std::size_t surface) const override;
    std::vector<int> seen(const gpu::Rectangle& tile) const override;

private:
    SurfacePasses& only_;
    RayTargets eye_;
    std::optional<SecondaryRays> secondary_;
    const gpu::Target* rays_ = nullptr;
};

} // namespace isomotion::render
