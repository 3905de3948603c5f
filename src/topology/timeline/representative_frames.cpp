#include "topology/timeline/representative_frames.h"

#include <algorithm>
#include <cmath>

#include "topology/timeline/steps.h"
#include "topology/timeline/words.h"

namespace isomotion::topology {
namespace {

struct QuietSpan {
    Betti solid;
    double middle = 0, part = 0; // seconds; of the whole range
    bool is_chosen = false;
};

// One component more counts for much where there are two, for little where there are eighty.
double distance(const Betti& a, const Betti& b) {
    const auto apart = [](int m, int n) { return std::abs(std::log1p(m) - std::log1p(n)); };
    return apart(a.components, b.components) + apart(a.tunnels, b.tunnels) +
           apart(a.voids, b.voids);
}

// Gain of a span over those chosen; time counts a little, so that a still topology spreads frames.
double gain(const QuietSpan& span, const std::vector<QuietSpan>& spans, double range) {
    double least = 1e300;
    for (const QuietSpan& other : spans) {
        if (!other.is_chosen) continue;
        least = std::min(least, distance(span.solid, other.solid) +
                                    0.2 * std::abs(span.middle - other.middle) / range);
    }
    return least * std::sqrt(span.part);
}

} // namespace

std::vector<double> representative_frames(const TimelineRecord& record, std::size_t most) {
    const formula::Interval range = record.timeline.range;
    const double length = range.hi - range.lo;
    if (most == 0 || !(length > 0)) return {};
    std::vector<QuietSpan> spans;
    for (const Step& step : steps_of(record.timeline).steps) {
        const double part = (step.time.hi - step.time.lo) / length;
        if (step.solid && part > 0) spans.push_back({*step.solid, mid(step.time), part, false});
    }
    std::vector<double> times;
    if (spans.size() < 2) {
        for (std::size_t k = 0; k < most; ++k) {
            times.push_back(range.lo + length * (double(k) + 0.5) / double(most));
        }
    } else {
        spans.front().is_chosen = true;
        if (most > 1) spans.back().is_chosen = true;
        for (std::size_t k = 2; k < std::min(most, spans.size()); ++k) {
            QuietSpan* best = nullptr;
            double largest = 0;
            for (QuietSpan& span : spans) {
                const double g = span.is_chosen ? 0 : gain(span, spans, length);
                if (g <= largest) continue;
                largest = g;
                best = &span;
            }
            if (!best) break;
            best->is_chosen = true;
        }
        for (const QuietSpan& span : spans) {
            if (span.is_chosen) times.push_back(span.middle);
        }
    }
    for (double& time : times) time = frame_at(record.header.fps, time);
    return times;
}

} // namespace isomotion::topology
