#include "topology/subject.h"

#include <fmt/format.h>

#include "probe/unbounded.h"
#include "scene/scene_at.h"

namespace isomotion::topology {

Subject subject_of(const scene::Scene& scene, std::size_t first,
                   std::optional<std::size_t> second) {
    const scene::OneSurface one(scene, first);
    const std::string& label = one.surface.label;
    if (!second)
        return {one, {}, one.is_alone() ? scene.title : fmt::format("{} ({})", scene.title, label)};
    const scene::OneSurface other(scene, *second);
    return {one, other, fmt::format("{} ({}, {})", scene.title, label, other.surface.label)};
}

TimelineHeader header_of(const Subject& subject, formula::Interval range,
                         const std::array<Side, 2>& solids) {
    TimelineHeader header =
        subject.second ? header_of_contact(subject.first, *subject.second, subject.title, range)
                       : header_of(subject.first, range);
    header.title = subject.title;
    for (std::size_t k = 0; k < (subject.second ? 2u : 1u); ++k)
        header.solids.push_back(solids[k] == Side::positive ? 1 : -1);
    return header;
}

std::vector<std::string> why_unbounded(const Subject& subject, int frame) {
    std::vector<std::string> reasons;
    const auto look_at = [&](const scene::OneSurface& one) {
        const scene::SurfaceAt now = scene::surface_at(one, one.scene.timeline.time(frame));
        if (auto why = probe::why_unbounded(one, now)) reasons.push_back(std::move(*why));
    };
    look_at(subject.first);
    if (subject.second) look_at(*subject.second);
    return reasons;
}

Timeline analyse(const Subject& subject, const AnalyseOptions& how) {
    Timeline timeline = subject.second ? analyse_contact(subject.first, *subject.second, how)
                                       : analyse(subject.first, how);
    // From where the surface's coordinates are counted to those of its file.
    move(timeline, subject.first.surface.field->origin.point);
    return timeline;
}

} // namespace isomotion::topology
