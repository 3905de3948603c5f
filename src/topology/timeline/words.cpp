#include "topology/timeline/words.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "topology/timeline/advice.h"
#include "topology/timeline/unresolved_groups.h"

namespace isomotion::topology {
namespace {

std::string things(int number, std::string_view thing) {
    return fmt::format("{} {}{}", number, thing, number == 1 ? "" : "s");
}

template<class Test> std::int64_t count(const std::vector<Event>& events, Test&& test) {
    return std::ranges::count_if(events, test);
}

} // namespace

std::string plural(Kind kind) {
    const std::string one(name(kind));
    const std::size_t space = one.find(' ');
    if (space == one.npos) return one + "s";
    std::string verb = one.substr(space + 1);
    if (verb.back() == 's') verb.pop_back();
    return one.substr(0, space) + "s " + verb;
}

std::string counted(std::int64_t number, Kind kind) {
    if (kind == Kind::unknown) return fmt::format("{} of unknown kind", number);
    if (kind == Kind::none) return fmt::format("{} on the bounds that change nothing", number);
    return fmt::format("{} {}", number, number == 1 ? std::string(name(kind)) : plural(kind));
}

std::string in_words(const Betti& solid) {
    return fmt::format("{}, {}, {}", things(solid.components, "component"),
                       things(solid.tunnels, "tunnel"), things(solid.voids, "void"));
}

std::string solid_text(int sign) { return sign > 0 ? "F > 0" : "F < 0"; }

double frame_at(animation::FrameRate fps, double time) {
    return 1 + time * double(fps.numerator) / double(fps.denominator);
}

formula::Interval frames_at(animation::FrameRate fps, formula::Interval time) {
    using formula::Interval;
    return Interval(1) + time * Interval(double(fps.numerator)) / Interval(double(fps.denominator));
}

std::string frame_text(double frame) {
    std::string text = fmt::format("{:.4f}", frame);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

std::string frame_text(formula::Interval frames) {
    const std::string lo = frame_text(frames.lo), hi = frame_text(frames.hi);
    if (lo == hi || frames.hi - frames.lo < 1e-4) return frame_text(mid(frames));
    return fmt::format("{} to {}", lo, hi);
}

std::vector<std::string> gaps(const Timeline& timeline, animation::FrameRate fps) {
    std::vector<std::string> reasons = timeline.doubts;
    if (!timeline.is_proved) reasons.emplace_back("it is not proved that no event is missing");
    if (const auto n = count(timeline.events, [](const Event& e) { return !e.is_proved; })) {
        reasons.push_back(fmt::format("{} event{} not proved", n, n == 1 ? " is" : "s are"));
    }
    if (const auto n =
            count(timeline.events, [](const Event& e) { return e.kind == Kind::unknown; })) {
        reasons.push_back(fmt::format("{} event{} of unknown kind", n, n == 1 ? " is" : "s are"));
    }
    for (const UnresolvedGroup& group : unresolved_groups(timeline)) {
        const Unresolved& first = *group.places.front();
        const std::string moment = when(group, timeline) == When::always
                                       ? "at all times"
                                       : "at frame " + frame_text(frames_at(fps, group.time));
        reasons.push_back(
            fmt::format("unresolved {}, {}: {}", moment, places_text(group), first.why));
        if (first.before && first.after && *first.before == *first.after) {
            reasons.back() += fmt::format("; {} before and after", in_words(*first.before));
        } else if (first.before && first.after) {
            reasons.back() += fmt::format("; {} before, {} after", in_words(*first.before),
                                          in_words(*first.after));
        }
    }
    const auto end = [&](const char* which, const char* not_known,
                         const std::optional<Betti>& solid, bool is_proved) {
        const auto says_so = [&](const std::string& doubt) { return doubt.starts_with(not_known); };
        if (!solid) {
            if (std::ranges::none_of(timeline.doubts, says_so)) reasons.emplace_back(not_known);
        } else if (!is_proved) {
            reasons.push_back(fmt::format("the topology at the {} is not proved", which));
        }
    };
    end("start", start_not_known, timeline.start, timeline.start_is_proved);
    end("end", end_not_known, timeline.end, timeline.end_is_proved);
    return reasons;
}

} // namespace isomotion::topology
