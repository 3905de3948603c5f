// March and picture of a tile in one draw for each surface, of scenes with several plain ones: each
// draws over those before it where it is nearer. See shaders/shade/shade.frag.
#pragma once

#include <vector>

#include "gpu/depth_mask.h"
#include "gpu/target.h"
#include "render/drawing_route.h"
#include "render/surface_passes.h"

namespace isomotion::render {

// The format of the last attachment of pictures drawn so, behind colour, record and channels.
inline constexpr gpu::Format way_format = gpu::Format::r32f;

class FusedSurfaces : public OneDraw {
public:
    // `all`, which have fused passes, and `result` outlive this.
    FusedSurfaces(std::vector<SurfacePasses*> all, const gpu::Target& result,
                  std::vector<gpu::Format> formats);

    void draw(const PictureInputs& inputs, const gpu::Rectangle& tile, int& draws) override;

private:
    std::vector<SurfacePasses*> all_;
    const gpu::Target& result_;
    gpu::Target before_; // a copy, which a surface reads while it draws into `result`
    gpu::DepthMask mask_;
};

} // namespace isomotion::render
