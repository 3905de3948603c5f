// How long it takes to find the kinds of a scene's events, and how they are proved.
//
//     kinds_bench SCENE FIRST LAST [THREADS] [EVENTS.timeline.json]
//
// LAST is 0 for the scene's last frame.
// The events are kept in the file, so that the search is run once. Times are the processor's, of
// all threads together.
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <map>

#include <fmt/format.h>

#include "scene/reading/load.h"
#include "topology/moving_scene.h"
#include "topology/search/critical.h"
#include "topology/timeline/timeline_file.h"

namespace {

using namespace isomotion;
using namespace isomotion::topology;

double since(std::clock_t start) { return double(std::clock() - start) / CLOCKS_PER_SEC; }

int measure(const scene::Scene& scene, formula::Interval range, int threads,
            const std::filesystem::path& file) {
    const auto now = [] { return std::clock(); };
    const Side side = solid_side(scene);
    TimelineRecord record;
    auto start = now();
    if (std::filesystem::exists(file)) {
        record = read_timeline(file);
    } else {
        EventSearchOptions how;
        how.threads = threads;
        record = {header_of(scene, range), find_events(scene, side, range, how)};
        fmt::print("events     {:8.2f} s\n", since(start));
        if (!file.empty()) std::ofstream(file) << to_json(record);
    }
    Timeline timeline = record.timeline;
    start = now();
    const MovingScene frames(scene, side, range);
    const auto end = [&](double time, std::optional<Betti>& betti, bool& is_proved) {
        const CertifiedFrame frame = frames.certify(time);
        betti = frame.betti;
        is_proved = betti.has_value();
        if (!is_proved) {
            fmt::print("no proof at {} s: {}, ({:.6f}, {:.6f}, {:.6f})\n", time, frame.why,
                       mid(frame.where[0]), mid(frame.where[1]), mid(frame.where[2]));
        }
    };
    end(range.lo, timeline.start, timeline.start_is_proved);
    end(range.hi, timeline.end, timeline.end_is_proved);
    fmt::print("ends       {:8.2f} s\n", since(start));
    PathOptions seeking;
    seeking.threads = threads;
    KindProofs proofs = frames.proofs(timeline.events, seeking);
    const auto paths = proofs.paths;
    proofs.paths = [&](std::span<const std::size_t> which, int effort) {
        const auto begun = now();
        const std::vector<Sides> sides = paths(which, effort);
        std::map<Sides, int> count;
        for (const Sides each : sides) ++count[each];
        fmt::print("  paths    {:8.2f} s: effort {}, {} events, {} joined, {} unknown\n",
                   since(begun), effort, which.size(), count[Sides::joined], count[Sides::unknown]);
        return sides;
    };
    const auto frame = proofs.frame;
    proofs.frame = [&](double time) {
        const auto begun = now();
        const auto betti = frame(time);
        fmt::print("  frame    {:8.2f} s: {}\n", since(begun), betti ? "proved" : "not proved");
        return betti;
    };
    start = now();
    find_kinds(timeline, proofs);
    fmt::print("kinds      {:8.2f} s\n", since(start));
    std::map<std::string, int> count;
    for (const Event& event : timeline.events) ++count[event.kind_proof];
    for (const auto& [proof, events] : count)
        fmt::print("{:4} by {}\n", events, proof.empty() ? "nothing" : proof);
    for (const Event& event : timeline.events) {
        if (event.kind != Kind::unknown) continue;
        fmt::print("unknown at {:.9f} s: index {}, {}, stratum {}, ({:.6f}, {:.6f}, {:.6f})\n",
                   mid(event.time), event.index, event.grows ? "grows" : "shrinks", event.stratum,
                   mid(event.where[0]), mid(event.where[1]), mid(event.where[2]));
    }
    fmt::print("{} unresolved places\n", timeline.unresolved.size());
    for (const std::string& doubt : timeline.doubts) fmt::print("doubt: {}\n", doubt);
    fmt::print("{}\n", timeline.is_complete() ? "complete" : "INCOMPLETE");
    return timeline.is_complete() ? EXIT_SUCCESS : EXIT_FAILURE;
}

} // namespace

int main(int count, char** words) {
    if (count < 4) {
        fmt::print(stderr, "usage: kinds_bench SCENE FIRST LAST [THREADS] [EVENTS]\n");
        return 2;
    }
    const scene::Scene scene = scene::load(words[1]);
    const int last = std::atoi(words[3]) > 0 ? std::atoi(words[3]) : scene.timeline.frames;
    const formula::Interval range{scene.timeline.time(std::atoi(words[2])),
                                  scene.timeline.time(last)};
    return measure(scene, range, count > 4 ? std::atoi(words[4]) : 1, count > 5 ? words[5] : "");
}
