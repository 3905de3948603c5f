// The part of the side panel that computes the timeline's marks of topology.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/child_process.h"
#include "player/live_scene.h"

namespace isomotion::player {

class TopologySection {
public:
    void show(const LiveScene& scene);
    // Whether `isomotion topology` runs; it writes the file that the scene is watched with.
    bool running() const { return process_.has_value(); }
    void attend();

private:
    void start(const LiveScene& scene);

    std::optional<base::ChildProcess> process_;
    bool cancelled_ = false;
    std::string failure_;
};

} // namespace isomotion::player
