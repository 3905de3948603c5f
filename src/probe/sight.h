// Detects why a scene may not show what its author meant, before anybody looks at a picture.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/scene_at.h"

namespace isomotion::probe {

// How F behaves in the bounds.
struct Sight {
    // The range of F, if intervals show that it has no zero within the bounds.
    std::optional<formula::Interval> values;
    std::optional<std::string> unbounded; // by which values F may jump anywhere: unbounded.h
    bool changes_sign = false;            // between sampled points
    double least = 0, most = 0;           // at those points
    // The part of the bounds' faces on which F has the sign that most of them do not have. There
    // the bounds cut the surface open.
    double cut = 0;
    // Bounds so many times as large would cut nothing, though these do. Unset for surfaces with an
    // inner colour, which are meant to be seen open.
    std::optional<double> closed_by;
    bool is_cut_away = false;  // sections leave none of the solid F < 0 at the sampled points
    bool eye_in_solid = false; // where F has that sign; false if a surface extends without end
    // The middle of bounds that lie so far from the origin that floats are too coarse for edges.
    std::optional<glm::dvec3> far_middle;
};

Sight sight(const scene::OneSurface& one, const scene::OneSurfaceAt& now);

// The reason for a frame without a hit.
std::string why_nothing_is_seen(const Sight& sight);
// Likely mistakes: a divisor of 0; an eye in the solid; a closed surface that sticks out of its
// bounds; coordinates far from the origin.
std::vector<std::string> slips(const Sight& sight);

} // namespace isomotion::probe
