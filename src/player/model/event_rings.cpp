#include "player/model/event_rings.h"

#include <algorithm>
#include <cmath>

#include "player/model/orbit.h"

namespace isomotion::player {
namespace {

const scene::PlacementAt* placement_of(const scene::SceneAt& now, int surface) {
    if (surface < 0 || std::size_t(surface) >= now.surfaces.size()) return nullptr;
    return &now.surfaces[std::size_t(surface)].placement;
}

double nearness(const PlacedEvent& event, double frame) {
    const double apart = std::max({event.first - frame, frame - event.last, 0.0});
    return 1 - apart / ring_frames;
}

} // namespace

std::optional<glm::dvec2> projected(const scene::CameraAt& camera, const glm::dvec3& world) {
    const PictureAxes axes = picture_axes(camera);
    const glm::dvec3 from = world - camera.position;
    const double depth = glm::dot(from, axes.forward);
    if (!(depth > 0)) return std::nullopt;
    const bool is_parallel = camera.projection == scene::Camera::Projection::orthographic;
    const double height = shown_height(camera) *
                          (is_parallel ? 1 : depth / glm::length(camera.target - camera.position));
    const glm::dvec2 at = glm::dvec2(glm::dot(from, axes.right), glm::dot(from, axes.up)) / height;
    if (!std::isfinite(at.x) || !std::isfinite(at.y)) return std::nullopt;
    return at;
}

std::vector<Ring> rings(const std::vector<PlacedEvent>& events, const scene::SceneAt& now,
                        double frame, double aspect) {
    std::vector<Ring> seen;
    for (std::size_t k = 0; k < events.size(); ++k) {
        const double near = nearness(events[k], frame);
        const scene::PlacementAt* placement = placement_of(now, events[k].surface);
        if (!(near > 0) || !placement) continue;
        const auto at = projected(now.camera, placement->to_world(events[k].where));
        if (!at || std::abs(at->x) > aspect / 2 || std::abs(at->y) > 0.5) continue;
        seen.push_back({k, *at, near});
    }
    std::ranges::stable_sort(seen, std::ranges::greater{}, &Ring::nearness);
    if (seen.size() > most_rings) seen.resize(most_rings);
    return seen;
}

} // namespace isomotion::player
