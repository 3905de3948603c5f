// What a Topology of the public header holds.
#pragma once

#include <optional>

#include "isomotion/topology.h"
#include "topology/timeline/timeline_header.h"

namespace isomotion {

struct Topology::Parts {
    Scene scene; // that was searched
    TopologySettings settings;
    topology::TimelineRecord record;
};

} // namespace isomotion
