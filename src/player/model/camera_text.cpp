#include "player/model/camera_text.h"

#include <cmath>

#include <fmt/format.h>

namespace isomotion::player {
namespace {

// Adding 0 makes 0 of -0, which TOML has no integer for. Integers that double may have rounded are
// not taken for numbers when they are read: those are written as floats.
std::string text(double number) {
    std::string shortest = fmt::format("{}", number + 0.0);
    if (std::abs(number) >= 0x1p53 && shortest.find_first_of(".e") == shortest.npos) {
        shortest += ".0";
    }
    return shortest;
}

std::string text(const glm::dvec3& v) {
    return fmt::format("[{}, {}, {}]", text(v.x), text(v.y), text(v.z));
}

} // namespace

std::string camera_text(const scene::CameraAt& camera, double shutter) {
    std::string lines = "[camera]\n";
    const auto add = [&](const char* key, const std::string& value) {
        lines += fmt::format("{} = {}\n", key, value);
    };
    add("position", text(camera.position));
    add("target", text(camera.target));
    if (camera.up != glm::dvec3(0, 0, 1)) add("up", text(camera.up));
    if (camera.projection == scene::Camera::Projection::orthographic) {
        add("projection", "\"orthographic\"");
        add("height", text(camera.height));
    } else {
        add("fov", text(camera.fov));
    }
    if (camera.zoom != 1) add("zoom", text(camera.zoom));
    if (camera.aperture > 0) {
        add("aperture", text(camera.aperture));
        add("focus", text(camera.focus));
    }
    if (shutter > 0) add("shutter", text(shutter));
    return lines;
}

} // namespace isomotion::player
