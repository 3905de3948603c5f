#include "topology/timeline/betti_csv.h"

#include <cmath>

#include <fmt/format.h>

#include "topology/timeline/steps.h"
#include "topology/timeline/words.h"

namespace isomotion::topology {
namespace {

std::string cells(const Betti& b) {
    return fmt::format("{},{},{}", b.components, b.tunnels, b.voids);
}

std::string distance(double frames) {
    return std::isfinite(frames) ? fmt::format("{:.10g}", frames) : "";
}

} // namespace

std::string betti_csv(const TimelineRecord& record) {
    const Steps steps = steps_of(record.timeline);
    const animation::Timeline clock{record.header.fps};
    const formula::Interval range = record.timeline.range;
    std::string text = "frame,b0,b1,b2,surface_b0,surface_b1,surface_b2,proved,to_next_event,"
                       "from_last_event\n";
    auto frame = std::int64_t(std::floor(frame_at(clock.fps, range.lo)));
    for (; clock.time(frame) <= range.hi; ++frame) {
        const double time = clock.time(frame);
        if (time < range.lo) continue;
        double next = formula::infinity, last = formula::infinity;
        for (const Instant& instant : steps.instants) {
            const formula::Interval frames = frames_at(clock.fps, instant.time);
            if (instant.time.hi >= time) next = std::min(next, std::max(0.0, frames.lo - frame));
            if (instant.time.lo <= time) last = std::min(last, std::max(0.0, frame - frames.hi));
        }
        const Step* step = steps.at(time);
        const bool is_known = step && step->solid;
        text += fmt::format("{},{},{},{},{},{}\n", frame, is_known ? cells(*step->solid) : ",,",
                            is_known ? cells(surface_of(*step->solid)) : ",,",
                            is_known && step->is_proved ? 1 : 0, distance(next), distance(last));
    }
    return text;
}

} // namespace isomotion::topology
