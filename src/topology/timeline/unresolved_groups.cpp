#include "topology/timeline/unresolved_groups.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "topology/timeline/words.h"

namespace isomotion::topology {
namespace {

using formula::Interval;

// A group within this part of the whole time from an end is at that end.
constexpr double least_part = 1e-3;

bool touch(const Interval& a, const Interval& b) { return a.lo <= b.hi && b.lo <= a.hi; }

Interval within(const Interval& time, const Interval& range) {
    return {std::clamp(time.lo, range.lo, range.hi), std::clamp(time.hi, range.lo, range.hi)};
}

} // namespace

std::vector<UnresolvedGroup> unresolved_groups(const Timeline& timeline) {
    std::vector<UnresolvedGroup> groups;
    for (const Unresolved& place : timeline.unresolved) {
        UnresolvedGroup joined{place.time, {&place}};
        const auto belongs = [&](const UnresolvedGroup& group) {
            const Unresolved& first = *group.places.front();
            return first.why == place.why && first.before == place.before &&
                   first.after == place.after && touch(group.time, joined.time);
        };
        // It may join several that did not touch.
        for (auto at = std::ranges::find_if(groups, belongs); at != groups.end();
             at = std::ranges::find_if(groups, belongs)) {
            joined.time = {std::min(at->time.lo, joined.time.lo),
                           std::max(at->time.hi, joined.time.hi)};
            joined.places.insert(joined.places.begin(), at->places.begin(), at->places.end());
            groups.erase(at);
        }
        groups.push_back(std::move(joined));
    }
    std::ranges::stable_sort(groups, {},
                             [](const UnresolvedGroup& group) { return group.time.lo; });
    return groups;
}

When when(const UnresolvedGroup& group, const Timeline& timeline) {
    const Interval range = timeline.range;
    const double little = least_part * (range.hi - range.lo);
    const bool at_start = group.time.lo <= range.lo + little,
               at_end = group.time.hi >= range.hi - little;
    if (at_start && at_end) return When::always;
    return at_start ? When::at_start : at_end ? When::at_end : When::between;
}

std::string place_text(const std::array<Interval, 3>& where) {
    double size = 0;
    for (const Interval& x : where) size = std::max(size, std::abs(mid(x)));
    const auto text = [&](const Interval& x) {
        const bool may_be_0 = x.lo <= 0 && x.hi >= 0 && x.hi - x.lo < 1e-3 * std::max(size, 1.0);
        return may_be_0 || std::abs(mid(x)) < 1e-12 * size ? 0.0 : mid(x);
    };
    return fmt::format("({:.4g}, {:.4g}, {:.4g})", text(where[0]), text(where[1]), text(where[2]));
}

std::string places_text(const UnresolvedGroup& group) {
    constexpr std::size_t most_named = 3;
    std::vector<std::string> named;
    for (const Unresolved* place : group.places) {
        const std::string text = place_text(place->where);
        if (named.size() < most_named && std::ranges::find(named, text) == named.end())
            named.push_back(text);
    }
    if (group.places.size() == 1) return "near " + named[0];
    return fmt::format("at {} places, near {}{}", group.places.size(), fmt::join(named, ", "),
                       group.places.size() > named.size() ? ", ..." : "");
}

std::string spans_beside(const std::vector<UnresolvedGroup>& groups, const Timeline& timeline,
                         animation::FrameRate fps) {
    constexpr std::size_t most_spans = 4;
    constexpr double least_apart = 1e-3; // of a frame: closer, its surface is as good as singular
    std::vector<Interval> moments;
    for (const UnresolvedGroup& group : groups) {
        if (when(group, timeline) == When::always) return "";
        moments.push_back(frames_at(fps, within(group.time, timeline.range)));
    }
    if (moments.empty()) return "";
    std::ranges::sort(moments, {}, &Interval::lo);
    const double last = std::round(frame_at(fps, timeline.range.hi));
    double from = std::round(frame_at(fps, timeline.range.lo));
    std::vector<std::string> spans;
    const auto add = [&](double to) {
        if (to > from) spans.push_back(fmt::format("{:.0f}-{:.0f}", from, to));
    };
    for (const Interval& moment : moments) {
        add(std::min(last, std::ceil(moment.lo - least_apart) - 1));
        from = std::max(from, std::floor(moment.hi + least_apart) + 1);
    }
    add(last);
    if (spans.size() > most_spans) {
        spans.resize(most_spans);
        spans.emplace_back("so on");
    }
    return fmt::format("{}", fmt::join(spans, spans.size() == 2 ? " and " : ", "));
}

} // namespace isomotion::topology
