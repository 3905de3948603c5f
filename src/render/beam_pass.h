// Beams: intervals prove for blocks of rays, before they march, which parts of them need no
// marching.
//
// Each level of beams is drawn with one pixel per block. Its beams lie in those of the level
// before, and so do its lists of the array's elements that matter there.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "gpu/draw.h"
#include "gpu/target.h"
#include "render/array_buffer.h"
#include "render/block_squares.h"
#include "render/march_plan.h"
#include "render/pass_table.h"
#include "scene/scene.h"
#include "shader/beam_text.h"

namespace isomotion::render {

// The number of pieces that one beam evaluates: as many as fit into the loops of its shader, fewer
// if it has long lists.
int evaluations_of_a_beam(const shader::Passes& passes, const formula::Field& field,
                          shader::BeamLists lists);

class BeamPass {
public:
    // For tiles as planned. Lists of elements start at element `first_list` of the array's buffer
    // and extend to its `texels`.
    BeamPass(const shader::Passes& passes, const scene::OneSurface& one, const MarchPlan& plan,
             int texels, int first_list);

    // The total number of elements in its lists.
    int listed() const { return listed_; }

    // Draws the beams of these pixels, from the corner of a block on, and binds the results of the
    // last level. `ranges`: ViewInputs::beams. `origin` is the place of pixel (0, 0) in the
    // picture; `array` is null without lists. Rays go through their pixels' centres, or up to
    // `around` pixels from them.
    void draw(PassTable& table, std::span<const glm::vec4> ranges, const gpu::Rectangle& pixels,
              glm::ivec2 origin, const ArrayBuffer* array, double around = 0) const;
    // Binds the results for passes that read them as `kind`_texture: "beam" or "light_beam".
    void bind(const PassTable& table, const std::string& kind = "beam") const;

    // What the last level found of these pixels' blocks, whole ones of 8 pixels from the lower left
    // corner on. Waits for the draws before: once for all, or for each square, of which a software
    // renderer reads less.
    Blocks blocks(const gpu::Rectangle& pixels, bool at_once);

    // The squares of every level divide this number of pixels.
    static constexpr int square = 256;

private:
    struct Level {
        gpu::Target results; // parts; and lists, or the pieces with first roots
        int block, square_bits;
        int evaluations; // of one beam
        // The first element of its lists in the array's buffer; the limit on the list of a block,
        // which otherwise uses the list of the level before; blocks across.
        glm::ivec3 list;
        bool by_models;
    };

    static void bind(const PassTable& table, const Level& level, const std::string& kind);

    bool computes_; // in compute shaders, otherwise in fragment shaders
    std::vector<Level> levels_;
    int listed_ = 0;
    std::vector<float> parts_; // of blocks read last
    gpu::Fullscreen triangle_;
};

} // namespace isomotion::render
