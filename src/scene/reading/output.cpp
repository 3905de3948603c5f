#include "scene/reading/output.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "scene/key_tables.h"
#include "scene/limits.h"
#include "scene/reading/read_keys.h"

namespace isomotion::scene {
namespace {

std::array<double, 3> read_still_color(const toml::node& node, const std::string& key,
                                       const char* right) {
    const toml::array* list = node.as_array();
    if (!list || list->size() != 3) fail(node, key, right);
    std::array<double, 3> color;
    for (std::size_t k = 0; k < 3; ++k) {
        color[k] = read_finite(*list->get(k), key);
        if (std::abs(color[k]) > limits::brightness)
            fail(*list->get(k), key,
                 fmt::format("a colour's parts are from {:g} to {:g}", -limits::brightness,
                             limits::brightness));
    }
    return color;
}

// Whether --set says how long the scene is; only a file's values have a path.
bool are_frames_set(const Section& document) {
    const auto is_set = [](const toml::node* node) { return node && !node->source().path; };
    const auto time = document.table()["time"];
    return is_set(time["frames"].node()) || is_set(time["seconds"].node()) ||
           is_set(time["fps"].node());
}

SkyGradient read_gradient(Section section) {
    SkyGradient gradient;
    const auto read = [&](const char* name, std::array<double, 3>& color) {
        const toml::node* node = section.find(name);
        if (!node) {
            section.tell_missing(name, "[r, g, b]");
            return;
        }
        section.attempt(name, [&] {
            color = read_still_color(*node, section.dotted(name), "must be [r, g, b] (linear)");
        });
    };
    read("top", gradient.top);
    read("bottom", gradient.bottom);
    section.refuse_rest();
    return gradient;
}

void read_size(const toml::node& node, Output& output) {
    constexpr int most = limits::picture_side;
    const toml::array* size = node.as_array();
    const auto width =
        size && size->size() == 2 ? size->get(0)->value_exact<std::int64_t>() : std::nullopt;
    const auto height = width ? size->get(1)->value_exact<std::int64_t>() : std::nullopt;
    if (!width || !height || *width < 1 || *height < 1 || *width > most || *height > most) {
        fail(node, "output.size",
             fmt::format("must be [width, height], integers from 1 to {}", most));
    }
    output.width = int(*width);
    output.height = int(*height);
}

void read_background(Section& section, const toml::node& node, Output& output) {
    if (node.value_exact<std::string>() == "transparent") {
        output.transparent = true;
        output.background = {0, 0, 0};
    } else if (node.is_table()) {
        if (const auto background = section.section("background"))
            output.gradient = read_gradient(*background);
    } else {
        section.attempt("background", [&] {
            output.background =
                read_still_color(node, "output.background",
                                 "must be [r, g, b] (linear), { top = [r, g, b], bottom = "
                                 "[r, g, b] } or \"transparent\"");
        });
    }
}

} // namespace

void read_output(Section& document, Scene& scene) {
    Output& output = scene.output;
    output.background = {0.86, 0.86, 0.9};
    // One picture shows no blur.
    const bool has_wide_light =
        std::ranges::any_of(scene.lights, [](const Light& light) { return bool(light.radius); });
    output.samples = scene.camera.shutter > 0 || scene.camera.aperture || has_wide_light ? 16 : 1;
    auto section = document.section("output");
    if (!section) return;
    if (const toml::node* node = section->find("size"))
        section->attempt("size", [&] { read_size(*node, output); });
    if (const toml::node* node = section->find("background"))
        read_background(*section, *node, output);
    read_keys(keys::output_keys, *section, output);
    if (output.poster > scene.timeline.frames) {
        const toml::node& poster = *section->find("poster");
        // Fewer frames are wanted than the file has: the last of them stands for all.
        if (!are_frames_set(document) || !poster.source().path)
            section->tell("poster",
                          fmt::format("must be from 1 to {}, a frame of the scene, not {}",
                                      scene.timeline.frames, output.poster));
        output.poster = scene.timeline.frames;
    }
    section->refuse_rest();
}

} // namespace isomotion::scene
