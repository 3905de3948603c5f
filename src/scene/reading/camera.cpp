#include "scene/reading/camera.h"

#include <fmt/format.h>

namespace isomotion::scene {
namespace {

using Source = animation::TrackSource;

Camera::Projection read_projection(Section& section) {
    const auto text = section.text("projection");
    if (!text || *text == "perspective") return Camera::Projection::perspective;
    if (*text == "orthographic") return Camera::Projection::orthographic;
    fail(*section.find("projection"), "camera.projection",
         fmt::format("must be perspective or orthographic, not '{}'", *text));
}

} // namespace

Camera read_camera(Section& document, TrackTable& tracks) {
    const toml::table none;
    auto given = document.section("camera");
    Section section = given ? *given : Section(none, "camera");
    const auto vector = [&](const std::string& name) -> std::optional<Vec3Track> {
        const auto source = section.vector(name);
        if (!source) return std::nullopt;
        return tracks.add("camera." + name, *source, section.find(name));
    };
    const auto number = [&](const std::string& name) -> std::optional<TrackId> {
        const auto source = section.track(name);
        if (!source) return std::nullopt;
        return tracks.add("camera." + name, *source, section.find(name));
    };
    const auto or_else = [&](std::optional<TrackId> track, const std::string& name, double value) {
        return track ? *track : tracks.add("camera." + name, Source(value), nullptr);
    };

    Camera camera;
    camera.projection = read_projection(section);
    camera.position = vector("position");
    camera.target = vector("target");
    if (camera.position) {
        for (const char* name : {"azimuth", "elevation", "distance"}) {
            if (!section.has(name)) continue;
            fail(*section.find(name), section.dotted(name),
                 "is of a camera on an orbit; this one has a position. Give one or the other");
        }
        // A camera that stands somewhere looks at the origin of the world.
        if (!camera.target) camera.target = tracks.add("camera.target", 0, 0, 0);
    }
    const auto up = vector("up");
    camera.up = up ? *up : tracks.add("camera.up", 0, 0, 1);
    camera.azimuth = or_else(number("azimuth"), "azimuth", 34);
    camera.elevation = or_else(number("elevation"), "elevation", 23);
    camera.distance = number("distance");
    camera.fov = or_else(number("fov"), "fov", 40);
    camera.zoom = or_else(number("zoom"), "zoom", 1);
    camera.height = number("height");
    if (camera.height && camera.projection == Camera::Projection::perspective) {
        fail(*section.find("height"), "camera.height",
             "is of an orthographic camera: projection = \"orthographic\"; this one has fov");
    }
    camera.shutter = section.number("shutter", 0, 1).value_or(0);
    camera.aperture = number("aperture");
    camera.focus = number("focus");
    if (camera.focus && !camera.aperture) {
        fail(*section.find("focus"), "camera.focus",
             "is of a camera with a lens: give its diameter, aperture, too");
    }
    section.refuse_rest();
    return camera;
}

} // namespace isomotion::scene
