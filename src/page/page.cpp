#include "page/page.h"

#include <optional>
#include <span>
#include <vector>

#include "base/base64.h"
#include "page/description.h"
#include "page/embedded_files.h"
#include "page/html.h"
#include "probe/unbounded.h"

namespace isomotion::page {
namespace {

// The scripts, in an order in which what runs at once comes last.
constexpr const char* scripts[] = {
    "vectors.js",  "grid.js",         "data.js",    "rays.js",  "orbit.js", "lights.js",
    "playback.js", "rules.js",        "address.js", "look.js",  "gl.js",    "passes.js",
    "surface.js",  "further_rays.js", "several.js", "glass.js", "tile.js",  "screen.js",
    "elements.js", "resolution.js",   "painter.js", "hands.js", "panel.js", "main.js"};

void append(std::vector<std::byte>& to, std::string_view text) {
    for (const char c : text) to.push_back(std::byte(c));
}

void append_word(std::vector<std::byte>& to, std::size_t word) {
    for (int place = 0; place < 4; ++place) to.push_back(std::byte(word >> (8 * place) & 0xff));
}

// The length of the description, the description, the tables, exceptions and grids of each surface,
// the environment map and its levels.
std::vector<std::byte> data_of(const WebScene& web, const PageOptions& options) {
    const FrameValues values = frame_values(web);
    const std::optional<Environment> around = environment(*web.scene, options.warn);
    const std::string described = description(web, values, around ? &*around : nullptr, options);
    std::vector<std::byte> data;
    append_word(data, described.size());
    append(data, described);
    for (const SurfaceValues& surface : values) {
        for (const ValueTable* table : surface.tables()) table->pack(data);
        for (const auto& computed : surface.computed) {
            if (computed) pack(*computed, data);
        }
        data.insert(data.end(), surface.grids.begin(), surface.grids.end());
    }
    const auto append_texels = [&](const EnvironmentMap& map) {
        data.insert(data.end(), map.texels.begin(), map.texels.end());
    };
    if (around) append_texels(around->map);
    if (around && around->levels) append_texels(*around->levels);
    return data;
}

std::string movie_element(std::span<const std::byte> movie) {
    if (movie.empty()) return "";
    return "<video id=\"movie\" hidden controls loop muted playsinline preload=\"none\" "
           "src=\"data:video/mp4;base64," +
           base::base64(movie) + "\"></video>";
}

// A page that stays empty would tell nobody why.
void warn_of_unbounded(const scene::Scene& scene, const PageOptions& options) {
    if (!options.warn) return;
    for (std::size_t k = 0; k < scene.surfaces.size(); ++k) {
        const scene::OneSurface one(scene, k);
        const auto why = probe::why_unbounded(one, scene::surface_at(one, scene.timeline.time(1)));
        if (why) options.warn(*why);
    }
}

} // namespace

std::string page(const scene::Scene& scene, const PageOptions& options) {
    const WebScene web = web_scene(scene);
    warn_of_unbounded(scene, options);
    const auto files = embedded_files();
    std::string script;
    for (const char* name : scripts) script.append(files.at(name)).append("\n");
    return filled(files.at("page.html"),
                  {{"title", html_text(scene.title)},
                   {"formula", html_text(formulas_of(web))},
                   {"movie", movie_element(options.movie)},
                   {"style", std::string(files.at("page.css"))},
                   {"script", script},
                   {"data", deflated_text(data_of(web, options))},
                   {"screen.vert", std::string(files.at("screen.vert"))},
                   {"add.frag", std::string(files.at("add.frag"))},
                   {"show.frag", std::string(files.at("show.frag"))},
                   {"unfinished.frag", std::string(files.at("unfinished.frag"))}});
}

} // namespace isomotion::page
