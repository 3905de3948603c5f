#include "page/web_scene.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "scene/error.h"
#include "scene/nth_surface.h"
#include "scene/surfaces.h"
#include "synthesis/assemble.h"
#include "synthesis/inlined_size.h"
#include "synthesis/surfaces_text.h"

namespace isomotion::page {
namespace {

// `name`: of the value that is to be changed.
[[noreturn]] void refuse(const scene::Scene& scene, const std::string& name,
                         const std::string& message) {
    throw scene::SceneError(fmt::format("{}: {}", scene::place_of(scene, name), message));
}

std::string count_of(const scene::Scene& scene, int array) {
    return scene.surface.animation.arrays()[std::size_t(array)].name + ".count";
}

void expect_few_elements(const scene::Scene& scene, const synthesis::Passes& passes) {
    constexpr const char* instead =
        "draw fewer (count), or share a movie (isomotion render --movie)";
    std::int64_t others = 0;
    int largest = 0; // of the others
    for (int k = 0; k < int(passes.arrays.size()); ++k) {
        const synthesis::ArrayStorage& array = passes.arrays[std::size_t(k)];
        if (array.has_grid && array.capacity > most_elements_by_place) {
            refuse(scene, count_of(scene, k),
                   fmt::format("the array has {} elements; a page shows at most {}: {}",
                               array.capacity, most_elements_by_place, instead));
        }
        if (array.has_grid) continue;
        others += array.capacity;
        if (array.capacity > passes.arrays[std::size_t(largest)].capacity) largest = k;
    }
    if (others > most_elements) {
        refuse(scene, count_of(scene, largest),
               fmt::format("arrays whose elements a page cannot find by place have {} elements; it "
                           "shows at most {} of them: {}",
                           others, most_elements, instead));
    }
}

void expect_known(const scene::Scene& scene) {
    if (!scene::has_several_surfaces(scene)) return;
    scene::for_each_surface(scene, [](const scene::Scene& surface) {
        if (!surface.surface.material.glass) return;
        refuse(surface, "material.transmission",
               "a page shows glass of one surface alone; leave it out, or share a movie (isomotion "
               "render --movie)");
    });
}

WebSurface web_surface(scene::Scene scene) {
    WebSurface web;
    scene.surface.isolation.certify = false;
    web.passes = synthesis::assemble(
        scene, {}, {.platform = synthesis::Platform::webgl, .writes_buffers = false});
    expect_few_elements(scene, web.passes);
    synthesis::check_size(web.passes);
    web.plan = render::plan_scene(scene, web.passes, largest_tile, largest_tile, largest_tile, {});
    if (web.plan.march.evaluations_per_pass <= 1)
        web.passes = synthesis::without_fused_pass(std::move(web.passes));
    web.scene = std::move(scene);
    return web;
}

// Makes surfaces agree as render::plan_surfaces() does.
void agree(std::vector<WebSurface>& surfaces) {
    std::vector<synthesis::Passes*> passes;
    render::MarchPlan& plan = surfaces.front().plan.march;
    for (WebSurface& one : surfaces) {
        passes.push_back(&one.passes);
        plan.tile_width = std::min(plan.tile_width, one.plan.march.tile_width);
        plan.tile_height = std::min(plan.tile_height, one.plan.march.tile_height);
    }
    synthesis::agree_on_draws(passes);
}

} // namespace

WebScene web_scene(scene::Scene scene) {
    expect_known(scene);
    WebScene web;
    for (int k = 0; k < int(scene::surface_count(scene)); ++k)
        web.surfaces.push_back(web_surface(scene::of_surface(scene, k)));
    if (web.surfaces.size() > 1) agree(web.surfaces);
    web.whole = std::move(scene);
    return web;
}

} // namespace isomotion::page
