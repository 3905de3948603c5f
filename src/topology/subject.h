// What a timeline is about: one surface, or what two surfaces of a scene have in common.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "topology/analyse.h"
#include "topology/field/solid.h"
#include "topology/timeline/timeline_header.h"

namespace isomotion::topology {

// The scene must outlive it.
struct Subject {
    scene::OneSurface first;
    std::optional<scene::OneSurface> second;
    std::string title;
};

// The surface or the pair of surfaces with these indices in the scene.
Subject subject_of(const scene::Scene& scene, std::size_t first,
                   std::optional<std::size_t> second = {});

// `solids`: of both surfaces; a subject of one surface has it twice.
TimelineHeader header_of(const Subject& subject, formula::Interval range,
                         const std::array<Side, 2>& solids);
// Why F has no bounds at a frame, for each surface of which that is so.
std::vector<std::string> why_unbounded(const Subject& subject, int frame);
Timeline analyse(const Subject& subject, const AnalyseOptions& how);

} // namespace isomotion::topology
