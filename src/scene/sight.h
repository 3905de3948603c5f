// What keeps a scene from showing what its author meant, told before anybody looks at a picture.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/scene_at.h"

namespace isomotion::scene {

// How F lies in the bounds.
struct Sight {
    // All of F, where intervals show that it has no zero within the bounds.
    std::optional<formula::Interval> values;
    bool changes_sign = false;  // at some points
    double least = 0, most = 0; // at those points
    // The part of the bounds' faces on which F has the sign that most of them do not: there the
    // surface is cut open.
    double cut = 0;
    // Bounds so many times as large would cut nothing, though these do. Not told of surfaces with a
    // colour for the other side: they are to be seen from there.
    std::optional<double> closed_by;
    bool is_cut_away = false;  // sections leave none of the solid F < 0 at these points
    bool eye_in_solid = false; // where F has that sign; not told where a surface has no end
};

Sight sight(const Scene& scene, const SceneAt& now);

// For a frame without a hit.
std::string why_nothing_is_seen(const Sight& sight);
// What is likely a slip: an eye in the solid; a closed surface that sticks out of its bounds.
std::vector<std::string> slips(const Sight& sight);

} // namespace isomotion::scene
