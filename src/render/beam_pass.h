// Beams: blocks of rays for which intervals prove, before they march, what they need not.
//
// Each level of beams is drawn with one pixel a block; its beams lie in those of the level before,
// and so do their lists of the array's elements that matter there.
#pragma once

#include <functional>
#include <memory>
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
    // have. The parts of the rays that are left go to texture `unit`, their lists to the next two.
    BeamPass(const synthesis::Shaders& shaders, const scene::Scene& scene, const MarchPlan& plan,
             int texels, int unit);
    // With the programs of other beams, for pictures of another size; lists behind theirs.
    BeamPass(const BeamPass& others, const synthesis::Shaders& shaders, int width, int height,
             int texels);

    // How many elements its lists hold, all together; they follow the array's own.
    int listed() const { return listed_; }
    void for_each_program(const std::function<void(const gpu::Program&)>& visit) const;
    // For the draws to come. Rays are in their pixels' middles, or `around` them by so many pixels.
    void upload(const scene::SceneAt& now, int width, int height, const scene::Aim& aim,
                double around = 0) const;
    // Draws the beams of these pixels, which are whole squares from the corner on, and binds the
    // last level's. `origin` is what pixel (0, 0) is of the picture; `array` is null without lists.
    void draw(const gpu::Rectangle& pixels, glm::ivec2 origin, const ArrayBuffer* array) const;
    // Binds the last level's results elsewhere.
    void bind(int unit) const { levels_.back().bind_results(unit); }

    static constexpr int units = 3; // of textures
    // Pixels that the squares of every level are whole multiples of.
    static constexpr int square = 256;

private:
    struct Level {
        std::shared_ptr<const gpu::Program> program;
        gpu::Target results; // parts and lists
        int block, square_bits;
        int evaluations; // of one beam
        // Of its lists: the first element in the array's buffer, the most of one block, which else
        // takes the list that it comes from; blocks across.
        glm::ivec3 list;

        void bind_results(int unit) const;
    };

    void add_level(std::shared_ptr<const gpu::Program> program, const synthesis::Shaders& shaders,
                   const synthesis::BeamShader& level, const MarchPlan& plan, int evaluations,
                   double part);

    std::vector<Level> levels_;
    int first_ = 0; // of the lists' elements in the array's buffer
    int listed_ = 0;
    int unit_;
    gpu::Fullscreen triangle_;
};

} // namespace isomotion::render
