// What proved frames of an animation cost, by how far its events are.
//
//     frames_bench SCENE TIMELINE [EVERY]
//
// TIMELINE holds the events (isomotion topology SCENE -o TIMELINE), whose frames are proved; with
// EVERY, each so manieth. Times are the processor's.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>

#include <fmt/format.h>

#include "scene/reading/load.h"
#include "topology/moving_scene.h"
#include "topology/timeline/timeline_file.h"

namespace {

using namespace isomotion;
using namespace isomotion::topology;

double to_nearest(const Timeline& timeline, double time) {
    double nearest = formula::infinity;
    for (const Event& event : timeline.events)
        nearest = std::min(nearest, std::abs(mid(event.time) - time));
    return nearest;
}

} // namespace

int main(int count, char** words) {
    if (count < 3) {
        fmt::print(stderr, "usage: frames_bench SCENE TIMELINE [EVERY]\n");
        return 2;
    }
    setenv("ISOMOTION_DATA", ISOMOTION_SOURCE_DIR, /*overwrite=*/1);
    const scene::Scene scene = scene::load(words[1]);
    const Timeline timeline = read_timeline(words[2]).timeline;
    const MovingScene frames(scene, solid_side(scene), timeline.range);
    double sum = 0;
    int proved = 0, all = 0;
    const int every = count > 3 ? std::max(1, std::atoi(words[3])) : 1;
    for (std::int64_t f = 1; f <= scene.timeline.frames; f += every) {
        const double time = scene.timeline.time(f);
        if (!contains(timeline.range, time)) continue;
        const std::clock_t start = std::clock();
        const CertifiedFrame frame = frames.certify(time);
        const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
        ++all;
        proved += frame.betti.has_value();
        sum += frame.betti ? seconds : 0;
        fmt::print("frame {:4}, {:.1e} s to an event: {:7.2f} s, depth {:2}, {:8} boxes, {}\n", f,
                   to_nearest(timeline, time), seconds, frame.depth, frame.boxes,
                   frame.betti ? "proved" : frame.why);
    }
    fmt::print("{} of {} proved, {:.2f} s each\n", proved, all, sum / std::max(1, proved));
}
