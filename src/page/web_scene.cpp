#include "page/web_scene.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "scene/error.h"
#include "scene/surfaces.h"
#include "shader/assemble.h"
#include "shader/inlined_size.h"
#include "shader/surfaces_text.h"

namespace isomotion::page {
namespace {

// `name`: of the value that is to be changed.
[[noreturn]] void refuse(const scene::OneSurface& one, const std::string& name,
                         const std::string& message) {
    throw scene::SceneError(fmt::format("{}: {}", scene::place_of(one, name), message));
}

std::string count_of(const scene::OneSurface& one, int array) {
    return one.surface.animation.arrays()[std::size_t(array)].name + ".count";
}

void expect_few_elements(const scene::OneSurface& one, const shader::Passes& passes) {
    constexpr const char* instead =
        "draw fewer (count), or share a movie (isomotion render --movie)";
    std::int64_t others = 0;
    int largest = 0; // of the others
    for (int k = 0; k < int(passes.arrays.size()); ++k) {
        const shader::ArrayStorage& array = passes.arrays[std::size_t(k)];
        if (array.has_grid && array.capacity > most_elements_by_place) {
            refuse(one, count_of(one, k),
                   fmt::format("the array has {} elements; a page shows at most {}: {}",
                               array.capacity, most_elements_by_place, instead));
        }
        if (array.has_grid) continue;
        others += array.capacity;
        if (array.capacity > passes.arrays[std::size_t(largest)].capacity) largest = k;
    }
    if (others > most_elements) {
        refuse(one, count_of(one, largest),
               fmt::format("arrays whose elements a page cannot find by place have {} elements; it "
                           "shows at most {} of them: {}",
                           others, most_elements, instead));
    }
}

void expect_known(const scene::OneSurface& one) {
    if (one.is_alone() || !one.surface.material.glass) return;
    refuse(one, "material.transmission",
           "a page shows glass of one surface alone; leave it out, or share a movie (isomotion "
           "render --movie)");
}

WebSurface web_surface(const scene::OneSurface& one) {
    WebSurface web{
        one,
        shader::assemble(one, {}, {.platform = shader::Platform::webgl, .writes_buffers = false}),
        {}};
    expect_few_elements(one, web.passes);
    shader::check_size(web.passes);
    web.plan = render::plan_scene(one, web.passes, largest_tile, largest_tile, largest_tile, {});
    if (web.plan.march.evaluations_per_pass <= 1)
        web.passes = shader::without_fused_pass(std::move(web.passes));
    return web;
}

// Makes surfaces agree as render::plan_surfaces() does.
void agree(std::vector<WebSurface>& surfaces) {
    std::vector<shader::Passes*> passes;
    render::MarchPlan& plan = surfaces.front().plan.march;
    for (WebSurface& one : surfaces) {
        passes.push_back(&one.passes);
        plan.tile_width = std::min(plan.tile_width, one.plan.march.tile_width);
        plan.tile_height = std::min(plan.tile_height, one.plan.march.tile_height);
    }
    shader::agree_on_draws(passes);
}

} // namespace

WebScene web_scene(scene::Scene scene) {
    for (scene::Surface& surface : scene.surfaces) surface.isolation.certify = false;
    WebScene web;
    web.scene = std::make_shared<const scene::Scene>(std::move(scene));
    const std::size_t count = web.scene->surfaces.size();
    for (std::size_t k = 0; k < count; ++k) expect_known({*web.scene, k});
    for (std::size_t k = 0; k < count; ++k) web.surfaces.push_back(web_surface({*web.scene, k}));
    if (count > 1) agree(web.surfaces);
    return web;
}

} // namespace isomotion::page
