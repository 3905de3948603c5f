// A scene at one time, as plain numbers.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "scene/cut.h"
#include "scene/scene.h"

namespace isomotion::scene {

struct BoundsAt {
    Bounds::Shape shape = Bounds::Shape::sphere;
    glm::dvec3 min{-1}, max{1}; // the box, or the sphere's circumscribed box
    glm::dvec3 centre{0};
    double radius = 1; // of the sphere, or of the box's circumscribed sphere

    bool operator==(const BoundsAt&) const = default;
};

// Formula coordinates to world: world = translate + scale * rotate * local.
struct PlacementAt {
    glm::dvec3 translate{0};
    glm::dmat3 rotate{1};
    double scale = 1;

    glm::dvec3 to_world(const glm::dvec3& local) const {
        return translate + scale * (rotate * local);
    }
    glm::dvec3 to_local(const glm::dvec3& world) const {
        return glm::transpose(rotate) * (world - translate) / scale;
    }
};

struct CameraAt {
    glm::dvec3 position{0, 0, 3}, target{0}, up{0, 1, 0};
    double fov = 40;     // perspective: vertical, degrees
    double height = 0;   // orthographic: world units
    double zoom = 1;     // magnifies the picture about its middle
    double aperture = 0; // diameter of the lens, world units
    double focus = 0;    // distance of the sharp plane from the eye along the axis, world units
    Camera::Projection projection = Camera::Projection::perspective;

    bool operator==(const CameraAt&) const = default;
};

struct LightAt {
    // To the light, unit length; for a point light its position; world coordinates.
    glm::dvec3 direction{0, 0, 1};
    glm::dvec3 color{1};
    bool is_point = false;
    double falloff = 0; // distance at which a point light has its colour; 0: everywhere
    double radius = 0;  // of its disc: tangent of the angle; for a point light world units
};

struct ContoursAt {
    double every = 1, from = 0;
    double width = 1; // pixels
    glm::dvec3 color{0};
};

struct GlassAt {
    double transmission = 0, ior = 1.5;
    glm::dvec3 absorption{0}; // per world unit
};

struct GroundAt {
    double height = 0;
    glm::dvec3 color{0};
};

struct FogAt {
    double density = 0, start = 0;
    glm::dvec3 color{0};
};

struct AmbientAt {
    glm::dvec3 top{0}, bottom{0};
};

struct OcclusionAt {
    double reach = 1, strength = 1;
};

struct EnvironmentAt {
    // The directions of the map's middle, left quarter and top: unit length, world coordinates.
    glm::dvec3 ahead{1, 0, 0}, left{0, 1, 0}, top{0, 0, 1};
    double intensity = 1;
};

// A surface at one time.
struct SurfaceAt {
    std::shared_ptr<const animation::Values> values; // of its animation
    // The values of the formula's names, rounded to float, so that GPU, CPU and truth use the same.
    formula::Bindings<float> bindings;
    BoundsAt bounds;
    formula::CubicSteps cubic_steps; // of an eighth of the bounds' radius
    PlacementAt placement;
    glm::dvec3 color{1};
    glm::dvec3 inside_color{1}; // for a surface with two colours
    glm::dvec3 cap_color{1};    // for a surface whose caps have their own colour
    ContoursAt contours;        // if the material has them
    GlassAt glass;              // if the material has it
    // Blinn-Phong: shininess, specular. GGX: roughness, metallic, specular. Unused entries are 0.
    glm::dvec4 gloss{0};
    glm::dvec2 paint_range{0, 1}; // the values at the ends of the colour map
};

struct SceneAt {
    double time = 0;
    std::vector<SurfaceAt> surfaces; // as the scene lists them
    CameraAt camera;
    std::vector<LightAt> lights;
    std::vector<SectionAt> sections; // world
    GroundAt ground;                 // this and the following: if the scene has them
    FogAt fog;
    AmbientAt ambient;
    OcclusionAt occlusion;
    std::optional<EnvironmentAt> environment;
};

// One surface at the scene's time. It refers to the scene's state, which must outlive it.
struct OneSurfaceAt {
    OneSurfaceAt(const SceneAt& its_scene, std::size_t index)
        : scene(its_scene)
        , surface(its_scene.surfaces.at(index)) {}
    // The surface of a scene that has a single one, as OneSurface does.
    OneSurfaceAt(const SceneAt& its_scene) // NOLINT(google-explicit-constructor)
        : OneSurfaceAt(its_scene, only(its_scene.surfaces.size())) {}
    // The surface as another camera sees it, or by other light.
    OneSurfaceAt(const SceneAt& other_scene, const SurfaceAt& its_surface)
        : scene(other_scene)
        , surface(its_surface) {}

    const SceneAt& scene;
    const SurfaceAt& surface;
};

// Moves the first surface to its formula coordinates, and all else with it. Rays and verdicts stay
// the same. Positions are then in that surface's formula coordinates, where float has full
// precision for them. The ground doesn't move, since it is not part of a surface.
SceneAt in_formula_coordinates(SceneAt scene);

// Throws SceneError if a value is out of its range at this time (a radius of 0, a field of view of
// 200 degrees, a camera at its own target).
SceneAt at(const Scene& scene, double time);
SceneAt at_frame(const Scene& scene, std::int64_t frame);
// `part` of a frame's duration, 0 to 1, after the frame's time.
SceneAt at_frame(const Scene& scene, std::int64_t frame, double part);

// A surface alone, without what its scene shares.
SurfaceAt surface_at(const OneSurface& one, double time);

} // namespace isomotion::scene
