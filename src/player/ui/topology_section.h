// The section of the side panel that computes the scene's topology events.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/child_process.h"
#include "player/model/live_scene.h"

namespace isomotion::player {

class TopologySection {
public:
    // `rings`: whether places of events are to be in the picture; a person may change it.
    void show(const LiveScene& scene, bool& rings);
    // Whether `isomotion topology` runs. LiveScene watches the file that it writes.
    bool running() const { return process_.has_value(); }
    void attend();

private:
    void start(const LiveScene& scene);

    std::optional<base::ChildProcess> process_;
    bool cancelled_ = false;
    std::string failure_;
};

} // namespace isomotion::player
