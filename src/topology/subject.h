// What a timeline is about: one surface, or what two surfaces of a scene have in common.
#pragma once

#include <optional>
#include <string>

#include "topology/analyse.h"
#include "topology/timeline/timeline_header.h"

namespace isomotion::topology {

struct Subject {
    scene::Scene first;
    std::optional<scene::Scene> second;
    std::string title;
};

// The pair of surfaces with these indices in the scene.
Subject pair_of(const scene::Scene& scene, int first, int second);

TimelineHeader header_of(const Subject& subject, formula::Interval range);
Timeline analyse(const Subject& subject, const AnalyseOptions& how);

} // namespace isomotion::topology
