// Beams: blocks of rays for which intervals prove, before they march, what they need not.
//
// Each level of beams is drawn with one pixel a block; its beams lie in those of the level before,
// and so do their lists of the array's elements that matter there.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "gpu/draw.h"
#include "gpu/target.h"
#include "render/array_buffer.h"
#include "render/march_plan.h"
#include "render/pass_table.h"
#include "scene/scene.h"
#include "synthesis/beam_text.h"

namespace isomotion::render {

// Pieces of its way that one beam looks at: what fits into the loops of its shader; with lists it
// is less where these are long.
int evaluations_of_a_beam(const synthesis::Passes& passes, const formula::Field& field,
                          synthesis::BeamLists lists);

class BeamPass {
public:
    // For tiles as planned. Lists of elements follow the first `first_list` in the array's buffer,
    // as far as its `texels` go.
    BeamPass(const synthesis::Passes& passes, const scene::Scene& scene, const MarchPlan& plan,
             int texels, int first_list);

    // The elements that its lists hold, all together.
    int listed() const { return listed_; }

    // Draws the beams of these pixels, which are whole squares from the corner on, and binds what
    // the last level found. `ranges`: ViewInputs::beams. `origin` is what pixel (0, 0) is of the
    // picture; `array` is null without lists. Rays are in their pixels' middles, or `around` them
    // by so many pixels.
    void draw(PassTable& table, std::span<const glm::vec4> ranges, const gpu::Rectangle& pixels,
              glm::ivec2 origin, const ArrayBuffer* array, double around = 0) const;
    // Binds that for passes that read it as `kind`_texture: "beam" or "light_beam".
    void bind(const PassTable& table, const std::string& kind = "beam") const;

    // Pixels that the squares of every level are whole multiples of.
    static constexpr int square = 256;

private:
    struct Level {
        gpu::Target results; // parts and lists
        int block, square_bits;
        int evaluations; // of one beam
        // The first element of its lists in the array's buffer; the most in the list of a block,
        // which else takes the list that it comes from; blocks across.
        glm::ivec3 list;
    };

    static void bind(const PassTable& table, const gpu::Target& results, const std::string& kind);

    std::vector<Level> levels_;
    int listed_ = 0;
    gpu::Fullscreen triangle_;
};

} // namespace isomotion::render
