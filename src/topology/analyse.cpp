#include "topology/analyse.h"

namespace isomotion::topology {

// Nothing is searched yet: what is known is the range.
Timeline analyse(const scene::Scene& scene, const Analysing& how) {
    const int last = how.last == 0 ? scene.timeline.frames : how.last;
    Timeline timeline;
    timeline.range = {scene.timeline.time(how.first), scene.timeline.time(last)};
    timeline.doubts.push_back("nothing was searched");
    if (how.stop && how.stop()) timeline.doubts.push_back("interrupted");
    return timeline;
}

} // namespace isomotion::topology
