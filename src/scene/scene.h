// A scene, loaded: a surface, how everything moves, and how it is seen.
//
// Every number that may move is a track of the one animation; the structs here hold track indices.
// scene_at.h turns a scene and a time into plain numbers.
#pragma once

#include <array>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "animation/timeline.h"
#include "base/confines.h"
#include "formula/field.h"
#include "formula/paint.h"
#include "formula/smoothness.h"
#include "scene/color_map.h"
#include "scene/method.h"

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

// The values that a parameter is meant for, as a guide for sliders; nothing enforces it.
struct Range {
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();

    bool contains(double value) const { return least <= value && value <= most; }
};

struct Surface {
    std::string name;  // of the catalogue, or empty
    std::string label; // among several of a scene, see surfaces.h
    // Shared: evaluators and shaders refer to its programs for as long as they live.
    std::shared_ptr<const formula::Field> field;
    int parameters = 0;        // the first tracks of the animation are the formula's parameters
    std::vector<Range> ranges; // of those among them that a scene can name
    formula::Smoothness smoothness; // within the bounds, over all frames
    bool jumps_are_walls = false;   // where F jumps across 0, and not only where F is 0
    Bounds bounds;
    std::optional<bool> found_bounds; // of bounds that no file gives: whether about the surface
    Placement placement;
};

// The method's settings; lengths in formula coordinates, thresholds in units of F.
struct Isolation {
    Method method = Method::hermite;
    double step = 0;    // b of Eq. 2
    double near = 0;    // tau 1: the step is halved where |F| is below this
    double far = 0;     // tau 2: it is doubled where |F| is above this
    double horizon = 0; // tau 3: it is quartered near a silhouette, where |dF/dt| is below this
    int bisections = 10;
    std::optional<bool> beam; // skip the empty part of the way for blocks of rays: uses_beams()
    bool certify = false;     // prove by intervals, on the GPU, where rays ended: render/proofs.h
    double safety = 32;       // a cubic rules a root out where it is this many of its errors off 0
    int limit = 100'000;      // evaluations after which a ray gives up with the verdict step limit

    bool operator==(const Isolation&) const = default;
};

// Stands at `position`, or on an orbit about the target. Values that a scene leaves out follow from
// the bounds, so that they fill the picture.
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
    double shutter = 0;              // open from a frame's time on, for this part of its duration
    std::optional<TrackId> aperture; // diameter of the lens, world units; without one a pinhole
    std::optional<TrackId> focus;    // of the sharp plane from the eye; without one the target's
};

// A light far away, or at a place.
struct Light {
    // To the light, or the position of a point light: in world coordinates, or of a light that goes
    // with the camera to the viewer's right, up and back.
    Vec3Track direction{};
    Vec3Track color{};
    bool is_point = false;
    std::optional<TrackId> falloff; // distance at which a point light has its colour; else all have
    bool shadow = false;
    bool headlight = false; // no light given: over the viewer's shoulder
    bool with_camera = false;
    // A disc that faces the surface has it: degrees as seen from there; a point light world units.
    std::optional<TrackId> radius;
};

// A plane across the world's z axis.
struct Ground {
    TrackId height = 0;
    Vec3Track color{};
};

// Fades everything farther than `start` from the eye into the colour: by 1 - 1/e in 1/density.
struct Fog {
    TrackId density = 0, start = 0; // world units
    Vec3Track color{};
};

// Light from everywhere: from the world's zenith and from its nadir.
struct Ambient {
    Vec3Track top{}, bottom{};
};

// Takes away light from everywhere where the surface is near along the normal.
struct Occlusion {
    std::optional<TrackId> reach; // world units; else a fifth of the bounds' radius
    TrackId strength = 0;         // 0: none, 1: full
};

// Takes a half-space or a ball away from the solid F < 0; world coordinates. See cut.h.
struct Cut {
    bool is_ball = false;
    // Of a half-space: away from what is left; a point of its plane; how far beyond it that is.
    Vec3Track normal{}, point{};
    TrackId offset = 0;
    // Of a ball.
    Vec3Track centre{};
    TrackId radius = 0;
};

// Colours the surface by a number: `low` is at the beginning of the map and `high` at its end.
struct Paint {
    std::shared_ptr<const formula::Paint> value;
    TrackId low = 0, high = 0;
    std::optional<Range> shown; // in place of both: what the surface shows, see shown_range.h
    bool met = true;            // ...and whether it shows anything
    ColorMap map = ColorMap::blue_yellow;
};

// Lines on the surface where a number of the place is a multiple of `every`, `from` being one.
struct Contours {
    std::shared_ptr<const formula::Paint> value; // with its slopes: formula/contours.h
    TrackId every = 0, from = 0;
    TrackId width = 0; // pixels
    Vec3Track color{};
};

// The solid F < 0 as clear matter: light goes through, bent where it enters and leaves.
struct Glass {
    TrackId transmission = 0; // of the light that is not reflected, the part that goes in: 0..1
    TrackId ior = 0;          // index of refraction against what is around, above 0
    Vec3Track absorption{};   // per world unit: light fades by exp(-absorption * way)
    int depth = 4;            // rays that are followed after the eye's, 0 to limits::glass_depth
};

// `color` is seen from where F > 0. Only a surface with `inside` has two colours.
struct Material {
    enum class Reflection { none, sky, self };
    enum class Model {
        lambert,     // matt
        blinn_phong, // a highlight of a given shininess
        ggx,         // microfacets: from plastic to metal
    };
    Model model = Model::lambert;
    Vec3Track color{};
    // Another one at every place, of which parts may be those of `color`; null: `color` everywhere.
    std::shared_ptr<const formula::Paint> color_by_place;
    Reflection reflection = Reflection::none; // of what is around, and of the surface itself
    std::optional<Vec3Track> inside;          // seen from where F < 0
    std::optional<Vec3Track> cap;             // of caps, where sections cut; else as inside
    std::optional<Paint> paint;               // instead of all
    std::optional<Contours> contours;         // over them
    std::optional<Glass> glass;
    // Each only where the model has it.
    std::optional<TrackId> shininess;           // exponent, 0 to max_shininess
    std::optional<TrackId> roughness, metallic; // 0..1
    std::optional<TrackId> specular;            // reflectance straight on, 0..1
};

inline constexpr double max_shininess = 10'000;

struct ModelName {
    Material::Model model;
    std::string_view name;
};

inline constexpr ModelName model_names[] = {
    {Material::Model::lambert, "lambert"},
    {Material::Model::blinn_phong, "blinn-phong"},
    {Material::Model::ggx, "ggx"},
};

constexpr std::string_view name(Material::Model model) {
    for (const auto& entry : model_names) {
        if (entry.model == model) return entry.name;
    }
    return "?";
}

constexpr std::optional<Material::Model> parse_model(std::string_view text) {
    for (const auto& entry : model_names) {
        if (entry.name == text) return entry.model;
    }
    return std::nullopt;
}

// The light from far away in every direction, as a latitude-longitude map. The world's z axis
// points to the top of the map, the x axis to its middle, the y axis to its left quarter.
struct Environment {
    std::filesystem::path map;
    base::Confines within;  // where the map must lie when it is opened
    TrackId rotation = 0;   // of the surroundings about the z axis, degrees
    TrackId intensity = 0;  // multiplies the map
    bool background = true; // seen behind the surface
};

// Colours at the ends of the world's z axis.
struct SkyGradient {
    std::array<double, 3> top{}, bottom{};
};

struct Output {
    int width = 512, height = 512;
    std::array<double, 3> background{};
    std::optional<SkyGradient> gradient; // in place of `background`
    bool transparent = false;
    int poster = 1;  // the frame that stands for the whole
    int samples = 1; // pictures whose mean is a frame
};

// Settings of a file of the program's that apply where a scene says nothing itself.
struct NamedLook {
    std::string name;                   // empty: none
    std::vector<std::string> keys = {}; // what it set: "lights", "material.model"
};

// Which of how many surfaces of one scene.
struct Among {
    int index = 0, count = 1;
    int mirrors = 0; // a bit for each that mirrors all: of_surface() tells
};

struct Scene {
    std::filesystem::path file; // of a formula alone, one that is not there
    std::string formula;        // if that is all the scene was loaded by
    std::string title;
    animation::Timeline timeline;
    Surface surface;
    Isolation isolation;
    Camera camera;
    std::vector<Light> lights; // at least one
    Material material;
    std::vector<Cut> sections;
    std::optional<Ground> ground;
    std::optional<Fog> fog;
    std::optional<Ambient> ambient; // without it a little white
    std::optional<Occlusion> occlusion;
    std::optional<Environment> environment;
    Output output;
    NamedLook look;
    // A scene with several surfaces is that of the first, and has the scenes of the others, each
    // with an animation of its own. What they share is the first one's: see surfaces.h.
    std::vector<Scene> others;
    Among among;
};

// What loads the scene again, from any folder: its formula, or its file's whole path.
std::string word_of(const Scene& scene);

} // namespace isomotion::scene
