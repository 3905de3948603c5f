#include "scene/reading/load.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numeric>
#include <set>
#include <span>

#include <fmt/format.h>

#include "base/printable.h"
#include "formula/graph/degree.h"
#include "probe/found_bounds.h"
#include "probe/measured.h"
#include "probe/thresholds.h"
#include "scene/limits.h"
#include "scene/reading/camera.h"
#include "scene/reading/environment.h"
#include "scene/reading/isolation.h"
#include "scene/reading/lights.h"
#include "scene/reading/look.h"
#include "scene/reading/material.h"
#include "scene/reading/mistakes.h"
#include "scene/reading/named_file.h"
#include "scene/reading/names.h"
#include "scene/reading/output.h"
#include "scene/reading/overrides.h"
#include "scene/reading/scene_document.h"
#include "scene/reading/scene_text.h"
#include "scene/reading/sections.h"
#include "scene/reading/space.h"
#include "scene/reading/surface.h"
#include "scene/reading/surface_list.h"
#include "scene/reading/time.h"

namespace isomotion::scene {
namespace fs = std::filesystem;
namespace {

// It goes to terminals, windows and into pictures.
std::string read_title(Section& document, const fs::path& file) {
    const auto title = document.text("title");
    if (!title) return base::printable_line(file.stem().string());
    if (title->size() > limits::title_bytes || !base::is_one_printable_line(*title)) {
        document.tell("title", fmt::format("must be one line of at most {} bytes, without control "
                                           "characters",
                                           limits::title_bytes));
    }
    return *title;
}

// What all arrays together ask for; `what` says how much of it.
void check_arrays(const animation::Animation& animation, const TrackTable& tracks, const char* what,
                  double most, double (animation::Animation::*amount)(std::size_t) const) {
    const auto& arrays = animation.arrays();
    std::vector<double> amounts;
    for (std::size_t a = 0; a < arrays.size(); ++a) amounts.push_back((animation.*amount)(a));
    const double all = std::accumulate(amounts.begin(), amounts.end(), 0.0);
    if (all <= most) return;
    const auto largest = std::size_t(std::ranges::max_element(amounts) - amounts.begin());
    const animation::Array& array = arrays[largest];
    tracks.fail_at(array.name + "." + array.fields.front().name,
                   fmt::format("the fields of {} {}, all elements counted{}; at most {:.3g} are "
                               "possible: give it fewer elements",
                               arrays.size() == 1 ? fmt::format("'{}'", array.name) : "all arrays",
                               fmt::format(fmt::runtime(what), all),
                               arrays.size() == 1 ? ""
                                                  : fmt::format(", those of '{}' {:.3g}",
                                                                array.name, amounts[largest]),
                               most));
}

// Refuses what would take minutes to read, or to be at one frame: it is no scene but a slip of the
// pen.
void check_work(const SurfaceParts& parts, const TrackTable& tracks) {
    const animation::Animation& animation = parts.surface.animation;
    const std::vector<int> counts = animation.counts();
    const double at_a_point =
        std::max(formula::cost(parts.surface.field->gradient, counts).operations,
                 formula::cost(parts.surface.field->value, counts).operations);
    if (at_a_point > limits::operations_at_a_point) {
        fail(*parts.formula_node, parts.formula_key(),
             fmt::format(
                 "takes {:.3g} operations at one point, all elements of its sums counted; at "
                 "most {:.3g} are possible: give its arrays fewer elements",
                 at_a_point, limits::operations_at_a_point));
    }
    check_arrays(animation, tracks, "hold {:.3g} values at each frame", limits::values_of_a_frame,
                 &animation::Animation::values);
    check_arrays(animation, tracks, "take {:.3g} operations at each frame",
                 limits::operations_of_a_frame, &animation::Animation::operations);
}

// A scene with sections needs no surface: caps show a solid, which may be all of space.
void expect_surface(const Scene& scene, const SurfaceParts& parts) {
    const formula::Field& field = *parts.surface.field;
    if (formula::degree(field.graph, field.root) != 0 || !scene.sections.empty()) return;
    fail(*parts.formula_node, parts.formula_key(),
         "the formula has the same value everywhere and so no surface; write an equation of x, y "
         "and z");
}

// How near to a jump counts as at it: as near as pictures of 64 pixels across tell a root from it.
constexpr double wall_part = 0x1p-15;

// Values that float32 doesn't hold well are multiplied by a power of two.
void rescale(SurfaceParts& parts, const SurfaceAt& first) {
    Surface& surface = parts.surface;
    const double scale = probe::field_scale(*surface.field, first);
    if (scale != 1) {
        surface.field = std::make_shared<formula::Field>(formula::scaled(*surface.field, scale));
    }
    const probe::Float32Loss loss = probe::float32_loss(*surface.field, first);
    if (loss.part <= 0.9) return;
    const double size = std::abs(loss.example);
    const bool is_held = size > 1e-30 && size < 1e30; // only parts of the formula are not
    const char* what = is_held
                           ? "has parts beyond what the GPU's numbers hold, 1e-37 to 1e38, where "
                             "it comes to values such as {:.1g}: choose smaller bounds, or write "
                             "it without these parts"
                           : "comes to values such as {:.1g} within the bounds; the GPU's "
                             "numbers hold 1e-37 to 1e38: multiply it by another number";
    fail(*parts.formula_node, parts.formula_key(), fmt::format(fmt::runtime(what), loss.example));
}

void put_bounds(toml::table& root, const probe::FoundBounds& found) {
    toml::array centre{found.centre.x, found.centre.y, found.centre.z};
    toml::table ball{{"sphere", found.radius}};
    if (found.centre != glm::dvec3(0)) ball.insert("centre", centre);
    root["surface"].as_table()->insert_or_assign("bounds", ball);
}

// Reads a document with one surface, and all that was set. `for_others`: parameters that other
// surfaces may use; those that this one uses are taken out of it.
class SceneReader {
public:
    SceneReader(toml::table& root, const base::Confines& within, std::set<std::string>* for_others)
        : root_(root)
        , within_(within)
        , for_others_(for_others) {}

    // Throws SceneError, Mistakes where they have places.
    Scene read(const fs::path& file) {
        scene_.file = file;
        scene_.surfaces.emplace_back();
        mistakes_.attempt([&] { surface().look = put_look(root_); });
        read_document();
        compile();
        evaluate();
        mistakes_.throw_if_any();
        mistakes_.attempt([&] {
            if (parts_->lacks_bounds) find_bounds();
            measure();
        });
        mistakes_.throw_if_any();
        return std::move(scene_);
    }

private:
    Surface& surface() { return scene_.surfaces.front(); }

    // What the file says, but for expressions.
    void read_document() {
        Section document(root_, "", mistakes_);
        scene_.title = read_title(document, scene_.file);
        document.find("look");     // what it set is in the document
        document.find("surfaces"); // of which each is read as the one
        const TimeParts time = read_time(document);
        scene_.timeline = time.timeline;
        seed_ = time.seed;
        parts_ = read_surface(document, scene_.timeline, tracks_, within_, surface());
        tracks_.place("surface.formula", parts_->formula_key(), parts_->formula_node);
        const toml::table none;
        auto given = document.section("surface");
        Section space = given ? *given : Section(none, "surface", mistakes_);
        read_space(space, *parts_, tracks_);
        scene_.camera = read_camera(document, tracks_);
        read_lights(document, scene_, tracks_);
        material_ = read_material(document, *parts_, tracks_);
        read_output(document, scene_);
        read_surroundings(document, scene_, tracks_);
        scene_.environment = read_environment(document, tracks_, within_);
        if (parts_->catalogue) {
            Section catalogue(*parts_->catalogue, "", mistakes_);
            read_isolation(catalogue, surface().isolation, given_);
        }
        read_isolation(document, surface().isolation, given_);
        scene_.sections = read_sections(document, tracks_);
        if (surface().isolation.certify && !scene_.sections.empty()) {
            mistakes_.attempt([&] {
                fail(*document.find("sections"), "isolation.certify",
                     "the GPU's proofs know no sections; leave one of the two out (audits and "
                     "`accuracy` know them)");
            });
        }
        document.refuse_rest();
    }

    // The formula and all expressions.
    void compile() {
        animate();
        const bool is_formula_right = make_field(*parts_, mistakes_);
        if (surface().field) {
            make_paints(material_, *parts_, mistakes_);
            if (is_formula_right) mistakes_.attempt([&] { expect_surface(scene_, *parts_); });
            store_elements_of(*parts_, paints_of(surface().material));
            if (is_formula_right && !mistakes_.may_name_others()) {
                refuse_unused(*parts_, paints_of(surface().material), tracks_, for_others_,
                              mistakes_);
            }
            surface().animation.keep_fields(surface().field->packing);
            may_evaluate_ = mistakes_.attempt([&] { check_work(*parts_, tracks_); });
        }
        surface().value_places = std::make_shared<const ValuePlaces>(tracks_.stated());
    }

    void animate() {
        surface().animation = tracks_.animate(parts_->arrays, seed_, mistakes_);
        if (surface().field) surface().animation.keep_fields(surface().field->packing);
    }

    // The values of the first frame. Settings are chosen once, there: every frame is marched alike.
    void evaluate() {
        while (may_evaluate_) {
            try {
                first_ = at_frame(scene_, 1);
                return;
            } catch (const ValueError& error) {
                if (!tracks_.replace(error, mistakes_)) return;
                animate();
            }
        }
    }

    void find_bounds() {
        const std::optional<probe::FoundBounds> found = probe::find_bounds(scene_);
        if (!found) {
            fail(*root_["surface"].as_table(), "surface.bounds",
                 "is missing, and looking for the surface of so many elements or frames would take "
                 "long; give { sphere = radius } or { box = [[x0, y0, z0], [x1, y1, z1]] }");
        }
        put_bounds(root_, *found);
        const Bounds& bounds = surface().bounds;
        tracks_.set(bounds.radius, found->radius);
        for (int k = 0; k < 3; ++k) tracks_.set(bounds.centre[std::size_t(k)], found->centre[k]);
        surface().found_bounds = found->is_about_surface;
        animate();
        first_ = at_frame(scene_, 1);
    }

    void measure() {
        const SurfaceAt& first = first_.surfaces.front();
        Surface& surface = scene_.surfaces.front();
        Isolation& isolation = surface.isolation;
        surface.measured = probe::measured(scene_, first);
        if (!given_.step) isolation.step = first.bounds.radius / 100;
        if (!given_.near || !given_.far || !given_.horizon) {
            const double slope = probe::field_slope(*surface.field, first);
            const probe::Thresholds found = probe::field_thresholds(slope, isolation.step);
            if (!given_.near) isolation.near = found.near;
            if (!given_.far) isolation.far = std::max(found.far, isolation.near);
            if (!given_.horizon) isolation.horizon = found.horizon;
        }
        if (surface.jumps_are_walls) {
            surface.field = std::make_shared<formula::Field>(
                formula::with_walls(*surface.field, wall_part * first.bounds.radius));
        }
        rescale(*parts_, first);
        // Curvatures are quotients of the same field's slopes.
        make_paints(material_, *parts_, mistakes_);
        mistakes_.throw_if_any();
        if (material_.colormap)
            find_shown_range(*material_.colormap, scene_, *surface.material.paint);
    }

    toml::table& root_;
    const base::Confines& within_;
    std::set<std::string>* for_others_;
    MistakeList mistakes_;
    TrackTable tracks_;
    Scene scene_;
    std::uint64_t seed_ = 0;
    std::unique_ptr<SurfaceParts> parts_;
    MaterialParts material_;
    GivenThresholds given_; // of the scene or the catalogue
    bool may_evaluate_ = false;
    SceneAt first_;
};

Scene read_one(toml::table& root, const fs::path& file, const base::Confines& within,
               std::set<std::string>* for_others) {
    return SceneReader(root, within, for_others).read(file);
}

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

using Parse = std::function<toml::table()>;

// Reads each listed surface from a document of its own: copied nodes would not know their lines.
Scene read_listed(const toml::table& root, const Parse& parse, const fs::path& file,
                  const std::vector<Override>& overrides, const base::Confines& within) {
    const std::vector<std::string> names = listed_names(root);
    std::set<std::string> unused = shared_parameters(root);
    Scene all;
    std::vector<Surface> surfaces;
    std::optional<Mistakes> mistakes;
    for (std::size_t k = 0; k < names.size(); ++k) {
        toml::table document = parse();
        std::set<std::string> for_others = shared_parameters(document);
        for (const std::string& own : own_parameters(document, k)) for_others.erase(own);
        const std::set<std::string> shared = for_others;
        keep_surface(document, k);
        Scene scene;
        try {
            scene = read_one(document, file, within, &for_others);
        } catch (const Mistakes& of_surface) {
            std::vector<ToldMistake> told = of_surface.told();
            for (ToldMistake& one : told)
                one.message = as_set(std::move(one.message), overrides, names[k], k);
            const Mistakes named(std::move(told));
            mistakes = mistakes ? joined(*mistakes, named) : named;
            continue;
        }
        for (const std::string& name : shared) {
            if (!for_others.contains(name)) unused.erase(name);
        }
        surfaces.push_back(std::move(scene.surfaces.front()));
        surfaces.back().label = names[k];
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

// `parse` gives the document once more.
Scene read_scene(toml::table& root, const Parse& parse, const fs::path& file,
                 const std::vector<Override>& overrides, const base::Confines& within) {
    const auto set = [&](toml::table& document) {
        for (const Override& setting : overrides) override_key(document, setting);
    };
    set(root);
    if (!lists_surfaces(root)) {
        Scene scene = read_one(root, file, within, nullptr);
        refuse_unused_arrays(root, scene);
        return scene;
    }
    const auto parse_again = [&] {
        toml::table document = parse();
        set(document);
        return document;
    };
    Scene scene = read_listed(root, parse_again, file, overrides, within);
    refuse_unused_arrays(root, scene);
    return scene;
}

// A formula alone has no parameters but those that are set.
std::string how_to_name(std::string_view mistake) {
    constexpr std::string_view start = "unknown name '";
    if (!mistake.starts_with(start)) return "";
    const std::string_view name =
        mistake.substr(start.size(), mistake.find('\'', start.size()) - start.size());
    if (const std::string_view meaning = meaning_in_expressions(name); !meaning.empty())
        return fmt::format("\n'{}' means the {} in expressions; choose another name", name,
                           meaning);
    return fmt::format("\n--set {}=1 makes it a parameter", name);
}

// Loads what load() takes. `root` is left as the document with all that was set and found.
Scene load_into(toml::table& root, const std::string& name, const std::vector<Override>& overrides,
                Reach reach) {
    SceneDocument document = find_document(name, overrides, reach);
    root = std::move(document.root);
    try {
        Scene scene = read_scene(
            root, [&] { return parse_scene(document.text, document.file); }, document.file,
            overrides, document.within);
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
    return read_scene(
        root, [&] { return parse_scene(text, file); }, file, overrides,
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
