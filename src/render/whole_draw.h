// March and picture of a tile in one draw, for plain pictures whose rays end within one pass.
#pragma once

#include <functional>
#include <vector>

#include <glm/glm.hpp>

#include "gpu/draw.h"
#include "gpu/gate.h"
#include "gpu/program.h"
#include "gpu/target.h"
#include "synthesis/assemble.h"

namespace isomotion::render {

class WholeDraw {
public:
    // Into `result`, which outlives it: colour, record and the channels of `shaders`, in this
    // order.
    WholeDraw(const synthesis::Shaders& shaders, const gpu::Target& result);

    void for_each_program(const std::function<void(const gpu::Program&)>& visit) const;
    // Of pixels whose beams or bounds leave no way to march the shader is not run: they are misses,
    // of which `background` is the colour.
    void draw(const gpu::Rectangle& tile, int evaluations, float element_budget,
              glm::vec4 background) const;
    // Open, after a draw, for the pixels whose rays had a way to march.
    const gpu::Gate& gate() const { return gate_; }

private:
    void clear_to_misses(glm::vec4 background) const;

    const gpu::Target& result_;
    std::vector<synthesis::Channel> channels_; // of the attachments from the third on
    gpu::Program program_, open_;
    gpu::Gate gate_;
    gpu::Fullscreen triangle_;
};

} // namespace isomotion::render
