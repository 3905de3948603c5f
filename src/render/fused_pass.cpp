#include "render/fused_pass.h"

#include <limits>

namespace isomotion::render {

using synthesis::Role;

FusedPass::FusedPass(const synthesis::Passes& passes, const gpu::Target& result)
    : result_(result)
    , channels_(passes.attachments)
    , mask_(result) {}

void FusedPass::draw(PassTable& table, const gpu::Rectangle& tile, const ScenePlan& plan,
                     glm::vec4 background) const {
    const gpu::Program& program = table.program(Role::fused);
    program.set("evaluations_per_pass", plan.march.evaluations_per_pass);
    program.set("element_budget", plan.element_budget);
    mask_.set([&] { table.draw(table.program(Role::mask), tile); });
    clear_to_misses(background);
    mask_.apply([&] { table.draw(program, tile); });
}

// What the shader writes of rays that end on nothing before they are marched.
void FusedPass::clear_to_misses(glm::vec4 background) const {
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
