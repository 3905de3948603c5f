#include "topology/subject.h"

#include <fmt/format.h>

#include "scene/scene_at.h"
#include "scene/surfaces.h"
#include "scene/unbounded.h"

namespace isomotion::topology {

Subject pair_of(const scene::Scene& scene, int first, int second) {
    const std::vector<std::string> names = scene::surface_names(scene);
    return {scene::alone(scene, first), scene::alone(scene, second),
            fmt::format("{} ({}, {})", scene.title, names[std::size_t(first)],
                        names[std::size_t(second)])};
}

TimelineHeader header_of(const Subject& subject, formula::Interval range,
                         const std::array<Side, 2>& solids) {
    TimelineHeader header =
        subject.second ? header_of_contact(subject.first, *subject.second, subject.title, range)
                       : header_of(subject.first, range);
    for (std::size_t k = 0; k < (subject.second ? 2u : 1u); ++k)
        header.solids.push_back(solids[k] == Side::positive ? 1 : -1);
    return header;
}

std::vector<std::string> why_unbounded(const Subject& subject, int frame) {
    std::vector<std::string> reasons;
    const auto look_at = [&](const scene::Scene& scene) {
        const scene::SceneAt now = scene::at_frame(scene, frame);
        if (auto why = scene::why_unbounded(scene, now)) reasons.push_back(std::move(*why));
    };
    look_at(subject.first);
    if (subject.second) look_at(*subject.second);
    return reasons;
}

Timeline analyse(const Subject& subject, const AnalyseOptions& how) {
    return subject.second ? analyse_contact(subject.first, *subject.second, how)
                          : analyse(subject.first, how);
}

} // namespace isomotion::topology
