// Beams: blocks of rays for which intervals prove, before they march, what they need not.
//
// Each level of beams is drawn with one pixel a block; its beams lie in those of the level before,
// and so do their lists of the array's elements that matter there.
#pragma once

#include <functional>
#include <vector>

#include "gpu/draw.h"
#include "gpu/program.h"
#include "gpu/target.h"
#include "render/array_buffer.h"
#include "render/march_plan.h"
#include "scene/rays.h"
#include "scene/scene_at.h"
#include "synthesis/assemble.h"

namespace isomotion::render {

class BeamPass {
public:
    // Of shaders that have beams, for tiles as planned. `texels`: the most a texture buffer may
    // have. The parts of the rays that are left go to texture `unit`, their lists to the next.
    BeamPass(const synthesis::Shaders& shaders, const scene::Scene& scene, const MarchPlan& plan,
             int texels, int unit);

    // How many elements its lists hold, all together; they follow the array's own.
    int listed() const { return listed_; }
    void for_each_program(const std::function<void(const gpu::Program&)>& visit) const;
    void upload(const scene::SceneAt& now, int width, int height, const scene::Aim& aim) const;
    // Draws the beams of a tile and binds the last level's; `array` is null without lists.
    void draw(const gpu::Rectangle& tile, const ArrayBuffer* array) const;

private:
    struct Level {
        gpu::Program program;
        gpu::Target results; // parts and lists
        int block, square_bits;
        int evaluations; // of one beam
        // Of its lists: the first element in the array's buffer, the most of one block, which else
        // takes the list that it comes from; blocks across.
        glm::ivec3 list;

        void bind_results(int unit) const;
    };

    std::vector<Level> levels_;
    int listed_ = 0;
    int unit_;
    gpu::Fullscreen triangle_;
};

} // namespace isomotion::render
