#include "render/whole_draw.h"

#include <limits>

namespace isomotion::render {

WholeDraw::WholeDraw(const synthesis::Shaders& shaders, const gpu::Target& result)
    : result_(result)
    , channels_(shaders.attachments)
    , program_(shaders.shade_vertex, shaders.whole, "whole")
    , open_(shaders.vertex, shaders.open, "open")
    , gate_(result) {}

void WholeDraw::for_each_program(const std::function<void(const gpu::Program&)>& visit) const {
    visit(program_);
    visit(open_);
}

void WholeDraw::draw(const gpu::Rectangle& tile, int evaluations, float element_budget,
                     glm::vec4 background) const {
    const auto fill = [&](const gpu::Program& program) {
        gpu::set_viewport({0, 0, tile.width, tile.height});
        program.set("tile_origin", glm::ivec2(tile.x, tile.y));
        program.use();
        triangle_.draw();
    };
    program_.set("evaluations_per_pass", evaluations);
    program_.set("element_budget", element_budget);
    gate_.set([&] { fill(open_); });
    clear_to_misses(background);
    gate_.through([&] { fill(program_); });
}

// What the shader writes of rays that end on nothing before they are marched.
void WholeDraw::clear_to_misses(glm::vec4 background) const {
    result_.clear(0, background);
    result_.clear(1, 0u);
    for (std::size_t k = 0; k < channels_.size(); ++k) {
        float nowhere = 0;
        if (channels_[k] == synthesis::Channel::depth) {
            nowhere = std::numeric_limits<float>::infinity();
        } else if (channels_[k] == synthesis::Channel::ending) {
            nowhere = 1e30f; // march/verdict.glsl
        }
        result_.clear(2 + int(k), glm::vec4(nowhere, 0, 0, 0));
    }
}

} // namespace isomotion::render
