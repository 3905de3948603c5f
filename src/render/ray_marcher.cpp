#include "render/ray_marcher.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "synthesis/effect_text.h"

namespace isomotion::render {

using synthesis::Role;

RayMarcher::RayMarcher(const synthesis::Passes& passes, const scene::Scene& scene,
                       const ScenePlan& plan, std::function<void()> stop_if_asked)
    : passes_(passes)
    , plan_(plan)
    , shadow_lights_(std::popcount(unsigned(synthesis::shadow_mask(scene))))
    , stop_if_asked_(std::move(stop_if_asked)) {}

int RayMarcher::evaluations_of(Role role) const {
    // Mirrored rays go by no lists.
    const bool by_lists = role == Role::march || (role == Role::shadow && passes_.light_beams != 0);
    const bool is_planned = !synthesis::has_lists(passes_) || by_lists;
    const int all = is_planned ? plan_.march.evaluations_per_pass : plan_.evaluations_without_lists;
    if (role != Role::shadow) return all;
    // One light after the other, neighbours wait for the longest ray of each.
    return std::max(all / shadow_lights_, 1);
}

const gpu::Target& RayMarcher::march(PassTable& table, Role role, const gpu::Rectangle& tile,
                                     const RayTargets& targets, const gpu::Target& counted_into,
                                     int& draws, const gpu::Rectangles* parts) const {
    const gpu::Program& program = table.program(role);
    const gpu::Program& active = table.program(Role::active);
    program.set("evaluations_per_pass", evaluations_of(role));
    program.set("element_budget", plan_.element_budget);
    const gpu::Target *from = &targets.odd, *to = &targets.even;
    for (bool first = true;; first = false) {
        table.bind_numbered("state_texture", *from);
        program.set("first_pass", first ? 1 : 0);
        table.march(program, tile, *to, parts);
        ++draws;

        table.bind_numbered("state_texture", *to);
        counted_into.bind();
        still_active_.begin();
        table.draw(active, tile);
        still_active_.end();
        if (still_active_.passed() == 0) return *to;
        stop_if_asked_();
        std::swap(from, to);
    }
}

} // namespace isomotion::render
