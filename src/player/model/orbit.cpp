#include "player/model/orbit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isomotion::player {
namespace {

using scene::CameraAt;

bool is_parallel(const CameraAt& camera) {
    return camera.projection == scene::Camera::Projection::orthographic;
}

double distance(const CameraAt& camera) { return glm::length(camera.target - camera.position); }

// Half of what a picture of height 1 takes in at distance 1.
double slope(const CameraAt& camera) {
    return std::tan(glm::radians(camera.fov) / 2) / camera.zoom;
}

// Keeps the target in focus if it was in focus before the camera moved.
void keep_focus(CameraAt& camera, double before) {
    if (std::abs(camera.focus - before) <= 1e-9 * before) camera.focus = distance(camera);
}

bool is_usable(const CameraAt& camera) {
    constexpr double most = std::numeric_limits<float>::max(); // everything ends as a float
    const auto fits = [](double x) { return std::abs(x) <= most; };
    for (int k = 0; k < 3; ++k) {
        if (!fits(camera.position[k]) || !fits(camera.target[k])) return false;
    }
    const double away = distance(camera);
    const double coarse = std::max(glm::length(camera.position), glm::length(camera.target));
    // The direction needs digits of its own.
    return away > 1e-9 * coarse && away > std::numeric_limits<float>::min() &&
           fits(camera.height) &&
           (!is_parallel(camera) || camera.height > std::numeric_limits<float>::min());
}

// The direction from the target to the camera, about a pole.
struct Direction {
    glm::dvec3 pole{0}, level{0}; // unit; `level` is across the pole, below or above the camera
    double elevation = 0;         // radians
};

Direction direction_of(const CameraAt& camera) {
    Direction d;
    d.pole = glm::normalize(camera.up);
    const glm::dvec3 back = glm::normalize(camera.position - camera.target);
    const double height = glm::dot(back, d.pole);
    const glm::dvec3 across = back - height * d.pole;
    d.elevation = std::atan2(height, glm::length(across));
    if (glm::length(across) < 1e-9) {
        // From a pole, the picture's upright direction points away from the camera's side, and at
        // the lower pole towards it.
        const glm::dvec3 upright = picture_axes(camera).up;
        d.level = height > 0 ? -upright : upright;
    } else {
        d.level = across;
    }
    d.level = glm::normalize(d.level - glm::dot(d.level, d.pole) * d.pole);
    return d;
}

} // namespace

PictureAxes picture_axes(const CameraAt& camera) {
    PictureAxes axes;
    axes.forward = glm::normalize(camera.target - camera.position);
    glm::dvec3 up = camera.up;
    if (glm::length(glm::cross(axes.forward, up)) < 1e-9 * glm::length(up)) {
        up = std::abs(axes.forward.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    }
    axes.right = glm::normalize(glm::cross(axes.forward, up));
    axes.up = glm::cross(axes.right, axes.forward);
    return axes;
}

double shown_height(const CameraAt& camera) {
    return is_parallel(camera) ? camera.height / camera.zoom : 2 * distance(camera) * slope(camera);
}

glm::dvec3 point_at(const CameraAt& camera, const glm::dvec2& at) {
    const PictureAxes axes = picture_axes(camera);
    return camera.target + shown_height(camera) * (at.x * axes.right + at.y * axes.up);
}

CameraAt orbited(const CameraAt& camera, const glm::dvec2& drag) {
    const double turn = glm::radians(degrees_per_height);
    const double highest = glm::radians(90 - pole_distance);
    const Direction from = direction_of(camera);
    const double azimuth = -turn * drag.x;
    const double elevation = std::clamp(from.elevation - turn * drag.y, -highest, highest);
    const glm::dvec3 level =
        std::cos(azimuth) * from.level + std::sin(azimuth) * glm::cross(from.pole, from.level);
    CameraAt moved = camera;
    moved.position = camera.target + distance(camera) * (std::cos(elevation) * level +
                                                         std::sin(elevation) * from.pole);
    keep_focus(moved, distance(camera));
    return is_usable(moved) ? moved : camera;
}

CameraAt panned(const CameraAt& camera, const glm::dvec2& drag) {
    const glm::dvec3 shift = camera.target - point_at(camera, drag);
    CameraAt moved = camera;
    moved.position += shift;
    moved.target += shift;
    keep_focus(moved, distance(camera));
    return is_usable(moved) ? moved : camera;
}

CameraAt dollied(const CameraAt& camera, double amount, const glm::dvec2& at) {
    const double factor = std::exp(-amount);
    const glm::dvec3 fixed = point_at(camera, at);
    CameraAt moved = camera;
    moved.target = fixed + factor * (camera.target - fixed);
    if (is_parallel(camera)) {
        // The plane where rays begin stays as far off.
        moved.position += moved.target - camera.target;
        moved.height *= factor;
    } else {
        moved.position = fixed + factor * (camera.position - fixed);
    }
    keep_focus(moved, distance(camera));
    return is_usable(moved) ? moved : camera;
}

CameraAt fitted(const CameraAt& camera, const scene::BoundsAt& bounds,
                const scene::PlacementAt& placement, double aspect) {
    const double radius = bounds.radius * placement.scale;
    const double narrow = std::atan(slope(camera) * std::min(aspect, 1.0));
    const double away = radius / std::sin(narrow);
    CameraAt moved = camera;
    moved.target = placement.to_world(bounds.centre);
    moved.position = moved.target - away * picture_axes(camera).forward;
    if (is_parallel(camera)) moved.height = 2 * radius * camera.zoom / std::min(aspect, 1.0);
    keep_focus(moved, distance(camera));
    return is_usable(moved) ? moved : camera;
}

} // namespace isomotion::player
