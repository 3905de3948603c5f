// What `topology` searches: one surface, or what two surfaces of a scene have in common.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "topology/subject.h"

namespace isomotion::app {

using topology::Subject;

// The surface that is named, or the two of `contact`; the only surface if neither is. Throws
// SceneError for unknown names, and std::invalid_argument for two equal ones.
Subject subject_of(const scene::Scene& scene, const std::string& surface,
                   const std::vector<std::string>& contact);

// Which side of a surface is the solid, as `--solid` says: SIDE for each surface, or NAME=SIDE for
// one of several.
struct SolidChoice {
    std::string surface; // empty: each
    topology::Side side;
};
// Throws std::invalid_argument for other words, and SceneError for unknown names.
std::vector<SolidChoice> parse_solids(const std::vector<std::string>& texts,
                                      const scene::Scene& scene);

// Throws std::invalid_argument if a choice names a surface that the subject has not.
void expect_searched(const Subject& subject, const std::vector<SolidChoice>& choices);

// The solids of the subject's surfaces: the last choice that names the surface, otherwise the last
// that is for each, otherwise what topology::solid_side() says. A subject of one surface has it
// twice.
std::array<topology::Side, 2> solids_of(const Subject& subject,
                                        const std::vector<SolidChoice>& choices);
// A line for each solid that is {F > 0}; empty if there is none.
std::string solid_text(const Subject& subject, const std::array<topology::Side, 2>& solids);

// When and where two surfaces touch, in the world's coordinates.
std::string contact_text(const Subject& subject, const topology::TimelineRecord& record);

} // namespace isomotion::app
