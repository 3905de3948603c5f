#include "scene/scene_at.h"

#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>
#include <glm/gtc/constants.hpp>

#include "scene/error.h"
#include "scene/key_tables.h"
#include "scene/key_values.h"
#include "scene/limits.h"
#include "scene/value_error.h"

namespace isomotion::scene {
namespace {

constexpr double largest_float = std::numeric_limits<float>::max();

// Whether a vector's square is a full double: the square of a shorter vector loses digits, or is 0.
bool has_direction(const glm::dvec3& v) {
    return glm::dot(v, v) >= std::numeric_limits<double>::min();
}

bool are_floats(const glm::dvec3& v) {
    return std::abs(v.x) <= largest_float && std::abs(v.y) <= largest_float &&
           std::abs(v.z) <= largest_float;
}

struct Ball {
    glm::dvec3 centre{0};
    double radius = 0;
};

Ball ball_about(const SurfaceAt& surface) {
    const PlacementAt& place = surface.placement;
    return {place.to_world(surface.bounds.centre), surface.bounds.radius * place.scale};
}

// A ball about the bounds of all surfaces.
Ball ball_about_all(const SceneAt& now) {
    if (now.surfaces.size() == 1) return ball_about(now.surfaces.front());
    glm::dvec3 low(formula::infinity), high(-formula::infinity);
    for (const SurfaceAt& surface : now.surfaces) {
        const Ball its = ball_about(surface);
        low = glm::min(low, its.centre - its.radius);
        high = glm::max(high, its.centre + its.radius);
    }
    const glm::dvec3 centre = 0.5 * (low + high);
    double radius = 0;
    for (const SurfaceAt& surface : now.surfaces) {
        const Ball its = ball_about(surface);
        radius = std::max(radius, its.radius + glm::length(its.centre - centre));
    }
    return {centre, radius};
}

class Reader {
public:
    // Values of the surface's animation; those of the scene's own settings are the first one's.
    Reader(const OneSurface& one, const animation::Values& values)
        : scene_(one.scene)
        , surface_(one.surface)
        , values_(values) {}

    double number(TrackId track) const { return values_.tracks[std::size_t(track)]; }
    glm::dvec3 vector(const Vec3Track& track) const {
        return {number(track[0]), number(track[1]), number(track[2])};
    }
    // Linear light; what is below 0 takes light away.
    glm::dvec3 color(const Vec3Track& track) const {
        for (const TrackId component : track) {
            const double value = number(component);
            if (std::abs(value) <= limits::brightness) continue;
            fail(component, fmt::format("the colour's part {} is beyond {:g} to {:g}", value,
                                        -limits::brightness, limits::brightness));
        }
        return vector(track);
    }
    // The value of a key, which must be one of those that its row allows.
    template<class Row> double value(const Row& row, TrackId track) const {
        const double value = number(track);
        if (row.kind.allowed.contains(value)) return value;
        fail(track, fmt::format("must be {}, not {}", row.kind.allowed.words(), value));
    }
    template<class Row> glm::dvec3 value(const Row& row, const Vec3Track& track) const {
        if (row.kind.unit == keys::Unit::color) return color(track);
        return {value(row, track[0]), value(row, track[1]), value(row, track[2])};
    }
    template<class Table, class Of, class At>
    void put(const Table& table, const Of& of, At& to) const {
        keys::put_values(table, of, to,
                         [&](const auto& row, const auto& track) { return value(row, track); });
    }
    template<class At, class Table, class Of> At values(const Table& table, const Of& of) const {
        At to;
        put(table, of, to);
        return to;
    }
    [[noreturn]] void fail(const std::string& name, const std::string& message) const {
        throw ValueError(where(name), name, values_.time, message);
    }
    [[noreturn]] void fail(TrackId track, const std::string& message) const {
        fail(name(track), message);
    }
    // "ring.toml:9: camera.fov", or without the line if the file states no such value.
    std::string where(const std::string& name) const {
        const StatedAt at = stated_at(surface_.value_places.get(), scene_.file.string(), name);
        return fmt::format("{}: {}", at.position, at.key);
    }
    const std::string& name(TrackId track) const {
        return surface_.animation.tracks()[std::size_t(track)].name;
    }

    // A NaN would end in an empty picture, or in the blame of something else.
    void check_range() const {
        const auto& tracks = surface_.animation.tracks();
        for (std::size_t k = 0; k < values_.tracks.size(); ++k) {
            check(values_.tracks[k], [&] { return tracks[k].name; });
        }
        const auto& arrays = surface_.animation.arrays();
        for (std::size_t a = 0; a < values_.arrays.size(); ++a) {
            const auto& fields = values_.arrays[a].fields;
            for (std::size_t f = 0; f < fields.size(); ++f) {
                for (std::size_t i = 0; i < fields[f].size(); ++i) {
                    check(fields[f][i], [&] {
                        return fmt::format("{}.{}[{}]", arrays[a].name, arrays[a].fields[f].name,
                                           i);
                    });
                }
            }
        }
    }

    BoundsAt bounds() const {
        const Bounds& from = surface_.bounds;
        BoundsAt to;
        to.shape = from.shape;
        if (from.shape == Bounds::Shape::sphere) {
            to.centre = vector(from.centre);
            to.radius = number(from.radius);
            check_size(from.radius, to.radius);
            to.min = to.centre - to.radius;
            to.max = to.centre + to.radius;
            return to;
        }
        to.min = vector(from.min);
        to.max = vector(from.max);
        for (int k = 0; k < 3; ++k) {
            if (to.min[k] < to.max[k]) continue;
            const double origin = surface_.field ? surface_.field->origin.point[std::size_t(k)] : 0;
            fail(from.min[std::size_t(k)],
                 fmt::format("the first corner of the box must be below the second: {} and {}",
                             origin + to.min[k], origin + to.max[k]));
        }
        to.centre = 0.5 * (to.min + to.max);
        to.radius = 0.5 * glm::length(to.max - to.min);
        check_size(from.min[0], to.radius);
        return to;
    }

    PlacementAt placement() const {
        const Placement& from = surface_.placement;
        auto to = values<PlacementAt>(keys::transform_keys, from);
        const glm::dvec3 angle = glm::radians(vector(from.rotate));
        const glm::dvec3 c = glm::cos(angle), s = glm::sin(angle);
        // GLM's matrices are written column by column.
        const glm::dmat3 x(1, 0, 0, 0, c.x, s.x, 0, -s.x, c.x);
        const glm::dmat3 y(c.y, 0, -s.y, 0, 1, 0, s.y, 0, c.y);
        const glm::dmat3 z(c.z, s.z, 0, -s.z, c.z, 0, 0, 0, 1);
        to.rotate = z * y * x;
        return to;
    }

    // `all`: a sphere about everything, in the world.
    CameraAt camera(const Ball& all) const {
        const Camera& from = scene_.camera;
        auto to = values<CameraAt>(keys::camera_keys, from);
        to.projection = from.projection;
        if (!has_direction(to.up)) fail(from.up[0], "`up` has no direction");
        const double aspect = double(scene_.output.width) / scene_.output.height;
        const double slope = std::tan(glm::radians(to.fov) / 2);

        if (!from.target) to.target = all.centre;
        // A sphere about the target that holds the bounds.
        const double reach = all.radius + glm::length(all.centre - to.target);
        if (!from.position) {
            const double narrow = std::atan(slope * std::min(aspect, 1.0));
            const double distance =
                from.distance ? number(*from.distance) : reach / std::sin(narrow);
            to.position = to.target +
                          distance * on_orbit(to.up, number(from.azimuth), number(from.elevation));
        }
        check_place(to);
        if (from.height) {
            expect_long_enough(*from.height);
        } else if (from.position || from.distance) {
            // The height that a perspective camera there shows at the target.
            to.height = 2 * glm::length(to.position - to.target) * slope;
        } else {
            to.height = 2 * reach / std::min(aspect, 1.0);
        }
        if (from.focus) {
            expect_long_enough(*from.focus);
        } else {
            to.focus = glm::length(to.target - to.position);
        }
        return to;
    }

    glm::dvec2 range(const Paint& paint) const {
        if (paint.shown) return {paint.shown->least, paint.shown->most};
        const glm::dvec2 ends(number(paint.low), number(paint.high));
        // The ends are compared as floats: a shader divides by their difference.
        if (float(ends.x) == float(ends.y)) {
            const std::string& low = name(paint.low);
            fail(low.substr(0, low.rfind('.')),
                 fmt::format("the two ends must differ, and both are {}", ends.x));
        }
        return ends;
    }

    std::vector<LightAt> lights(const CameraAt& camera) const {
        std::vector<LightAt> lights;
        for (const Light& from : scene_.lights) {
            auto light = values<LightAt>(keys::light_keys, from);
            light.direction = from.headlight     ? of_viewer(camera, {0.6, 0.8, 1})
                              : from.with_camera ? of_viewer(camera, vector(from.direction))
                                                 : vector(from.direction);
            light.is_point = from.is_point;
            if (from.radius) light.radius = radius(from, *from.radius);
            lights.push_back(light);
            if (light.is_point) continue;
            if (!has_direction(light.direction))
                fail(from.direction[0], "the direction to the light has length 0");
            lights.back().direction = glm::normalize(light.direction);
        }
        return lights;
    }

    // The numbers of the material's model, in the order of the `gloss` of its shader.
    glm::dvec4 gloss() const {
        const Material& from = surface_.material;
        glm::dvec4 numbers(0);
        keys::for_each_model([&](Material::Model model, const auto& table) {
            if (model != from.model) return;
            int k = 0;
            keys::for_each_row(table, [&](const auto& row) {
                if (const auto& track = from.*row.track) numbers[k] = value(row, *track);
                ++k;
            });
        });
        return numbers;
    }

    SectionAt section(const Cut& from) const {
        if (from.is_ball) {
            const auto ball = values<SectionAt>(keys::cut_ball_keys, from);
            return {true, ball.where, ball.reach};
        }
        const glm::dvec3 normal = vector(from.normal);
        if (!has_direction(normal))
            fail(from.normal[0], "the normal has length 0, and no direction");
        const double length = glm::length(normal);
        return {false, normal / length,
                glm::dot(normal / length, vector(from.point)) + number(from.offset)};
    }

    OcclusionAt occlusion(const Occlusion& from, double size) const {
        auto to = values<OcclusionAt>(keys::occlusion_keys, from);
        if (!from.reach) to.reach = 0.2 * size;
        return to;
    }

    EnvironmentAt environment(const Environment& from) const {
        auto to = values<EnvironmentAt>(keys::environment_keys, from);
        // Whole turns are taken off before the conversion, which rounds them.
        const double angle = glm::radians(std::remainder(number(from.rotation), 360.0));
        to.ahead = {std::cos(angle), std::sin(angle), 0};
        to.left = {-std::sin(angle), std::cos(angle), 0};
        return to;
    }

private:
    // Checks a radius or a box's half diagonal, in formula coordinates. The GPU's numbers don't
    // hold the squares of smaller ones: every ray was seen to miss, or to come to NaN.
    void check_size(TrackId track, double size) const {
        if (size >= limits::least_radius) return;
        fail(track,
             size > 0
                 ? fmt::format("bounds of radius {:.2g} are too small for the GPU's numbers, which "
                               "need {:g}: write the formula larger, and give `transform.scale`",
                               size, limits::least_radius)
                 : fmt::format("the radius must be above 0, not {}", size));
    }

    // The line of sight must have a direction, and the eye must be where the GPU can have it.
    void check_place(const CameraAt& camera) const {
        const Camera& from = scene_.camera;
        constexpr double narrow = 1e-3; // degrees: narrower ones need an eye so far away
        const TrackId of_framing = camera.fov < narrow ? from.fov
                                   : surface_.bounds.shape == Bounds::Shape::sphere
                                       ? surface_.bounds.radius
                                       : surface_.bounds.min[0];
        const TrackId track = from.position   ? (*from.position)[0]
                              : from.distance ? *from.distance
                              : from.target   ? (*from.target)[0]
                                              : of_framing;
        if (!are_floats(camera.target) || !are_floats(camera.position)) {
            fail(track, fmt::format("the camera comes to stand or to look beyond the range of "
                                    "float ({:.2g}); make the scene smaller, or `fov` wider",
                                    largest_float));
        }
        if (has_direction(camera.position - camera.target)) return;
        fail(track, from.position ? "the camera stands at its target; move one of them"
                                  : "the camera comes to stand at its target: it is nearer than "
                                    "the digits of its coordinates tell; move the scene to the "
                                    "origin, or the camera away");
    }

    double radius(const Light& light, TrackId radius) const {
        if (light.is_point) return number(radius);
        constexpr keys::Allowed disc = keys::from_to(0, 45); // degrees
        if (disc.contains(number(radius))) return std::tan(glm::radians(number(radius)));
        fail(radius, fmt::format("must be {}, not {}", disc.words(), number(radius)));
    }
    // Rays are scaled by such a length.
    void expect_long_enough(TrackId track) const {
        const double value = number(track);
        if (value >= limits::least_radius * number(surface_.placement.scale)) return;
        fail(track, fmt::format("must be at least {:g} in the formula's coordinates, not {}",
                                limits::least_radius, value));
    }

    template<class Name> void check(double value, Name&& name) const {
        // Everything ends as a float on the GPU.
        if (std::abs(value) <= largest_float) return;
        fail(name(), std::isnan(value)
                         ? "the value is not a number"
                         : fmt::format("the value {} is beyond the range of float ({:.2g})", value,
                                       largest_float));
    }

    // The direction from the target to a camera on an orbit.
    static glm::dvec3 on_orbit(const glm::dvec3& up, double azimuth, double elevation) {
        const glm::dvec3 pole = glm::normalize(up);
        glm::dvec3 zero = glm::dvec3(1, 0, 0) - pole.x * pole;
        if (glm::length(zero) < 1e-6) zero = glm::dvec3(0, 1, 0) - pole.y * pole;
        zero = glm::normalize(zero);
        const double a = glm::radians(azimuth), e = glm::radians(elevation);
        return std::cos(e) * (std::cos(a) * zero + std::sin(a) * glm::cross(pole, zero)) +
               std::sin(e) * pole;
    }

    // The vector, in world coordinates, that is `v` to the viewer's right, up and back.
    static glm::dvec3 of_viewer(const CameraAt& camera, const glm::dvec3& v) {
        const glm::dvec3 back = glm::normalize(camera.position - camera.target);
        glm::dvec3 right = glm::cross(camera.up, back);
        if (glm::length(right) < 1e-9 * glm::length(camera.up)) {
            right = glm::cross(std::abs(back.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0),
                               back);
        }
        right = glm::normalize(right);
        return v.z * back + v.x * right + v.y * glm::cross(back, right);
    }

    const Scene& scene_;
    const Surface& surface_;
    const animation::Values& values_;
};

} // namespace

SceneAt in_formula_coordinates(SceneAt scene) {
    const PlacementAt first = scene.surfaces.front().placement;
    const glm::dmat3 to_local = glm::transpose(first.rotate);
    keys::move_values(keys::camera_keys, scene.camera, first);
    for (LightAt& light : scene.lights) {
        keys::move_values(keys::light_keys, light, first);
        light.direction =
            light.is_point ? first.to_local(light.direction) : to_local * light.direction;
        if (light.is_point) light.radius /= first.scale;
    }
    for (SectionAt& section : scene.sections) section = in_formula_coordinates(section, first);
    keys::move_values(keys::fog_keys, scene.fog, first);
    keys::move_values(keys::occlusion_keys, scene.occlusion, first);
    if (scene.environment) {
        for (auto axis : {&EnvironmentAt::ahead, &EnvironmentAt::left, &EnvironmentAt::top}) {
            (*scene.environment).*axis = to_local * (*scene.environment).*axis;
        }
    }
    for (SurfaceAt& surface : scene.surfaces) {
        surface.placement.translate = first.to_local(surface.placement.translate);
        surface.placement.rotate = to_local * surface.placement.rotate;
        surface.placement.scale /= first.scale;
        keys::move_values(keys::glass_keys, surface.glass, first);
    }
    scene.surfaces.front().placement = {}; // exactly
    return scene;
}

namespace {

// The surface, where it is and what it is of.
SurfaceAt surface_at(const Surface& surface, const Reader& read,
                     std::shared_ptr<const animation::Values> values) {
    SurfaceAt now;
    const auto parameters = std::ptrdiff_t(surface.parameters);
    formula::Bindings<double> bindings;
    bindings.parameters.assign(values->tracks.begin(), values->tracks.begin() + parameters);
    bindings.arrays = values->arrays;
    now.values = std::move(values);
    read.check_range();
    now.bindings = formula::convert<float>(bindings);
    now.bounds = read.bounds();
    now.cubic_steps = surface.measured.cubic_steps;
    now.placement = read.placement();
    const Material& material = surface.material;
    now.color = read.color(material.color);
    if (material.paint) now.paint_range = read.range(*material.paint);
    read.put(keys::color_keys, material, now);
    read.put(keys::cap_keys, material, now);
    if (material.contours)
        now.contours = read.values<ContoursAt>(keys::contour_keys, *material.contours);
    if (material.glass) now.glass = read.values<GlassAt>(keys::glass_keys, *material.glass);
    now.gloss = read.gloss();
    return now;
}

} // namespace

SurfaceAt surface_at(const OneSurface& one, double time) {
    auto values = std::make_shared<const animation::Values>(one.surface.animation.at(time));
    const Reader read(one, *values);
    return surface_at(one.surface, read, std::move(values));
}

SceneAt at(const Scene& scene, double time) {
    SceneAt now;
    now.time = time;
    for (std::size_t k = 0; k < scene.surfaces.size(); ++k)
        now.surfaces.push_back(surface_at(OneSurface(scene, k), time));
    const Reader read(OneSurface(scene, 0), *now.surfaces.front().values);
    const Ball all = ball_about_all(now);
    now.camera = read.camera(all);
    now.lights = read.lights(now.camera);
    for (const Cut& cut : scene.sections) now.sections.push_back(read.section(cut));
    if (scene.ground) now.ground = read.values<GroundAt>(keys::ground_keys, *scene.ground);
    if (scene.fog) now.fog = read.values<FogAt>(keys::fog_keys, *scene.fog);
    if (scene.ambient) now.ambient = read.values<AmbientAt>(keys::ambient_keys, *scene.ambient);
    if (scene.occlusion) now.occlusion = read.occlusion(*scene.occlusion, all.radius);
    if (scene.environment) now.environment = read.environment(*scene.environment);
    return now;
}

SceneAt at_frame(const Scene& scene, std::int64_t frame) {
    return at(scene, scene.timeline.time(frame));
}

SceneAt at_frame(const Scene& scene, std::int64_t frame, double part) {
    return at(scene, scene.timeline.time(frame, part));
}

} // namespace isomotion::scene
