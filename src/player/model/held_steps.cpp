#include "player/model/held_steps.h"

#include <algorithm>

#include "player/model/controls.h"
#include "probe/cubic_steps.h"
#include "scene/error.h"
#include "scene/scene_at.h"
#include "scene/surfaces.h"

namespace isomotion::player {
namespace {

// Those of the surface before where values leave their ranges, which is said where it is drawn.
formula::CubicSteps steps_of(const scene::OneSurface& one) {
    try {
        return probe::cubic_steps(one, one.surface.measured.smoothness,
                                  scene::surface_at(one, one.scene.timeline.time(1)));
    } catch (const scene::SceneError&) {
        return one.surface.measured.cubic_steps;
    }
}

} // namespace

scene::Scene with_own_steps(scene::Scene scene) {
    for (std::size_t k = 0; k < scene.surfaces.size(); ++k)
        scene.surfaces[k].measured.cubic_steps = steps_of({scene, k});
    return scene;
}

formula::CubicSteps steps_at_slider_ends(const scene::OneSurface& one) {
    formula::CubicSteps shortest = one.surface.measured.cubic_steps;
    const scene::Scene alone = scene::alone(one);
    for (const SliderRange& range : slider_ranges(alone)) {
        for (const double end : {range.least, range.most}) {
            const formula::CubicSteps steps =
                steps_of(apply(alone, {.values = {{range.name, end}}, .factors = {}}));
            shortest.longest = std::min(shortest.longest, steps.longest);
            shortest.first = std::min(shortest.first, steps.first);
        }
    }
    return shortest;
}

} // namespace isomotion::player
