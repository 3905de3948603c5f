#include "player/model/held_steps.h"

#include <algorithm>
#include <vector>

#include "player/model/controls.h"
#include "scene/cubic_steps.h"
#include "scene/error.h"
#include "scene/nth_surface.h"
#include "scene/scene_at.h"
#include "scene/surfaces.h"

namespace isomotion::player {
namespace {

// Those of the surface before where values leave their ranges, which is said where it is drawn.
formula::CubicSteps steps_of(const scene::Scene& surface) {
    try {
        return scene::cubic_steps(surface, scene::at_frame(surface, 1));
    } catch (const scene::SceneError&) {
        return surface.surface.cubic_steps;
    }
}

} // namespace

scene::Scene with_own_steps(scene::Scene scene) {
    std::vector<formula::CubicSteps> steps;
    for (std::size_t k = 0; k < scene::surface_count(scene); ++k)
        steps.push_back(steps_of(scene::of_surface(scene, int(k))));
    for (std::size_t k = 0; k < steps.size(); ++k)
        scene::nth_surface(scene, k).surface.cubic_steps = steps[k];
    return scene;
}

formula::CubicSteps steps_at_slider_ends(const scene::Scene& surface) {
    formula::CubicSteps shortest = surface.surface.cubic_steps;
    for (const SliderRange& range : slider_ranges(surface)) {
        for (const double end : {range.least, range.most}) {
            const formula::CubicSteps steps =
                steps_of(apply(surface, {.values = {{range.name, end}}, .factors = {}}));
            shortest.longest = std::min(shortest.longest, steps.longest);
            shortest.first = std::min(shortest.first, steps.first);
        }
    }
    return shortest;
}

} // namespace isomotion::player
