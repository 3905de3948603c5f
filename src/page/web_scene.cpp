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

void expect_few_elements(const scene::Scene& scene) {
    std::int64_t elements = 0;
    for (const auto& array : scene.timeline.animation.arrays()) elements += array.count;
    if (elements <= most_elements) return;
    refuse(scene, fmt::format("arrays have {} elements; a page shows at most {}: draw fewer "
                              "(count), or share a movie (isomotion render --movie)",
                              elements, most_elements));
}

// Pictures of one frame at many times would be as many times the data.
void expect_no_motion_blur(const scene::Scene& scene) {
    if (scene.camera.shutter == 0 || scene.output.samples == 1) return;
    refuse(scene, "camera.shutter: a page shows no motion blur: make it with "
                  "--set camera.shutter=0, or share a movie (isomotion render --movie)");
}

// At 4 bytes a field, before anything is evaluated.
void expect_little_data(const scene::Scene& scene) {
    const animation::Animation& animation = scene.timeline.animation;
    double numbers = 0;
    for (std::size_t a = 0; a < animation.arrays().size(); ++a) numbers += animation.values(a);
    numbers += double(animation.tracks().size());
    const double bytes = 4 * numbers * scene.timeline.frames;
    if (bytes <= double(most_value_bytes)) return;
    refuse(scene, fmt::format("the values of {} frames are {:.0f} MB; a page holds at most {}: "
                              "take fewer frames (time.frames) or elements",
                              scene.timeline.frames, bytes / 1e6, most_value_bytes / 1'000'000));
}

} // namespace

WebScene web_scene(scene::Scene scene) {
    scene::expect_one_surface(scene, "a page");
    expect_no_motion_blur(scene);
    expect_few_elements(scene);
    expect_little_data(scene);
    WebScene web;
    scene.isolation.certify = false;
    web.passes = synthesis::assemble(scene, {}, synthesis::Stage::fragment, false,
                                     synthesis::usual_beam, false, synthesis::Platform::webgl);
    synthesis::check_size(web.passes);
    web.plan = render::plan_scene(scene, web.passes, largest_tile, largest_tile, largest_tile, {});
    if (web.plan.march.evaluations_per_pass <= 1)
        web.passes = synthesis::without_fused_pass(std::move(web.passes));
    web.scene = std::move(scene);
    return web;
}

} // namespace isomotion::page
