// The keys of a scene file, section by section. A new key is a row here, and its use.
//
// Coordinates and lengths are the world's unless a row says otherwise; colours are linear.
#pragma once

#include "scene/key.h"
#include "scene/limits.h"
#include "scene/method.h"
#include "scene/scene_at.h"

namespace isomotion::scene::keys {

inline constexpr std::array white{1.0, 1.0, 1.0};
inline constexpr std::array black{0.0, 0.0, 0.0};
inline constexpr std::array origin{0.0, 0.0, 0.0};
inline constexpr std::array zero{0.0, 0.0, 0.0}; // of vectors, and of numbers

constexpr std::array<double, 3> number(double value) { return {value, 0, 0}; }

inline constexpr auto title_keys = std::tuple(
    ReadByHand{"title", R"({"type": "string"})", "a text of one line", "the file's name"});

inline constexpr auto time_keys = std::tuple(
    ReadByHand{"fps", R"({"anyOf": [{"type": "number", "minimum": 0}, {"type": "string"}]})",
               "frames a second: 30, 23.976 or \"30000/1001\"", "30"},
    still("frames", &animation::Timeline::frames, from_to(1, limits::frames),
          "how many frames the scene has"),
    ReadByHand{"seconds", R"({"type": "number", "minimum": 0})",
               "in place of `frames`: how long the scene is"},
    still("loop", &animation::Timeline::loops, {},
          "true: the frame after the last would be the first again"),
    ReadByHand{"seed", R"({"type": "integer", "minimum": 0, "maximum": 2147483647})", "of `random`",
               "0"});

inline constexpr auto surface_keys = std::tuple(
    ReadByHand{"formula", R"({"type": "string"})",
               "an [equation](formulas.md), or the left side of F = 0"},
    ReadByHand{"use", R"({"type": "string"})",
               "a surface of the catalogue (`isomotion list surfaces`)"},
    still("jumps", &Surface::jumps_are_walls, {},
          "true: where F jumps across 0 (floor, sign) there is a wall of the solid F < 0: see "
          "[rendering](rendering.md)"));
inline constexpr auto listed_surface_keys = std::tuple(ReadByHand{
    "name", R"({"type": "string", "minLength": 1})", "of a surface among several", "its number"});

// Any other key of an array is a field.
inline constexpr auto array_keys = std::tuple(
    ReadByHand{"count", R"({"type": "integer", "minimum": 0})",
               "number of elements; beside a file, the most there may be at a time",
               "the catalogue's, the file's"},
    ReadByHand{"file", R"({"type": "string"})",
               "elements from a file, or with #### from one for each frame: [particles from "
               "files](#particles-from-files)"},
    ReadByHand{"first_file", R"({"type": "integer", "minimum": 0})",
               "the number of the file that frame 1 shows"},
    ReadByHand{"columns", R"({"type": "object", "additionalProperties": {"type": "string"}})",
               "`field = \"column\"` of the file"},
    ReadByHand{"interpolation", R"({"enum": ["linear", "hold", "hermite"]})",
               "how elements go from one time to the next"},
    ReadByHand{"extrapolate", R"({"enum": ["hold"]})", "the first and the last elements stay"});

inline constexpr auto ball_keys = std::tuple(
    animated("sphere", &Bounds::radius, {}, "radius of a ball, formula coordinates"),
    animated("centre", &Bounds::centre, {.standard = origin}, "its centre, formula coordinates"));

inline constexpr auto box_keys = std::tuple(ReadByHand{
    "box",
    R"({"type": "array", "minItems": 2, "maxItems": 2, "items": {"$ref": "#/definitions/animatedVector"}})",
    "instead: two opposite corners, `[[x0, y0, z0], [x1, y1, z1]]`, formula coordinates; "
    "animated"});

inline constexpr auto transform_keys =
    std::tuple(animated("translate", &Placement::translate, &PlacementAt::translate,
                        {.standard = origin}, "world units"),
               animated("rotate", &Placement::rotate, {.standard = zero},
                        "degrees about the fixed axes x, then y, then z"),
               animated("scale", &Placement::scale, &PlacementAt::scale,
                        {.allowed = above(0), .standard = number(1)}, "a factor"));

inline constexpr auto method_words = words_of(method_traits, &MethodTraits::method);

// Lengths of the paper's methods are in formula coordinates, thresholds in units of F.
inline constexpr auto isolation_keys = std::tuple(
    choice("method", &Isolation::method, method_words,
           "see [rendering](rendering.md), `isomotion list methods`", "`hermite`"),
    still("safety", &Isolation::safety, from_to(1, 1e6),
          "`hermite` rules a root out only where its cubic stays farther from 0 than this many "
          "times the cubic's estimated error"),
    still("certify", &Isolation::certify, {},
          "whether the GPU proves each pixel: see [rendering](rendering.md)"),
    still("beam", &Isolation::beam, {},
          "whether bounds first skip the empty part of the way for whole blocks of pixels",
          "with `hermite`, where bounds of the formula are cheap; in [compute "
          "shaders](rendering.md#stages) for lists of elements and in large pictures alone"),
    still("step", &Isolation::step, from_to(1e-30, 1e30),
          "base step b of the paper's methods, in formula coordinates",
          "1/100 of the bounds' radius"),
    still("near", &Isolation::near, from_to(0, 1e30),
          "threshold on \\|F\\| (without [factors that are never "
          "0](rendering.md#what-the-surface-is)) in Eq. 2 of the paper, for `amp-sign` and "
          "`amp-taylor`: nearer than this the step shrinks",
          "from the field"),
    still("far", &Isolation::far, from_to(0, 1e30), "the same: beyond this the step grows",
          "from the field"),
    still("horizon", &Isolation::horizon, from_to(0, 1e30),
          "their threshold on \\|dF/dt\\|: nearer than `near`, a smaller derivative along the ray "
          "shrinks the step once more",
          "from the field"),
    still("bisections", &Isolation::bisections, from_to(0, limits::bisections),
          "how often the paper's methods halve the interval with the root"),
    still("limit", &Isolation::limit, from_to(1, limits::evaluations),
          "evaluations after which a ray ends as *step limit*"));

inline constexpr std::array projection_words{
    Word<Camera::Projection>{Camera::Projection::perspective, "perspective"},
    Word<Camera::Projection>{Camera::Projection::orthographic, "orthographic"}};

inline constexpr auto camera_keys = std::tuple(
    animated("position", &Camera::position, &CameraAt::position, {.unit = Unit::position},
             "where the eye is", "on the orbit"),
    animated("target", &Camera::target, &CameraAt::target, {.unit = Unit::position},
             "what the camera looks at", "the middle of the bounds; beside a position the origin"),
    animated("up", &Camera::up, &CameraAt::up,
             {.unit = Unit::direction, .standard = std::array{0.0, 0.0, 1.0}},
             "the direction that is up in the picture"),
    animated("azimuth", &Camera::azimuth, {.standard = number(34)},
             "of an orbit about the target: degrees about `up` from the x axis"),
    animated("elevation", &Camera::elevation, {.standard = number(23)},
             "of the orbit: degrees above the plane across `up`"),
    animated("distance", &Camera::distance, {.allowed = above(0)}, "of the orbit: from the target",
             "so far that the bounds fill the picture"),
    choice("projection", &Camera::projection, projection_words, "", "`perspective`"),
    animated("fov", &Camera::fov, &CameraAt::fov,
             {.allowed = between(0, 180), .standard = number(40)},
             "of a perspective picture: the vertical angle, degrees"),
    animated("zoom", &Camera::zoom, &CameraAt::zoom, {.allowed = above(0), .standard = number(1)},
             "magnifies the picture about its middle"),
    animated("height", &Camera::height, &CameraAt::height,
             {.allowed = above(0), .unit = Unit::length}, "of an orthographic picture",
             "the bounds; beside a position or distance, what `fov` takes in at the target"),
    still("shutter", &Camera::shutter, from_to(0, 1),
          "motion blur: the part of a frame's duration for which the shutter is open, from the "
          "frame's time on"),
    animated("aperture", &Camera::aperture, &CameraAt::aperture,
             {.allowed = at_least(0), .unit = Unit::length},
             "depth of field: the lens' diameter. 0 is a pinhole; an orthographic camera's lens is "
             "telecentric",
             "0"),
    animated("focus", &Camera::focus, &CameraAt::focus, {.allowed = above(0), .unit = Unit::length},
             "beside `aperture`: from the eye along the camera's axis to the plane that is sharp",
             "the target's distance"));

// A light has one of them.
inline constexpr auto light_place_keys =
    std::tuple(animated("direction", &Light::direction, {}, "to a light far away"),
               animated("position", &Light::direction, {}, "instead: where a light is"));
inline constexpr auto light_keys = std::tuple(
    animated("falloff", &Light::falloff, &LightAt::falloff,
             {.allowed = above(0), .unit = Unit::length},
             "of a light with a position: the distance at which it has its colour, fading with "
             "the square",
             "the same everywhere"),
    animated("color", &Light::color, &LightAt::color, {.unit = Unit::color, .standard = white},
             "linear", "white"),
    still("shadow", &Light::shadow, {},
          "true: the surface hides this light from itself and from the ground"),
    animated("radius", &Light::radius, {.allowed = at_least(0)},
             "the light's size, for shadows with soft edges: degrees, at most 45; of a light with "
             "a position world units. The [samples](effects.md#how) of a frame see it from "
             "different points of the light",
             "0"),
    still("with_camera", &Light::with_camera, {},
          "true: `direction` is to the viewer's right, up and back, and goes with the camera"));

// A section is a half-space or a ball.
inline constexpr auto plane_keys = std::tuple(
    animated("normal", &Cut::normal, {}, "of a half-space: points into it, any length but 0"),
    animated("point", &Cut::point, {.standard = origin}, "a point of its plane"),
    animated("offset", &Cut::offset, {.standard = zero},
             "how far beyond that along the normal the plane is"));
inline constexpr auto cut_ball_keys = std::tuple(
    animated("sphere", &Cut::radius, &SectionAt::reach, {.allowed = at_least(0)},
             "instead: radius of a ball"),
    animated("centre", &Cut::centre, &SectionAt::where, {.standard = origin}, "its centre"));

inline constexpr std::array model_words{
    Word<Material::Model>{Material::Model::lambert, "lambert"},
    Word<Material::Model>{Material::Model::blinn_phong, "blinn-phong"},
    Word<Material::Model>{Material::Model::ggx, "ggx"}};
inline constexpr std::array reflection_words{
    Word<Material::Reflection>{Material::Reflection::sky, "sky"},
    Word<Material::Reflection>{Material::Reflection::self, "self"}};

inline constexpr auto color_keys = std::tuple(
    ReadByHand{"color", R"({"$ref": "#/definitions/animatedVector"})",
               "linear; animated; or three [expressions of the place](#colour-by-place)",
               "that of [elements that have one](#colour-by-element), the catalogue's, or orange"},
    animated("back_color", &Material::inside, &SurfaceAt::inside_color, {.unit = Unit::color},
             "the colour of the surface seen from where F < 0",
             "the catalogue's, or the same as `color`"));
inline constexpr auto cap_keys =
    std::tuple(animated("cap_color", &Material::cap, &SurfaceAt::cap_color, {.unit = Unit::color},
                        "the colour of caps, where [sections](#sections) cut the solid open",
                        "`back_color`, else as the surface; with a colour map, by the map"));
inline constexpr auto material_keys = std::tuple(
    choice("model", &Material::model, model_words,
           "matt, with a highlight, or from plastic to metal", "`lambert`"),
    choice("reflection", &Material::reflection, reflection_words,
           "mirrors what is around, by the model's Fresnel weight (a matt surface has a clear "
           "coat); or also itself, once",
           "none"));

// The numbers of each model, in the order in which its shader has them.
inline constexpr auto blinn_phong_keys = std::tuple(
    animated("shininess", &Material::shininess,
             {.allowed = from_to(0, max_shininess), .standard = number(50)},
             "of `blinn-phong`: the highlight's exponent"),
    animated("specular", &Material::specular, {.allowed = from_to(0, 1), .standard = number(0.2)},
             "of `blinn-phong`: what is reflected straight on"));
inline constexpr auto ggx_keys = std::tuple(
    animated("roughness", &Material::roughness, {.allowed = from_to(0, 1), .standard = number(0.4)},
             "of `ggx`: from a mirror (below 0.045 as 0.045) to matt"),
    animated("metallic", &Material::metallic, {.allowed = from_to(0, 1), .standard = number(0)},
             "of `ggx`: 0 (matt colour under a clear coat) to 1 (the colour is that of the "
             "highlights)"),
    // That of glass and most plastics.
    animated("specular", &Material::specular, {.allowed = from_to(0, 1), .standard = number(0.04)},
             "of `ggx`: what is reflected straight on"));

// Calls visit(model, its keys) for each model that has some.
template<class Visit> void for_each_model(Visit&& visit) {
    visit(Material::Model::blinn_phong, blinn_phong_keys);
    visit(Material::Model::ggx, ggx_keys);
}

// Only matter that has the first one has the others.
inline constexpr auto glass_keys = std::tuple(
    animated("transmission", &Glass::transmission, &GlassAt::transmission,
             {.allowed = from_to(0, 1), .standard = number(1)},
             "glass and water: of the light that is not reflected, the part that goes through, "
             "[see below](#glass)",
             "none"),
    animated("ior", &Glass::ior, &GlassAt::ior,
             {.allowed = from_to(0.01, 100), .standard = number(1.5)},
             "beside `transmission`: the index of refraction; water has 1.33"),
    animated("absorption", &Glass::absorption, &GlassAt::absorption,
             {.allowed = from_to(0, 1e6), .unit = Unit::per_length, .standard = zero},
             "what goes through fades by exp(-absorption way), a number for each colour, per world "
             "unit"),
    still("depth", &Glass::depth, from_to(0, limits::glass_depth),
          "how many rays follow a pixel's light after the eye's"),
    still("priority", &Glass::priority, from_to(-limits::priority, limits::priority),
          "among several surfaces: where matter overlaps, only that with the highest priority is "
          "there, [see below](#glass-among-several-surfaces)"));

inline constexpr std::array color_map_words{Word<ColorMap>{ColorMap::blue_yellow, "blue-yellow"},
                                            Word<ColorMap>{ColorMap::blue_orange, "blue-orange"}};

inline constexpr auto colormap_keys = std::tuple(
    ReadByHand{"value", R"({"type": ["string", "number"]})",
               "an [expression](#colour-by-a-number)"},
    ReadByHand{
        "range",
        R"({"anyOf": [{"const": "auto"}, {"type": "array", "minItems": 2, "maxItems": 2, "items": {"$ref": "#/definitions/animated"}}]})",
        "`[low, high]`: the numbers at the ends of the map; animated; `low` above `high` turns the "
        "map round. `\"auto\"`: [what the surface shows](#the-range-that-is-shown)"},
    choice("map", &Paint::map, color_map_words,
           "from dark to light; or light in the middle, for numbers with a sign", "`blue-yellow`"));

inline constexpr auto contour_value_keys = std::tuple(
    ReadByHand{"value", R"({"type": "string"})",
               "an expression of `x`, `y`, `z` (formula coordinates), `t`, parameters and sums"});
inline constexpr auto contour_keys = std::tuple(
    animated("every", &Contours::every, &ContoursAt::every,
             {.allowed = above(0), .needed = "how far apart in value the lines are, as 0.1"},
             "how far apart in value the lines are"),
    animated("from", &Contours::from, &ContoursAt::from, {.standard = zero}, "a value with a line"),
    animated("width", &Contours::width, &ContoursAt::width,
             {.allowed = at_least(0), .standard = number(1)}, "of a line, in pixels"),
    animated("color", &Contours::color, &ContoursAt::color,
             {.unit = Unit::color, .standard = black}, "linear", "black"));

inline constexpr auto ground_keys = std::tuple(
    animated("height", &Ground::height, &GroundAt::height,
             {.needed = "the ground's z in world coordinates"}, "its z"),
    animated("color", &Ground::color, &GroundAt::color,
             {.unit = Unit::color, .standard = std::array{0.5, 0.5, 0.5}}, "linear", "grey"));

inline constexpr auto fog_keys =
    std::tuple(animated("density", &Fog::density, &FogAt::density,
                        {.allowed = at_least(0),
                         .unit = Unit::per_length,
                         .needed = "what a world unit takes away, as 0.1"},
                        "per world unit"),
               animated("start", &Fog::start, &FogAt::start,
                        {.allowed = at_least(0), .unit = Unit::length, .standard = zero},
                        "how far from the eye it begins"),
               animated("color", &Fog::color, &FogAt::color, {.unit = Unit::color}, "linear",
                        "the background"));

inline constexpr auto ambient_keys = std::tuple(
    animated("top", &Ambient::top, &AmbientAt::top,
             {.unit = Unit::color,
              .needed = "[r, g, b], the light from above; from below comes the same, or bottom"},
             "from the world's zenith; linear"),
    animated("bottom", &Ambient::bottom, &AmbientAt::bottom, {.unit = Unit::color},
             "from its nadir; linear", "the same as `top`"));

inline constexpr auto occlusion_keys = std::tuple(
    animated("radius", &Occlusion::reach, &OcclusionAt::reach,
             {.allowed = above(0), .unit = Unit::length}, "how far along the normal",
             "a fifth of the bounds' radius"),
    animated("strength", &Occlusion::strength, &OcclusionAt::strength,
             {.allowed = from_to(0, 1), .standard = number(1)}, "how much is taken away"));

inline constexpr auto environment_keys = std::tuple(
    ReadByHand{"map", R"({"type": "string"})",
               "a latitude-longitude picture, twice as wide as high: EXR, HDR, TIFF, PNG, JPEG; "
               "from where the scene is, else of the program's `media/`"},
    animated("rotation", &Environment::rotation, {.standard = zero},
             "of the surroundings about the world's z axis, degrees; at 0 the map's middle is "
             "where x points"),
    animated("intensity", &Environment::intensity, &EnvironmentAt::intensity,
             {.allowed = from_to(0, limits::brightness), .standard = number(1)},
             "multiplies the map"),
    still("background", &Environment::background, {}, "true: the map is seen behind the surface",
          "true; with an `output.background`, false"));

inline constexpr auto output_keys = std::tuple(
    ReadByHand{
        "size",
        R"({"type": "array", "minItems": 2, "maxItems": 2, "items": {"type": "integer", "minimum": 1, "maximum": 16384}})",
        "`[width, height]`", "512, 512"},
    ReadByHand{
        "background",
        R"({"anyOf": [{"$ref": "#/definitions/stillColor"}, {"const": "transparent"}, {"type": "object", "properties": {"top": {"$ref": "#/definitions/stillColor"}, "bottom": {"$ref": "#/definitions/stillColor"}}, "additionalProperties": false, "required": ["top", "bottom"]}]})",
        "`[r, g, b]`, linear; `{ top = [r, g, b], bottom = [r, g, b] }`, from the world's zenith "
        "to "
        "its nadir; or `\"transparent\"`",
        "light grey"},
    still("samples", &Output::samples, from_to(1, limits::samples),
          "pictures whose mean is a frame, best a power of two: see [rendering](rendering.md)",
          "16 with a `shutter` above 0, an `aperture` or a light's `radius`, else 1"),
    still("poster", &Output::poster, from_to(1, limits::frames),
          "the frame that stands for the whole: `render --frames poster`"));

} // namespace isomotion::scene::keys
