#include "render/fused_surfaces.h"

#include <utility>

#include "render/fused_pass.h"

namespace isomotion::render {

using shader::Role;

FusedSurfaces::FusedSurfaces(std::vector<SurfacePasses*> all, const gpu::Target& result,
                             std::vector<gpu::Format> formats)
    : all_(std::move(all))
    , result_(result)
    , before_(result.width(), result.height(), formats)
    , mask_(result) {}

void FusedSurfaces::draw(const PictureInputs& inputs, const gpu::Rectangle& tile, int& draws) {
    const int way = result_.attachments() - 1;
    clear_to_misses(result_, all_.front()->passes.attachments, inputs.background());
    result_.clear(way, glm::vec4(Ending::nowhere));
    for (std::size_t k = 0; k < all_.size(); ++k) {
        SurfacePasses& one = *all_[k];
        one.bind();
        one.draw_beams(inputs.surfaces[k], tile);
        if (k > 0) {
            before_.copy_from(result_, one.table.in_targets(tile));
            one.table.bind_numbered("before_texture", before_);
            one.table.bind("way_texture", before_.texture(way));
        }
        const gpu::Program& program = one.table.program(Role::fused);
        program.set("evaluations_per_pass", one.plan.march.evaluations_per_pass);
        program.set("element_budget", one.plan.element_budget);
        one.table.timed([&] {
            mask_.set([&] { one.table.draw(one.table.program(Role::mask), tile); });
            mask_.apply([&] { one.table.draw(program, tile); });
        });
        ++draws;
    }
}

} // namespace isomotion::render
