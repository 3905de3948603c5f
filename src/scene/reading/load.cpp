#include "scene/reading/load.h"

#include <algorithm>
#include <optional>
#include <set>
#include <span>
#include <string_view>

#include <fmt/format.h>

#include "base/printable.h"
#include "scene/reading/mistakes.h"
#include "scene/reading/named_file.h"
#include "scene/reading/overrides.h"
#include "scene/reading/scene_document.h"
#include "scene/reading/scene_reader.h"
#include "scene/reading/scene_text.h"
#include "scene/reading/surface_list.h"
#include "scene/scene_at.h"

namespace isomotion::scene {
namespace fs = std::filesystem;
namespace {

// A pixel is proved if what its ray meets of each surface is.
void certify_all_or_none(std::vector<Surface>& surfaces) {
    const bool any = std::ranges::any_of(
        surfaces, [](const Surface& surface) { return surface.isolation.certify; });
    for (Surface& surface : surfaces) surface.isolation.certify = any;
}

// Whether the surface is drawn by elements of the array.
bool uses_array(const Surface& surface, std::string_view name) {
    const auto& arrays = surface.animation.arrays();
    const auto found = std::ranges::find(arrays, name, &animation::Array::name);
    if (found == arrays.end()) return false;
    std::vector<const formula::Graph*> graphs{&surface.field->graph};
    for (const formula::Paint* paint : paints_of(surface.material)) graphs.push_back(&paint->graph);
    return std::ranges::any_of(graphs, [&](const formula::Graph* graph) {
        for (formula::NodeId id = 0; id < graph->size(); ++id) {
            const formula::Node& node = (*graph)[id];
            if (formula::is_over_elements(node.op) && node.index == found - arrays.begin())
                return true;
        }
        return false;
    });
}

// `key`: of the table, "arrays" or "surfaces.ring.arrays"; the surfaces that may use them.
void refuse_unused_arrays(const toml::node* table, const std::string& key,
                          std::span<const Surface> surfaces) {
    const toml::table* arrays = table ? table->as_table() : nullptr;
    if (!arrays) return;
    for (const auto& entry : *arrays) {
        const toml::table* array = entry.second.as_table();
        const toml::node* count = array ? array->get("count") : nullptr;
        if (!count || position(*count) != "--set") continue;
        const std::string_view name = entry.first.str();
        const bool is_used = std::ranges::any_of(
            surfaces, [&](const Surface& surface) { return uses_array(surface, name); });
        if (is_used) continue;
        fail(*count, fmt::format("{}.{}.count", key, name),
             "no formula and no colour sums or picks over an array of this name");
    }
}

// A file may hold arrays that nothing uses; a count that was set is to have an effect.
void refuse_unused_arrays(const toml::table& root, const Scene& scene) {
    const std::span<const Surface> surfaces = scene.surfaces;
    refuse_unused_arrays(root.get("arrays"), "arrays", surfaces);
    if (!lists_surfaces(root)) return;
    for (std::size_t k = 0; k < surfaces.size(); ++k) {
        const toml::table& own = *root.get("surfaces")->as_array()->get(k)->as_table();
        refuse_unused_arrays(own.get("arrays"),
                             fmt::format("surfaces.{}.arrays", surfaces[k].label),
                             surfaces.subspan(k, 1));
    }
}

Scene read_listed(toml::table& root, const fs::path& file, const base::Confines& within) {
    MistakeList in_names;
    const std::vector<std::string> names = listed_names(root, in_names);
    std::set<std::string> unused = shared_parameters(root);
    Scene all;
    std::vector<Surface> surfaces;
    std::optional<Mistakes> mistakes = in_names.all();
    std::size_t nodes = 0; // of all formulas
    for (std::size_t k = 0; k < names.size(); ++k) {
        std::set<std::string> for_others = shared_parameters(root);
        for (const std::string& own : own_parameters(root, k)) for_others.erase(own);
        const std::set<std::string> shared = for_others;
        Scene scene;
        try {
            scene = SceneReader(root, within, ListedSurface{listed(root, k), names[k], for_others})
                        .read(file);
        } catch (const Mistakes& of_surface) {
            mistakes = mistakes ? joined(*mistakes, of_surface) : of_surface;
            continue;
        }
        for (const std::string& name : shared) {
            if (!for_others.contains(name)) unused.erase(name);
        }
        nodes += scene.surfaces.front().field->nodes_read;
        if (nodes > formula::limits::formula_nodes) {
            fail(listed(root, k), fmt::format("surfaces.{}.formula", names[k]),
                 fmt::format("this formula and those before it have more than {} operations, names "
                             "and numbers together",
                             formula::limits::formula_nodes));
        }
        surfaces.push_back(std::move(scene.surfaces.front()));
        if (k == 0) all = std::move(scene);
    }
    if (mistakes) throw Mistakes(*mistakes);
    certify_all_or_none(surfaces);
    if (!unused.empty()) {
        fail(*root["parameters"].as_table()->get(*unused.begin()), "parameters." + *unused.begin(),
             "no surface's formula and no expression uses this parameter");
    }
    all.surfaces = std::move(surfaces);
    at_frame(all, 1); // with a camera that sees all
    return all;
}

Scene read_scene(toml::table& root, const fs::path& file, const std::vector<Override>& overrides,
                 const base::Confines& within) {
    for (const Override& setting : overrides) override_key(root, setting);
    Scene scene = lists_surfaces(root) ? read_listed(root, file, within)
                                       : SceneReader(root, within).read(file);
    refuse_unused_arrays(root, scene);
    return scene;
}

// A formula alone has no parameters but those that are set.
std::string how_to_name(std::string_view mistake) {
    constexpr std::string_view start = "unknown name '";
    if (!mistake.starts_with(start)) return "";
    const std::string_view name =
        mistake.substr(start.size(), mistake.find('\'', start.size()) - start.size());
    return fmt::format("\n--set {}=1 makes it a parameter", name);
}

// Loads what load() takes. `root` is left as the document with all that was set and found.
Scene load_into(toml::table& root, const std::string& name, const std::vector<Override>& overrides,
                Reach reach) {
    SceneDocument document = find_document(name, overrides, reach);
    root = std::move(document.root);
    try {
        Scene scene = read_scene(root, document.file, overrides, document.within);
        if (is_formula_alone(name)) scene.formula = name;
        return scene;
    } catch (const SceneError& error) {
        // A formula's mistakes are in no file and in no --set.
        constexpr std::string_view place = "--set: surface.formula: ";
        std::string words = error.what();
        const std::size_t found = words.find(place);
        if (!is_formula_alone(name) || found == words.npos) throw;
        words.erase(found, place.size());
        throw SceneError(words + how_to_name(std::string_view(words).substr(found)));
    }
}

} // namespace

std::string title(const fs::path& file) {
    if (is_of_another_program(file)) return base::printable_line(file.stem().string());
    const toml::table root = read_document(file);
    MistakeList mistakes;
    Section document(root, "", mistakes);
    std::string title = read_title(document, file);
    mistakes.throw_if_any();
    return title;
}

Scene load(const std::string& name, const std::vector<Override>& overrides, Reach reach) {
    toml::table root;
    return load_into(root, name, overrides, reach);
}

Scene load_text(std::string_view text, const fs::path& file, const std::vector<Override>& overrides,
                Reach reach) {
    toml::table root = parse_scene(text, file);
    return read_scene(root, file, overrides,
                      confines(base::open_folder(file.parent_path()), reach));
}

std::string scene_file_text(const std::string& name, const std::vector<Override>& overrides,
                            Reach reach) {
    toml::table root;
    load_into(root, name, overrides, reach);
    if (lists_surfaces(root) && root["look"].value_or(std::string("none")) != "none") {
        throw SceneError(
            fmt::format("{}: a scene with [[surfaces]] and a look cannot be written as "
                        "a file; set look=none, or write the keys of the look",
                        name));
    }
    return scene_text(root);
}

} // namespace isomotion::scene
