#include "page/description.h"

#include <algorithm>
#include <bit>
#include <filesystem>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/document.h"
#include "base/file.h"
#include "base/file_text.h"
#include "formula/graph/operations.h"
#include "page/rules.h"
#include "player/model/controls.h"
#include "player/model/held_steps.h"
#include "player/model/timeline_markers.h"
#include "render/beam_pass.h"
#include "render/march_plan.h"
#include "render/sample_pattern.h"
#include "scene/color_map.h"
#include "shader/beam_copies_text.h"
#include "shader/effect.h"
#include "shader/effect_text.h"

namespace isomotion::page {
namespace {

using Json = nlohmann::ordered_json;
using shader::Role;

constexpr std::size_t longest_source = 200'000; // bytes
// A picture at rest is refined to the mean of so many samples, as in the player.
constexpr int fewest_samples = 16;

std::string name_of(Role role) {
    switch (role) {
    case Role::beams:
        return "beams";
    case Role::beam_copies:
        return "beamCopies";
    case Role::mask:
        return "mask";
    case Role::fused:
        return "fused";
    case Role::march:
        return "march";
    case Role::active:
        return "active";
    case Role::surface:
        return "surface";
    case Role::mirror:
        return "mirror";
    case Role::mirror_surface:
        return "mirrorSurface";
    case Role::glass_first:
        return "glassFirst";
    case Role::glass:
        return "glass";
    case Role::glass_next:
        return "glassNext";
    case Role::glass_copy:
        return "glassCopy";
    case Role::glass_mask:
        return "glassMask";
    case Role::glass_active:
        return "glassActive";
    case Role::glass_ground:
        return "glassGround";
    case Role::seen:
        return "seen";
    case Role::shadow:
        return "shadow";
    case Role::occlusion:
        return "occlusion";
    case Role::shade:
        return "shade";
    default:
        return ""; // of no page
    }
}

// Passes share most of their text: each line is kept once.
class Texts {
public:
    Json lines_of(const std::string& text) {
        Json numbers = Json::array();
        for (std::size_t begin = 0; begin < text.size();) {
            const std::size_t end = std::min(text.find('\n', begin), text.size());
            numbers.push_back(number_of(text.substr(begin, end - begin)));
            begin = end + 1;
        }
        return numbers;
    }
    const Json& all() const { return all_; }

private:
    std::size_t number_of(const std::string& line) {
        const auto [found, is_new] = numbers_.emplace(line, numbers_.size());
        if (is_new) all_.push_back(line);
        return found->second;
    }

    std::map<std::string, std::size_t> numbers_;
    Json all_ = Json::array();
};

Json passes_of(const WebSurface& web, Texts& texts) {
    Json all = Json::array();
    for (const shader::Pass& pass : web.passes.list) {
        all.push_back({{"role", name_of(pass.role)},
                       {"name", pass.name},
                       {"level", pass.level},
                       {"exceptional", shader::is_exceptional(pass.when)},
                       {"vertex", texts.lines_of(pass.vertex)},
                       {"text", texts.lines_of(pass.text)},
                       {"samplers", pass.samplers},
                       {"blocks", pass.blocks}});
    }
    return all;
}

Json beams_of(const WebSurface& web) {
    Json all = Json::array();
    const bool copied = shader::has_copies(web.passes);
    for (const shader::BeamLevel& level : web.passes.beams) {
        all.push_back(
            {{"block", level.block},
             {"square", 1 << level.square_bits},
             {"masks", shader::masks_of_level(web.passes, level)},
             {"lists", copied ? shader::lists_of_a_block(level) : 0},
             {"listRows", copied ? shader::rows_of_copies(web.passes, int(all.size())) : 0},
             {"evaluations",
              render::evaluations_of_a_beam(web.passes, *web.one.surface.field, level.lists)}});
    }
    return all;
}

Json places_of(const std::vector<Place>& places) {
    Json all = Json::array();
    for (const Place& place : places) all.push_back({place.name, place.count});
    return all;
}

Json tables_of(const SurfaceValues& values) {
    Json all = Json::array();
    for (const ValueTable* table : values.tables())
        all.push_back({{"name", table->name()}, {"width", table->width()}});
    return all;
}

Json arrays_of(const WebSurface& web, const SurfaceValues& values) {
    Json all = Json::array();
    for (const auto& array : web.passes.arrays) {
        const bool in_block = array.kind == shader::ArrayStorage::Kind::uniform_block;
        const auto& computed = values.computed[all.size()];
        all.push_back(
            {{"name", in_block ? array.name + "_block" : array.name},
             {"texture", !in_block},
             {"computed", computed ? json_of(*computed, web.one.surface, all.size()) : Json()}});
    }
    return all;
}

// Where the elements are that a page finds by place; null where it goes through all.
Json grid_of(const WebSurface& web) {
    const auto array = shader::array_with_grid(web.passes);
    if (!array) return nullptr;
    return {{"array", *array},
            // Its place in the block Parameters, in floats.
            {"place", 4 * (web.passes.parameter_vectors + web.passes.count_vectors)},
            {"leastOfNone", formula::Operations<float>::least_of_none()}};
}

// What a slider makes of elements may matter in other cells: then the shaders go through all.
bool can_go_through_all(const WebSurface& web) {
    const auto array = shader::array_with_grid(web.passes);
    return !array || web.passes.arrays[std::size_t(*array)].capacity <= most_elements;
}

// Named as in the player where there are several surfaces.
Json sliders_of(const WebScene& web) {
    Json all = Json::array();
    const std::size_t count = web.surfaces.size();
    for (std::size_t k = 0; k < count; ++k) {
        if (!can_go_through_all(web.surfaces[k])) continue;
        const scene::OneSurface& one = web.surfaces[k].one;
        const std::string prefix = count == 1 ? "" : one.surface.label + "/";
        for (const player::SliderRange& range : player::slider_ranges(one)) {
            if (!(range.least < range.most) || !can_be_held(one.surface, range.track)) continue;
            all.push_back({{"name", prefix + range.name},
                           {"surface", k},
                           {"place", range.track},
                           {"least", range.least},
                           {"most", range.most}});
        }
    }
    return all;
}

std::string kind_of(player::TimelineMarker::Kind kind) {
    switch (kind) {
    case player::TimelineMarker::Kind::key:
        return "key";
    case player::TimelineMarker::Kind::event:
        return "event";
    case player::TimelineMarker::Kind::unresolved:
        return "unresolved";
    }
    return "";
}

// Keys are the author's business, events everybody's.
Json markers_of(const scene::Scene& scene, const PageOptions& options) {
    Json all = Json::array();
    // A timeline is of one surface.
    if (!scene.formula.empty() || scene.surfaces.size() > 1) return all;
    const auto found = player::read_topology_markers(scene, player::timeline_path(scene));
    if (!found.refusal.empty() && options.warn) options.warn(found.refusal);
    for (const player::TimelineMarker& marker : found.markers) {
        // A page's shaders draw in another arithmetic, so the label says what was found and not how
        // surely.
        std::string label = marker.label;
        if (const auto note = label.find(" (not proved)"); note != label.npos)
            label.erase(note, std::string_view(" (not proved)").size());
        all.push_back({{"kind", kind_of(marker.kind)}, {"frame", marker.frame}, {"label", label}});
    }
    return all;
}

std::string source_of(const scene::Scene& scene) {
    if (!scene.formula.empty()) return scene.formula;
    std::error_code error;
    const auto size = std::filesystem::file_size(scene.file, error);
    if (error || size > longest_source) return "";
    return base::read_whole_text(scene.file, longest_source);
}

Json pattern_of(int samples) {
    Json all = Json::array();
    for (const render::Sample& sample : render::sample_pattern(samples)) {
        const auto& [pixel, lens] = sample.aim;
        all.push_back({pixel.x, pixel.y, lens.x, lens.y});
    }
    return all;
}

Json steps_of(const formula::CubicSteps& steps) {
    return {{"first", steps.first}, {"longest", steps.longest}};
}

// What the block Frame holds beside rays: render/uniform_blocks.cpp.
Json settings_of(const scene::OneSurface& one) {
    const scene::Isolation& isolation = one.surface.isolation;
    const double scale = one.surface.field->scale;
    return {{"method", scene::name(isolation.method)},
            {"step", isolation.step},
            {"near", scale * isolation.near},
            {"far", scale * isolation.far},
            {"horizon", scale * isolation.horizon},
            {"bisections", isolation.bisections},
            {"limit", isolation.limit},
            {"safety", isolation.safety},
            {"cubics", scene::traits(isolation.method).steps == scene::Steps::cubics},
            {"steps", steps_of(one.surface.measured.cubic_steps)},
            {"heldSteps", steps_of(player::steps_at_slider_ends(one))}};
}

// One line of what `isomotion accuracy` measured of the scene's own method and step.
std::string accuracy_of(const scene::Scene& scene, const std::filesystem::path& report) {
    const auto file = std::filesystem::is_directory(report) ? report / "accuracy.json" : report;
    constexpr std::size_t longest = 1 << 24;
    const auto document = base::Document::from_json(base::file_text(file, longest), file.string());
    base::DocumentTable table = document.table();
    const base::DocumentNode title = table.at("scene");
    if (title.text() != scene.title)
        title.fail(fmt::format("the report is of '{}', not of '{}'", title.text(), scene.title));
    const auto width = table.at("width").whole(), height = table.at("height").whole();
    const scene::Isolation& isolation = scene.surfaces.front().isolation;
    const std::string machine = table.at("machine").text();
    for (const base::DocumentNode& node : table.at("measurements").list()) {
        base::DocumentTable row = node.table();
        const bool is_own = row.at("method").text() == scene::name(isolation.method) &&
                            row.at("step").number() == isolation.step &&
                            row.at("thresholds").number() == 1 &&
                            row.at("bisections").whole() == isolation.bisections &&
                            row.at("safety").number() == isolation.safety;
        if (!is_own) continue;
        return fmt::format("{:.3g} wrong pixels in a million, {:.3g} ms a frame of {} x {} ({})",
                           row.at("wrong_ppm").number(), row.at("ms").number(), width, height,
                           machine);
    }
    table.at("measurements").fail("none is of the scene's own method and step");
}

// Lights that go with the camera.
Json viewers_lights_of(const scene::Scene& scene) {
    Json all = Json::array();
    for (std::size_t k = 0; k < scene.lights.size(); ++k) {
        if (scene.lights[k].headlight || scene.lights[k].with_camera) all.push_back(k);
    }
    return all;
}

// How one surface is drawn.
Json surface_of(const WebSurface& web, const SurfaceValues& values, Texts& texts) {
    const scene::OneSurface& one = web.one;
    const shader::Passes& passes = web.passes;
    Json all;
    all["box"] = one.surface.bounds.shape == scene::Bounds::Shape::box;
    all["settings"] = settings_of(one);
    all["rules"] = rules_of(one.surface);
    all["evaluations"] = web.plan.march.evaluations_per_pass;
    all["shadowLights"] = std::popcount(unsigned(shader::shadow_mask(one.scene)));
    all["stateTextures"] = passes.state_textures;
    all["beams"] = beams_of(web);
    all["squaresApart"] = shader::beam_square;
    all["parameterVectors"] = passes.parameter_vectors;
    all["arrays"] = arrays_of(web, values);
    all["grid"] = grid_of(web);
    all["elementBudget"] = web.plan.element_budget;
    all["passes"] = passes_of(web, texts);
    all["view"] = places_of(values.view_places);
    all["effects"] = places_of(values.effect_places);
    all["tables"] = tables_of(values);
    return all;
}

} // namespace

std::string formulas_of(const WebScene& web) {
    if (web.surfaces.size() == 1) return web.surfaces.front().one.surface.field->text;
    std::string all;
    for (const WebSurface& surface : web.surfaces) {
        const scene::Surface& its = surface.one.surface;
        all += fmt::format("{}{}: {}", all.empty() ? "" : "\n", its.label, its.field->text);
    }
    return all;
}

std::string description(const WebScene& web, const FrameValues& values,
                        const Environment* environment, const PageOptions& options) {
    const scene::Scene& scene = *web.scene;
    const auto& glass = scene.surfaces.front().material.glass; // a page shows it of one surface
    const animation::Timeline& timeline = scene.timeline;
    Texts texts;
    Json all;
    all["title"] = scene.title;
    all["formula"] = formulas_of(web);
    all["source"] = source_of(scene);
    all["frames"] = timeline.frames;
    all["fps"] = {timeline.fps.numerator, timeline.fps.denominator};
    all["moments"] = moments(scene);
    all["loops"] = timeline.loops;
    all["poster"] = scene.output.poster;
    all["size"] = {scene.output.width, scene.output.height};
    all["transparent"] = scene.output.transparent;
    all["samples"] = scene.output.samples;
    all["pattern"] = pattern_of(std::max(scene.output.samples, fewest_samples));
    const bool is_few = scene.output.samples > 1 && scene.output.samples < fewest_samples;
    if (is_few || moments(scene).size() > 1) all["pattern"] = pattern_of(scene.output.samples);
    all["parallel"] = scene.camera.projection == scene::Camera::Projection::orthographic;
    all["lights"] = scene.lights.size();
    all["viewersLights"] = viewers_lights_of(scene);
    all["glassDepth"] = glass ? glass->depth : 0;
    all["sliders"] = sliders_of(web);
    all["markers"] = markers_of(scene, options);
    if (options.report) all["accuracy"] = accuracy_of(scene, *options.report);
    all["tile"] = web.surfaces.front().plan.march.tile_width;
    for (std::size_t k = 0; k < web.surfaces.size(); ++k)
        all["surfaces"].push_back(surface_of(web.surfaces[k], values[k], texts));
    all["lines"] = texts.all();
    if (environment) all["environment"] = {environment->map.width, environment->map.height};
    if (environment && environment->levels)
        all["environmentLevels"] = {environment->levels->width, environment->levels->height};
    // A scene's text may be no UTF-8.
    return all.dump(-1, ' ', false, Json::error_handler_t::replace);
}

} // namespace isomotion::page
