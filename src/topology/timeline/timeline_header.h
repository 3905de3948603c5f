// Identity of the analysed scene.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "animation/timeline.h"
#include "formula/interval/interval.h"
#include "scene/scene.h"
#include "topology/timeline/event.h"

namespace isomotion::topology {

struct TimelineHeader {
    using Box = std::array<formula::Interval, 3>;

    std::string title;
    // Changes with everything that determines topology: the formula, the sources of its parameters
    // and elements, the bounds. Cameras, lights, materials, placement and frame rate don't count.
    std::string fingerprint;
    animation::FrameRate fps;
    scene::Bounds::Shape shape = scene::Bounds::Shape::box;
    Box start_bounds{}, end_bounds{}; // formula coordinates; for a sphere the box around it
    // The sign of F in the solid: -1 or 1, of both surfaces of a contact. Empty where it is not
    // known, as of files of former versions.
    std::vector<int> solids;

    bool operator==(const TimelineHeader&) const = default;
};

// A timeline with the identity of its scene, as a file holds it.
struct TimelineRecord {
    TimelineHeader header;
    Timeline timeline;

    bool operator==(const TimelineRecord&) const = default;
};

std::string fingerprint(const scene::OneSurface& one);

// The bounds are those at the ends of `range` (seconds). Throws SceneError if values are out of
// their range there.
TimelineHeader header_of(const scene::OneSurface& one, formula::Interval range);

// The same of what two surfaces have in common (analyse_contact), with the title of both. Here
// placements count; the bounds are the first one's.
TimelineHeader header_of_contact(const scene::OneSurface& first, const scene::OneSurface& second,
                                 std::string title, formula::Interval range);

} // namespace isomotion::topology
