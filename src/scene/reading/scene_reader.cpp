#include "scene/reading/scene_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include <fmt/format.h>

#include "base/printable.h"
#include "formula/graph/degree.h"
#include "probe/found_bounds.h"
#include "probe/measured.h"
#include "probe/thresholds.h"
#include "scene/limits.h"
#include "scene/reading/camera.h"
#include "scene/reading/environment.h"
#include "scene/reading/far_numbers.h"
#include "scene/reading/lights.h"
#include "scene/reading/look.h"
#include "scene/reading/output.h"
#include "scene/reading/sections.h"
#include "scene/reading/space.h"
#include "scene/reading/surface_list.h"
#include "scene/reading/time.h"
#include "scene/scene_at.h"

namespace isomotion::scene {
namespace fs = std::filesystem;
namespace {

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
        fail(*parts.formula_node, parts.formula_key,
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
    fail(*parts.formula_node, parts.formula_key,
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
    fail(*parts.formula_node, parts.formula_key, fmt::format(fmt::runtime(what), loss.example));
}

// The tracks that hold the places of the bounds.
std::vector<TrackId> places_of(const Bounds& bounds) {
    if (bounds.shape == Bounds::Shape::sphere) return {bounds.centre.begin(), bounds.centre.end()};
    std::vector<TrackId> places(bounds.min.begin(), bounds.min.end());
    places.insert(places.end(), bounds.max.begin(), bounds.max.end());
    return places;
}

} // namespace

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

SceneReader::SceneReader(toml::table& root, const base::Confines& within,
                         std::optional<ListedSurface> listed)
    : root_(root)
    , within_(within)
    , listed_(std::move(listed)) {}

Scene SceneReader::read(const fs::path& file) {
    scene_.file = file;
    scene_.surfaces.emplace_back();
    read_look();
    read_document();
    compile();
    evaluate();
    mistakes_.throw_if_any();
    if (parts_->lacks_bounds) mistakes_.attempt([&] { find_bounds(); });
    mistakes_.throw_if_any();
    mistakes_.attempt([&] { measure(); });
    mistakes_.throw_if_any();
    if (listed_) {
        surface().label = listed_->name;
    } else {
        put_under(root_, std::move(look_));
    }
    return std::move(scene_);
}

// What the look says and the document leaves to it is read below the document.
void SceneReader::read_look() {
    std::vector<Section::Layer> layers{{&root_, ""}};
    if (listed_) layers.insert(layers.begin(), {&listed_->table, "surfaces." + listed_->name});
    Section above(std::move(layers), "", mistakes_);
    mistakes_.attempt([&] { surface().look = look_below(above, root_.get("look"), look_); });
}

Section SceneReader::document() {
    Section document(std::vector<Section::Layer>{{&root_, ""}, {&look_, ""}}, "", mistakes_);
    for (const char* read_elsewhere : {"look", "surfaces"}) document.find(read_elsewhere);
    return document;
}

// [surface], or the table of the list.
Section SceneReader::surface_section(Section& document) {
    if (!listed_) {
        if (auto given = document.section("surface")) return *given;
        static const toml::table stand_in{{"formula", "x"}, {"bounds", toml::table{{"sphere", 1}}}};
        misses_surface_ = true;
        if (!document.has("surface"))
            document.tell_missing("surface", "formula = \"...\" and bounds, or use = \"name\" of "
                                             "the catalogue");
        return Section(stand_in, "surface", mistakes_);
    }
    document.find("surface");
    Section listed(std::vector<Section::Layer>{{&listed_->table, "surfaces." + listed_->name}},
                   "surface", mistakes_);
    listed.find("name");
    for (const char* own : own_sections) listed.find(own);
    return listed;
}

// Where the parameters, arrays, material and isolation of the surface are.
Section SceneReader::sections_of_surface(Section& document) {
    std::vector<Section::Layer> layers = document.layers();
    if (listed_) layers.insert(layers.begin(), {&listed_->table, "surfaces." + listed_->name});
    for (const char* own : own_sections) document.find(own);
    return Section(std::move(layers), "", mistakes_);
}

// What the file says, but for expressions.
void SceneReader::read_document() {
    Section document = this->document();
    Section surface_section = this->surface_section(document);
    Section own = sections_of_surface(document);
    scene_.title = read_title(document, scene_.file);
    const TimeParts time = read_time(document);
    scene_.timeline = time.timeline;
    seed_ = time.seed;
    parts_ = read_surface(surface_section, own, scene_.timeline, tracks_, within_, surface());
    tracks_.place("surface.formula", parts_->formula_key, parts_->formula_node);
    read_space(surface_section, *parts_, tracks_);
    surface_section.refuse_rest();
    scene_.camera = read_camera(document, tracks_);
    read_lights(document, scene_, tracks_);
    material_ = read_material(own, *parts_, tracks_);
    read_output(document, scene_);
    read_surroundings(document, scene_, tracks_);
    scene_.environment = read_environment(document, tracks_, within_);
    if (const auto& table = parts_->catalogue) {
        Section catalogue(*table, "", mistakes_);
        read_isolation(catalogue, surface().isolation, given_);
    }
    read_isolation(own, surface().isolation, given_);
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
void SceneReader::compile() {
    animate();
    const std::size_t arrays = parts_->arrays.size();
    const bool is_formula_right = make_field(*parts_, tracks_, mistakes_);
    if (parts_->arrays.size() > arrays) animate();
    if (surface().field) {
        make_paints(material_, *parts_, mistakes_);
        if (is_formula_right) mistakes_.attempt([&] { expect_surface(scene_, *parts_); });
        store_elements_of(*parts_, paints_of(surface().material));
        if (is_formula_right && !misses_surface_ && !mistakes_.may_name_others()) {
            refuse_unused(*parts_, paints_of(surface().material), tracks_,
                          listed_ ? &listed_->for_others : nullptr, mistakes_);
        }
        surface().animation.keep_fields(surface().field->packing);
        may_evaluate_ = mistakes_.attempt([&] { check_work(*parts_, tracks_); });
    }
    surface().value_places = std::make_shared<const ValuePlaces>(tracks_.stated());
}

void SceneReader::animate() {
    surface().animation = tracks_.animate(parts_->arrays, seed_, mistakes_);
    if (surface().field) surface().animation.keep_fields(surface().field->packing);
}

// The field, again, and all that is made of it.
void SceneReader::make_field_again() {
    make_field(*parts_, tracks_, mistakes_);
    animate();
    make_paints(material_, *parts_, mistakes_);
    store_elements_of(*parts_, paints_of(surface().material));
    surface().animation.keep_fields(surface().field->packing);
}

// Whether the bounds are far from the origin, and near a point, at frames spread over the scene.
bool SceneReader::stays_far_beside(const glm::dvec3& point) const {
    constexpr int most_looked_at = 17;
    const int frames = scene_.timeline.frames, looked_at = std::min(frames, most_looked_at);
    for (int k = 0; k < looked_at; ++k) {
        const int frame =
            looked_at == 1 ? 1 : 1 + int(std::int64_t(frames - 1) * k / (looked_at - 1));
        BoundsAt bounds;
        try {
            bounds = surface_at(scene_, scene_.timeline.time(frame)).bounds;
        } catch (const SceneError&) { // which is told when that frame is drawn
            return false;
        }
        if (!probe::is_far(bounds)) return false;
        bounds.centre -= point;
        if (probe::is_far(bounds)) return false;
    }
    return true;
}

// Counts coordinates, and the numbers that are subtracted from them, from near the middle of bounds
// that lie far from the origin, unless floats come nearer to F where it is. The placement makes up
// for it.
void SceneReader::recentre() {
    const SurfaceAt& first = first_.surfaces.front();
    if (!probe::is_far(first.bounds)) return;
    const Placement& placement = surface().placement;
    const auto is_number = [this](TrackId track) { return tracks_.is_number(track); };
    if (!is_number(placement.scale) || !std::ranges::all_of(placement.rotate, is_number)) return;
    std::vector<TrackId> moving = places_of(surface().bounds);
    moving.insert(moving.end(), placement.translate.begin(), placement.translate.end());
    if (std::ranges::any_of(moving, [this](TrackId id) { return tracks_.has_statements(id); }))
        return;

    // A number of few digits: differences from the formula's own are exact.
    const double unit = std::exp2(std::ilogb(first.bounds.radius) - 4);
    const glm::dvec3 middle = unit * glm::round(first.bounds.centre / unit);
    if (!stays_far_beside(middle)) return;
    SurfaceAt there = first;
    for (glm::dvec3* place : {&there.bounds.min, &there.bounds.max, &there.bounds.centre})
        *place -= middle;
    FarNumbers far = far_numbers(*parts_, first, unit);
    for (const auto& [array, column] : far.columns) {
        there.bindings.arrays.resize(std::max(there.bindings.arrays.size(), array + 1));
        there.bindings.arrays[array].count = int(column.size());
        there.bindings.arrays[array].fields.push_back(column);
    }
    const formula::Origin origin{{middle.x, middle.y, middle.z}, far.numbers};
    // Rays and bounds gain, too, so it need not be better.
    constexpr double no_worse = 2;
    try {
        const formula::Field field =
            formula::make_field(*parts_->formula, far.vocabulary, nullptr, origin);
        if (probe::float32_displacement(field, there) >
            no_worse * probe::float32_displacement(*surface().field, first))
            return;
    } catch (const std::length_error&) { // with all that repeats written out
        return;
    }

    parts_->origin = origin;
    parts_->arrays = std::move(far.arrays);
    parts_->vocabulary = std::move(far.vocabulary);
    parts_->own_arrays = parts_->arrays.size();
    const Bounds& bounds = surface().bounds;
    const glm::dvec3 moved =
        first.placement.scale * (first.placement.rotate * middle); // in the world
    const std::vector<TrackId> places = places_of(bounds);
    for (std::size_t k = 0; k < places.size(); ++k) tracks_.add_to(places[k], -origin.point[k % 3]);
    for (std::size_t k = 0; k < 3; ++k) tracks_.add_to(placement.translate[k], moved[int(k)]);
    make_field_again();
    evaluate();
}

// The values of the first frame. Settings are chosen once, there: every frame is marched alike.
void SceneReader::evaluate() {
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

void SceneReader::find_bounds() {
    toml::table* const own = listed_ ? &listed_->table : root_["surface"].as_table();
    if (!own) return; // mistakes have ended the reading before
    toml::table& table = *own;
    const std::optional<probe::FoundBounds> found = probe::find_bounds(scene_);
    if (!found) {
        fail(table, parts_->bounds_key,
             "is missing, and looking for the surface would take long, as the formula has so many "
             "operations, elements or frames; give { sphere = radius } or { box = [[x0, y0, z0], "
             "[x1, y1, z1]] }");
    }
    toml::table ball{{"sphere", found->radius}};
    const glm::dvec3& centre = found->centre;
    if (centre != glm::dvec3(0)) ball.insert("centre", toml::array{centre.x, centre.y, centre.z});
    table.insert_or_assign("bounds", std::move(ball));
    const Bounds& bounds = surface().bounds;
    tracks_.set(bounds.radius, found->radius);
    for (int k = 0; k < 3; ++k) tracks_.set(bounds.centre[std::size_t(k)], centre[k]);
    surface().found_bounds = found->is_about_surface;
    animate();
    evaluate();
}

void SceneReader::measure() {
    recentre();
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
    const auto& map = material_.colormap;
    auto& paint = surface.material.paint;
    if (map && paint) find_shown_range(*map, scene_, *paint);
}

} // namespace isomotion::scene
