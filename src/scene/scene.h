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
#include <vector>

#include "animation/timeline.h"
#include "formula/field.h"
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

// What a parameter is meant to take, for those who set it by hand; nothing enforces it.
struct Range {
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();

    bool contains(double value) const { return least <= value && value <= most; }
};

struct Surface {
    std::string name; // of the catalogue, or empty
    // Shared: evaluators and shaders refer to its programs for as long as they live.
    std::shared_ptr<const formula::Field> field;
    int parameters = 0;        // the first tracks of the animation are the formula's parameters
    std::vector<Range> ranges; // of those among them that a scene can name
    Bounds bounds;
    Placement placement;
};

// The method's settings; lengths in formula coordinates, thresholds in units of F.
struct Isolation {
    Method method = Method::amp_sign;
    double step = 0;    // b of Eq. 2
    double near = 0;    // tau 1: closer than this the step is halved
    double far = 0;     // tau 2: farther than this it is doubled
    double horizon = 0; // tau 3: near a silhouette (|dF/dt| below this) it is quartered
    int bisections = 10;
    int limit = 100'000; // evaluations after which a ray gives up with the verdict step limit
};

// Stands at `position`, or on an orbit about the target; what a scene leaves out follows from the
// bounds, so that they fill the picture.
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

// A directional light; the direction points to the light, in world coordinates.
struct Light {
    Vec3Track direction{}, color{};
    bool headlight = false; // no light given: over the viewer's shoulder
};

// `color` is seen from where F > 0. Only a surface with `inside` tells the two sides apart.
struct Material {
    Vec3Track color{};
    std::optional<Vec3Track> inside; // seen from where F < 0
};

struct Output {
    int width = 512, height = 512;
    std::array<double, 3> background{};
    bool transparent = false;
    int poster = 1;  // the frame that stands for the whole
    int samples = 1; // pictures whose mean is a frame
};

struct Scene {
    std::filesystem::path file;
    std::string title;
    animation::Timeline timeline;
    Surface surface;
    Isolation isolation;
    Camera camera;
    std::vector<Light> lights; // at least one
    Material material;
    Output output;
};

} // namespace isomotion::scene
