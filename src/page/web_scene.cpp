#include "page/web_scene.h"

#include <cstdint>

#include <fmt/format.h>

#include "scene/error.h"
#include "scene/surfaces.h"
#include "synthesis/assemble.h"
#include "synthesis/inlined_size.h"

namespace isomotion::page {
namespace {

[[noreturn]] void refuse(const scene::Scene& scene, const std::string& message) {
    throw scene::SceneError(fmt::format("{}: {}", scene.file.string(), message));
}

void expect_few_elements(const scene::Scene& scene, const synthesis::Passes& passes) {
    constexpr const char* instead =
        "draw fewer (count), or share a movie (isomotion render --movie)";
    std::int64_t by_place = 0, others = 0;
    for (const synthesis::ArrayStorage& array : passes.arrays)
        (array.has_grid ? by_place : others) += array.capacity;
    if (by_place > most_elements_by_place) {
        refuse(scene, fmt::format("an array has {} elements; a page shows at most {}: {}", by_place,
                                  most_elements_by_place, instead));
    }
    if (others > most_elements) {
        refuse(scene,
               fmt::format("arrays whose elements a page cannot find by place have {} elements; it "
                           "shows at most {} of them: {}",
                           others, most_elements, instead));
    }
}

} // namespace

WebScene web_scene(scene::Scene scene) {
    if (!scene.others.empty()) {
        refuse(scene, fmt::format("surfaces: there are {}, and a page shows one; leave the others "
                                  "out, or share a movie (isomotion render --movie)",
                                  scene.among.count));
    }
    if (scene.material.glass) {
        refuse(scene,
               "material.transmission: a page shows no glass; leave it out, or share a movie "
               "(isomotion render --movie)");
    }
    WebScene web;
    scene.isolation.certify = false;
    web.passes = synthesis::assemble(scene, {}, synthesis::Stage::fragment, false,
                                     synthesis::usual_beam, false, synthesis::Platform::webgl);
    expect_few_elements(scene, web.passes);
    synthesis::check_size(web.passes);
    web.plan = render::plan_scene(scene, web.passes, largest_tile, largest_tile, largest_tile, {});
    if (web.plan.march.evaluations_per_pass <= 1)
        web.passes = synthesis::without_fused_pass(std::move(web.passes));
    web.scene = std::move(scene);
    return web;
}

} // namespace isomotion::page
