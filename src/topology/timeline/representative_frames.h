// Chooses the few frames of an animation that show most of its topology.
#pragma once

#include <vector>

#include "topology/timeline/timeline_header.h"

namespace isomotion::topology {

// At most `most` frames, ascending, each in the middle of a quiet span between events. First come
// the first and the last span, then always the span whose Betti numbers differ most from those
// chosen and that lasts longest (farthest-point sampling, weighted). If no Betti numbers are known,
// the frames are spread over the range.
std::vector<double> representative_frames(const TimelineRecord& record, std::size_t most);

} // namespace isomotion::topology
