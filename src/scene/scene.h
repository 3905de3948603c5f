// A loaded scene: surfaces, how everything moves, and how it is seen.
//
// Every number that can be animated is a track of a surface's animation; the structs here hold
// track indices. scene_at.h turns a scene and a time into plain numbers.
#pragma once

#include <array>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "animation/animation.h"
#include "animation/timeline.h"
#include "base/confines.h"
#include "formula/cubic_steps.h"
#include "formula/field.h"
#include "formula/paint.h"
#include "formula/smoothness.h"
#include "scene/color_map.h"
#include "scene/method.h"
#include "scene/value_places.h"

namespace isomotion::scene {

using TrackId = int;
using Vec3Track = std::array<TrackId, 3>;

struct Bounds {
    enum class Shape { box, sphere };
    Shape shape = Shape::sphere;
    Vec3Track min{}, max{}; // box: opposite corners
    Vec3Track centre{};     // sphere
    TrackId radius = 0;
};

// World = translate + rotate * scale * formula coordinates; rotations in degrees about the fixed
// axes x, then y, then z.
struct Placement {
    Vec3Track translate{}, rotate{};
    TrackId scale = 0;
};

// The values that a parameter is meant for. They guide sliders and are not enforced.
struct Range {
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();

    bool contains(double value) const { return least <= value && value <= most; }
};

// The method's settings; lengths in formula coordinates, thresholds in units of F.
struct Isolation {
    Method method = Method::hermite;
    double step = 0; // b of Eq. 2
    double near = 0; // tau 1: the step is halved where |F| is below this
    double far = 0;  // tau 2: the step is doubled where |F| is above this
    // Tau 3: the step is quartered near a silhouette, where |dF/dt| is below this.
    double horizon = 0;
    int bisections = 10;
    std::optional<bool> beam; // skip the empty part of blocks of rays: uses_beams()
    bool certify = false;     // prove by intervals, on the GPU, where rays end: render/proofs.h
    double safety = 32;  // a cubic excludes a root if |F| exceeds this many of its estimated errors
    int limit = 100'000; // evaluations after which a ray ends with the verdict step limit

    bool operator==(const Isolation&) const = default;
};

// Stands at `position`, or on an orbit around the target. Values that a scene leaves out are
// derived from the bounds, so that the bounds fill the picture.
struct Camera {
    enum class Projection { perspective, orthographic };
    Projection projection = Projection::perspective;
    std::optional<Vec3Track> position;
    TrackId azimuth = 0;             // degrees about `up`, from the x axis
    TrackId elevation = 0;           // degrees above the plane across `up`
    std::optional<TrackId> distance; // from the target
    std::optional<Vec3Track> target; // without one: the middle of the bounds
    Vec3Track up{};
    TrackId fov = 0;                 // vertical, degrees
    std::optional<TrackId> height;   // of an orthographic picture, world units
    TrackId zoom = 0;                // magnifies the picture about its middle
    double shutter = 0;              // opens at a frame's time, for this fraction of its duration
    std::optional<TrackId> aperture; // diameter of the lens, world units; unset: a pinhole
    // Distance of the sharp plane from the eye; unset: that of the target.
    std::optional<TrackId> focus;
};

// A distant light, or a point light.
struct Light {
    // To the light, or a point light's position, in world coordinates. A light that moves with the
    // camera has the viewer's coordinates: right, up and back.
    Vec3Track direction{};
    Vec3Track color{};
    bool is_point = false;
    // Distance at which a point light has its colour; unset: it has it everywhere.
    std::optional<TrackId> falloff;
    bool shadow = false;
    bool headlight = false; // the default without lights: over the viewer's shoulder
    bool with_camera = false;
    // The radius of the disc that faces the surface: in degrees as seen from there, or for a point
    // light in world units.
    std::optional<TrackId> radius;
};

// A plane perpendicular to the world's z axis.
struct Ground {
    TrackId height = 0;
    Vec3Track color{};
};

// Fades everything farther than `start` from the eye into the colour: by 1 - 1/e over 1/density.
struct Fog {
    TrackId density = 0, start = 0; // world units
    Vec3Track color{};
};

// Light from all directions, given at the world's zenith and nadir.
struct Ambient {
    Vec3Track top{}, bottom{};
};

// Reduces ambient light where the surface is near along the normal.
struct Occlusion {
    std::optional<TrackId> reach; // world units; unset: a fifth of the bounds' radius
    TrackId strength = 0;         // 0: none, 1: full
};

// Takes a half-space or a ball away from the solid F < 0; world coordinates. See cut.h.
struct Cut {
    bool is_ball = false;
    // Half-space: its normal points away from what is left; a point of its plane; offset of the
    // plane.
    Vec3Track normal{}, point{};
    TrackId offset = 0;
    // Ball.
    Vec3Track centre{};
    TrackId radius = 0;
};

// Colours the surface by a number: `low` is at the beginning of the map, `high` at its end.
struct Paint {
    std::shared_ptr<const formula::Paint> value;
    TrackId low = 0, high = 0;
    // Replaces both: the range that the surface shows, see shown_range.h.
    std::optional<Range> shown;
    bool met = true; // whether any ray met the surface when that was found
    ColorMap map = ColorMap::blue_yellow;
};

// Lines on the surface where a number of the place is a multiple of `every`, counted from `from`.
struct Contours {
    std::shared_ptr<const formula::Paint> value; // with its slopes: formula/contours.h
    TrackId every = 0, from = 0;
    TrackId width = 0; // pixels
    Vec3Track color{};
};

// Makes the solid F < 0 clear: light passes through, refracted where it enters and leaves.
struct Glass {
    TrackId transmission = 0; // the part of the light not reflected that enters: 0..1
    TrackId ior = 0;          // index of refraction relative to the surroundings, above 0
    Vec3Track absorption{};   // per world unit: light fades by exp(-absorption * length)
    int depth = 4;            // rays followed after the primary ray, 0 to limits::glass_depth
    // Among several surfaces: at a place that lies in several, only the matter with the highest
    // priority is there; of equal ones the first in the file.
    int priority = 0;
};

// `color` is seen from the side F > 0. Only a surface with `inside` has two colours.
struct Material {
    enum class Reflection { none, sky, self };
    enum class Model {
        lambert,     // matt
        blinn_phong, // a highlight of a given shininess
        ggx,         // microfacets: from plastic to metal
    };
    Model model = Model::lambert;
    Vec3Track color{};
    // A colour that depends on the place; its components may be those of `color`. Null: `color`.
    std::shared_ptr<const formula::Paint> color_by_place;
    Reflection reflection = Reflection::none; // of the surroundings, or also of the surface itself
    std::optional<Vec3Track> inside;          // seen from the side F < 0
    std::optional<Vec3Track> cap;             // on caps, where sections cut; unset: as inside
    std::optional<Paint> paint;               // replaces all of these colours
    std::optional<Contours> contours;         // drawn over the colours
    std::optional<Glass> glass;
    // Each is set only if the model uses it.
    std::optional<TrackId> shininess;           // exponent, 0 to max_shininess
    std::optional<TrackId> roughness, metallic; // 0..1
    std::optional<TrackId> specular;            // reflectance at normal incidence, 0..1
};

inline constexpr double max_shininess = 10'000;

// Distant light from every direction, as a latitude-longitude map. The world's z axis points to the
// top of the map, the x axis to its middle, the y axis to its left quarter.
struct Environment {
    std::filesystem::path map;
    base::Confines within;  // where the map must lie when it is opened
    std::string stated_at;  // "scene.toml:4: environment.map", for messages
    TrackId rotation = 0;   // of the surroundings about the z axis, degrees
    TrackId intensity = 0;  // multiplies the map
    bool background = true; // seen behind the surface
};

// Colours at both ends of the world's z axis.
struct SkyGradient {
    std::array<double, 3> top{}, bottom{};
};

struct Output {
    int width = 512, height = 512;
    std::array<double, 3> background{};
    std::optional<SkyGradient> gradient; // replaces `background`
    bool transparent = false;
    int poster = 1;  // the frame that represents the animation
    int samples = 1; // pictures averaged to a frame
};

// Settings from a file of the program that apply where a scene states none of its own.
struct NamedLook {
    std::string name;                   // empty: none
    std::vector<std::string> keys = {}; // keys that it set for a surface: "material.model"
};

// What is measured of a surface once it is read: see probe/measured.h.
struct Measured {
    formula::Smoothness smoothness;  // within the bounds, over all frames
    formula::CubicSteps cubic_steps; // of an eighth of the bounds' radius
    // Of the array with the most, if known: probe/elements_at_a_place.h.
    std::optional<double> elements_at_a_place;
};

// One surface of a scene: a formula, where it is, what it is made of and how its roots are found.
struct Surface {
    std::string name;  // of the catalogue, or empty
    std::string label; // its name among several surfaces of a scene, see surfaces.h
    // Shared, since evaluators and shaders refer to its programs as long as they live.
    std::shared_ptr<const formula::Field> field;
    // How the values of the formula's names move, and of all settings that are tracks.
    animation::Animation animation;
    int parameters = 0;           // the first tracks of the animation are the formula's parameters
    std::vector<Range> ranges;    // ranges of the parameters that a scene can name
    bool jumps_are_walls = false; // jumps of F across 0 count as surface, too
    Bounds bounds;
    // For bounds that no file gives: whether they enclose the surface.
    std::optional<bool> found_bounds;
    Placement placement;
    Isolation isolation;
    Material material;
    std::shared_ptr<const ValuePlaces> value_places; // where the file states its values
    NamedLook look;
    Measured measured;
};

struct Scene {
    std::filesystem::path file; // for a formula alone, a file that doesn't exist
    std::string formula;        // set if the scene was loaded from a formula alone
    std::string title;
    animation::Timeline timeline;
    std::vector<Surface> surfaces; // at least one, in the file's order
    // All that follows is of all surfaces. Its tracks are of the first surface's animation, whose
    // parameters its expressions may name.
    Camera camera;
    std::vector<Light> lights; // at least one
    std::vector<Cut> sections;
    std::optional<Ground> ground;
    std::optional<Fog> fog;
    std::optional<Ambient> ambient; // unset: a little white
    std::optional<Occlusion> occlusion;
    std::optional<Environment> environment;
    Output output;
};

// The index of the only one of so many surfaces; throws std::logic_error if there are others.
std::size_t only(std::size_t surfaces);

// One surface in its scene: what shaders, proofs and searches of a single surface are made from. It
// refers to the scene, which must outlive it.
struct OneSurface {
    OneSurface(const Scene& its_scene, std::size_t its_index)
        : scene(its_scene)
        , surface(its_scene.surfaces.at(its_index))
        , index(its_index) {}
    // The surface of a scene that has a single one; throws std::logic_error if there are several.
    OneSurface(const Scene& its_scene) // NOLINT(google-explicit-constructor)
        : OneSurface(its_scene, only(its_scene.surfaces.size())) {}

    bool is_alone() const { return scene.surfaces.size() == 1; }

    const Scene& scene;
    const Surface& surface;
    std::size_t index;
};

// The argument that loads the scene again from any folder: its formula, or its file's full path.
std::string reload_argument(const Scene& scene);

} // namespace isomotion::scene
