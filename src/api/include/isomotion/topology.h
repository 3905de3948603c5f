// When parts of a surface merge, split, open and close.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <isomotion/scene.h>

namespace isomotion {

// Which side of a surface is the solid: that of F < 0, or that of F > 0.
struct Solid {
    std::string surface = {}; // of [[surfaces]]; empty: of the only one, in settings of each
    bool is_negative = true;
    bool operator==(const Solid&) const = default;
};

struct TopologySettings {
    enum class Certify {
        off,  // sample: nothing is proved
        fast, // prove events found from seeds; others may be missing
        full, // prove all that can be
    };
    Certify certify = Certify::full;
    // 0: the scene's last frame. Later ones may be searched, too: motions go on.
    int first = 1, last = 0;
    std::string surface = {};  // of [[surfaces]]
    std::string touching = {}; // another one: what both have in common
    // The last one that names a surface goes before those for each. Of others it is the side that
    // the bounds don't touch at the first frame; F < 0 if they touch both.
    std::vector<Solid> solid = {};
    // Vertices along each side of the grid that `off` and `fast` take signs on; unset: by cost.
    std::optional<int> grid = {};
    int threads = 0; // 0: as many as the machine runs at once
};

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

// Where events may be that could not be resolved.
struct UnresolvedPlace {
    Interval time; // seconds
    Box where;
    std::string why;
    std::optional<Betti> before, after;
};

// What is known of a topology from one frame to another.
struct Topology {
    std::vector<TopologyEvent> events;       // by time
    std::vector<UnresolvedPlace> unresolved; // by time
    std::optional<Betti> start, end;
    bool complete = false;           // nothing is missing, and all of it is proved
    std::vector<std::string> doubts; // why it is not complete
    std::vector<Solid> solids;       // of the surface, or of both that touch

    std::string summary() const; // some lines for people
    // Of two surfaces: some lines on when and where they touch, in the world's coordinates.
    std::string contact() const;
    std::string json() const; // a timeline file, as `isomotion topology -o` writes it
    std::string csv() const;  // Betti numbers, frame by frame: docs/topology.md

    struct Parts; // for isomotion itself
    explicit Topology(std::shared_ptr<const Parts> parts);
    const Parts& parts() const { return *parts_; }

private:
    std::shared_ptr<const Parts> parts_;
};

// The title of what topology_of() searches. Throws for all that can be foreseen to fail before
// minutes of searching.
std::string topology_plan(const Scene& scene, const TopologySettings& settings = {});
// A stopped search gives what is known so far, with its doubts.
Topology topology_of(const Scene& scene, const TopologySettings& settings = {},
                     const Watcher& watcher = {});

struct TopologyCheck {
    enum class Outcome {
        passes,
        differs,
        incomplete, // nothing certainly differs, and something could not be decided
    };
    Outcome outcome = Outcome::incomplete;
    std::vector<std::string> differences, undecided;
    std::size_t agreed = 0; // events or claims
    std::string summary;    // lines for people
};

// What a topology should be: a timeline of an earlier run, or claims of a person in JSON or TOML
// (docs/topology.md).
class Expectation {
public:
    // Frames of claims are at the scene's rate.
    Expectation(const std::filesystem::path& file, const Scene& scene);
    // `dt`: by how many seconds events may have moved from those of an earlier run.
    TopologyCheck check(const Topology& found, double dt = 1e-9) const;

private:
    struct Parts;
    std::shared_ptr<const Parts> parts_;
};

} // namespace isomotion
