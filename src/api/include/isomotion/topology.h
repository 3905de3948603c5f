// When parts of a surface merge, split, open and close.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <isomotion/scene.h>

namespace isomotion {

// Betti numbers of a solid.
struct Betti {
    int components = 0, tunnels = 0, voids = 0;
    bool operator==(const Betti&) const = default;
};

struct TopologyEvent {
    std::string kind; // "merge", "split", "tunnel forms", ...; "unknown"
    Interval time;    // seconds; holds the exact time
    Box where;        // holds the exact place
    bool proved = false;
    std::optional<Betti> before, after; // of the solid, where they are known
};

struct Topology {
    std::vector<TopologyEvent> events; // by time
    std::optional<Betti> start, end;
    bool complete = false;           // nothing is missing, and all of it is proved
    std::vector<std::string> doubts; // why it is not complete
    std::string summary;             // some lines for people
    std::string json;                // a timeline file, as `isomotion topology -o` writes it
};

struct TopologySettings {
    enum class Certify { off, fast, full };
    Certify certify = Certify::full;
    // 0: the scene's last frame. Later ones may be searched, too: motions go on.
    int first = 1, last = 0;
    std::string surface = {};                   // of [[surfaces]]
    std::string touching = {};                  // another one: what both have in common
    std::optional<bool> solid_is_negative = {}; // unset: the side that the bounds don't touch
    int threads = 0;                            // 0: as many as the machine runs at once
};

// When parts of the surface merge, split, open and close. A stopped search gives what is known so
// far, with its doubts.
Topology topology_of(const Scene& scene, const TopologySettings& settings = {},
                     const Watcher& watcher = {});

} // namespace isomotion
