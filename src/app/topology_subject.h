// What `topology` searches: one surface, or what two surfaces of a scene have in common.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "topology/analyse.h"
#include "topology/timeline/timeline_header.h"

namespace isomotion::app {

struct Subject {
    scene::Scene first;
    std::optional<scene::Scene> second;
    std::string title;
};

// The pair of surfaces with these indices in the scene.
Subject pair_of(const scene::Scene& scene, int first, int second);
// The surface that is named, or the two of `contact`; the whole scene if neither is. Throws
// SceneError for unknown names, and std::invalid_argument for two equal ones.
Subject subject_of(const scene::Scene& scene, const std::string& surface,
                   const std::vector<std::string>& contact);

topology::TimelineHeader header_of(const Subject& subject, formula::Interval range);
topology::Timeline analyse(const Subject& subject, const topology::AnalyseOptions& how);

// When and where two surfaces touch, in the world's coordinates.
std::string contact_text(const Subject& subject, const topology::TimelineRecord& record);

} // namespace isomotion::app
