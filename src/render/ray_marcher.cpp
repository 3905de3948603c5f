#include "render/ray_marcher.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "shader/effect_text.h"

namespace isomotion::render {

using shader::Role;

RayMarcher::RayMarcher(const shader::Passes& passes, const scene::Scene& scene,
                       const ScenePlan& plan, std::function<void()> stop_if_asked)
    : passes_(passes)
    , plan_(plan)
    , shadow_lights_(std::popcount(unsigned(shader::shadow_mask(scene))))
    , stop_if_asked_(std::move(stop_if_asked)) {}

RayMarcher::Evaluations RayMarcher::evaluations_of(Role role) const {
    // Mirrored rays go by no lists.
    const bool by_lists = role == Role::march || (role == Role::shadow && passes_.light_beams != 0);
    const bool is_planned = !shader::has_lists(passes_) || by_lists;
    const Evaluations all =
        is_planned
            ? Evaluations{plan_.march.evaluations_per_pass, plan_.march.most_evaluations_per_pass}
            : Evaluations{plan_.evaluations_without_lists, plan_.most_evaluations_without_lists};
    // One light after the other, neighbours wait for the longest ray of each.
    const int lights = role == Role::shadow ? shadow_lights_ : 1;
    return {std::max(all.usual / lights, 1), std::max({all.most, all.usual, lights}) / lights};
}

const gpu::Target& RayMarcher::march(PassTable& table, Role role, const gpu::Rectangle& tile,
                                     const RayTargets& targets, const gpu::Target& counted_into,
                                     int& draws, const gpu::Rectangles* parts) const {
    const gpu::Program& program = table.program(role);
    const gpu::Program& active = table.program(Role::active);
    // A draw of few rays may take each of them further: groups of so many run together.
    constexpr double rays_together = 32;
    const Evaluations evaluations = evaluations_of(role);
    program.set("evaluations_per_pass", evaluations.usual);
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
        const std::uint32_t open = still_active_.passed();
        if (open == 0) return *to;
        const double growth = double(tile.width) * tile.height / (rays_together * open);
        program.set("evaluations_per_pass",
                    int(std::clamp(evaluations.usual * growth, double(evaluations.usual),
                                   double(std::max(evaluations.usual, evaluations.most)))));
        stop_if_asked_();
        std::swap(from, to);
    }
}

} // namespace isomotion::render
