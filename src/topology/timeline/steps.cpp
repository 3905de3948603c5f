#include "topology/timeline/steps.h"

#include <algorithm>

namespace isomotion::topology {
namespace {

std::vector<Instant> instants_of(const Timeline& timeline) {
    std::vector<Instant> single;
    for (std::size_t k = 0; k < timeline.events.size(); ++k) {
        if (timeline.events[k].kind == Kind::none) continue;
        single.push_back({timeline.events[k].time, {k}, {}});
    }
    for (std::size_t k = 0; k < timeline.unresolved.size(); ++k) {
        single.push_back({timeline.unresolved[k].time, {}, {k}});
    }
    std::ranges::stable_sort(single, {}, [](const Instant& instant) { return instant.time.lo; });
    std::vector<Instant> merged;
    for (Instant& instant : single) {
        if (merged.empty() || merged.back().time.hi < instant.time.lo) {
            merged.push_back(std::move(instant));
            continue;
        }
        Instant& last = merged.back();
        last.time = formula::hull(last.time, instant.time);
        last.events.insert(last.events.end(), instant.events.begin(), instant.events.end());
        last.unresolved.insert(last.unresolved.end(), instant.unresolved.begin(),
                               instant.unresolved.end());
    }
    for (Instant& instant : merged) std::ranges::sort(instant.events); // the timeline's own order
    return merged;
}

// The numbers before the first event of an instant, and those after the last. Numbers follow from
// event to event in the order of the list, whatever the enclosures of the times: numbers between
// two events of an instant are not at its ends. Where that event has none, an unresolved place says
// what is before or after all of the instant.
std::optional<Betti> before(const Timeline& timeline, const Instant& instant) {
    if (!instant.events.empty()) {
        if (const auto& found = timeline.events[instant.events.front()].before) return found;
    }
    std::optional<Betti> found;
    double first = formula::infinity;
    for (const std::size_t k : instant.unresolved) {
        const Unresolved& place = timeline.unresolved[k];
        if (!place.before || place.time.lo >= first) continue;
        found = place.before;
        first = place.time.lo;
    }
    return found;
}

std::optional<Betti> after(const Timeline& timeline, const Instant& instant) {
    if (!instant.events.empty()) {
        if (const auto& found = timeline.events[instant.events.back()].after) return found;
    }
    std::optional<Betti> found;
    double last = -formula::infinity;
    for (const std::size_t k : instant.unresolved) {
        const Unresolved& place = timeline.unresolved[k];
        if (!place.after || place.time.hi < last) continue;
        found = place.after;
        last = place.time.hi;
    }
    return found;
}

// What the instant's events change together; empty if some are of unknown kind.
std::optional<Betti> change(const Timeline& timeline, const Instant& instant) {
    if (!instant.unresolved.empty()) return std::nullopt;
    Betti all;
    for (const std::size_t k : instant.events) {
        if (timeline.events[k].kind == Kind::unknown) return std::nullopt;
        all = all + change(timeline.events[k].kind);
    }
    return all;
}

// Whether it is known what happens in the instant, and that it happens in the range. Where an
// enclosure reaches over an end of the range, the event may be on either side.
bool is_certain(const Timeline& timeline, const Instant& instant) {
    return instant.unresolved.empty() && formula::contains(timeline.range, instant.time) &&
           std::ranges::all_of(instant.events, [&](const std::size_t k) {
               return timeline.events[k].is_proved && timeline.events[k].kind != Kind::unknown;
           });
}

void mark_proved(const Timeline& timeline, Steps& all) {
    auto& steps = all.steps;
    // Across an instant a proof reaches only as far as the numbers on both sides agree.
    const auto leads = [&](std::size_t k) {
        const auto add = change(timeline, all.instants[k]);
        return add && steps[k].solid && steps[k + 1].solid &&
               *steps[k].solid + *add == *steps[k + 1].solid &&
               is_certain(timeline, all.instants[k]);
    };
    // Where nothing happens, both ends speak of one step.
    const bool agree =
        steps.size() > 1 || !timeline.start || !timeline.end || timeline.start == timeline.end;
    steps.front().is_proved = timeline.start_is_proved && timeline.start && agree;
    steps.back().is_proved |= timeline.end_is_proved && timeline.end && agree;
    if (!timeline.is_proved || !timeline.doubts.empty()) {
        // Between the ends there may be events that nobody found: only the ends themselves hold.
        for (Step* step : {&steps.front(), &steps.back()}) step->is_proved = false;
        return;
    }
    for (std::size_t k = 0; k < all.instants.size(); ++k) {
        steps[k + 1].is_proved |= steps[k].is_proved && leads(k);
    }
    for (std::size_t k = all.instants.size(); k-- > 0;) {
        steps[k].is_proved |= steps[k + 1].is_proved && leads(k);
    }
}

} // namespace

const Step* Steps::at(double time) const {
    const auto found = std::ranges::find_if(
        steps, [&](const Step& step) { return formula::contains(step.time, time); });
    if (found == steps.end()) return nullptr;
    // A step ends where an instant's enclosure begins: that instant may be the event's.
    const auto in = [&](const Instant& instant) { return formula::contains(instant.time, time); };
    return std::ranges::any_of(instants, in) ? nullptr : &*found;
}

Steps steps_of(const Timeline& timeline) {
    Steps all;
    all.instants = instants_of(timeline);
    const std::size_t count = all.instants.size();
    all.steps.resize(count + 1);
    double begin = timeline.range.lo;
    for (std::size_t k = 0; k <= count; ++k) {
        const auto within = [&](double time) { return std::clamp(time, begin, timeline.range.hi); };
        const double end = k < count ? within(all.instants[k].time.lo) : timeline.range.hi;
        all.steps[k].time = {begin, end};
        if (k < count) begin = within(all.instants[k].time.hi);
    }
    all.steps.front().solid = timeline.start;
    for (std::size_t k = 0; k < count; ++k) {
        auto& here = all.steps[k].solid;
        auto& next = all.steps[k + 1].solid;
        if (!here) here = before(timeline, all.instants[k]);
        next = after(timeline, all.instants[k]);
        if (const auto add = change(timeline, all.instants[k]); !next && here && add) {
            next = *here + *add;
        }
        if (next && !next->is_possible()) next.reset();
    }
    // The end's own number stands for the end, whatever the last event says that it leaves.
    if (timeline.end && (count > 0 || !all.steps.back().solid)) {
        all.steps.back().solid = timeline.end;
    }
    mark_proved(timeline, all);
    return all;
}

} // namespace isomotion::topology
