#include "topology/subject.h"

#include <fmt/format.h>

#include "scene/surfaces.h"

namespace isomotion::topology {

Subject pair_of(const scene::Scene& scene, int first, int second) {
    const std::vector<std::string> names = scene::surface_names(scene);
    return {scene::alone(scene, first), scene::alone(scene, second),
            fmt::format("{} ({}, {})", scene.title, names[std::size_t(first)],
                        names[std::size_t(second)])};
}

TimelineHeader header_of(const Subject& subject, formula::Interval range) {
    return subject.second ? header_of_contact(subject.first, *subject.second, subject.title, range)
                          : header_of(subject.first, range);
}

Timeline analyse(const Subject& subject, const AnalyseOptions& how) {
    return subject.second ? analyse_contact(subject.first, *subject.second, how)
                          : analyse(subject.first, how);
}

} // namespace isomotion::topology
