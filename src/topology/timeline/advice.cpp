#include "topology/timeline/advice.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "topology/timeline/unresolved_groups.h"
#include "topology/timeline/words.h"

namespace isomotion::topology {
namespace {

struct Advice {
    std::string_view why; // of an unresolved place
    const char* words;
};

// spans_beside() says which places another search settles.
constexpr Advice of_places[] = {
    {unresolved::kink,
     "write smoothmin(a, b, k) for min(a, b), -smoothmin(-a, -b, k) for max(a, b) and sqrt(q + "
     "k^2) for sqrt(q) or abs: events of smooth surfaces are proved"},
    {unresolved::kinks_meet,
     "where faces meet that are parallel, or more than three at a point, turn one body by a little "
     "or move it: bodies that touch at one point are proved; or write smoothmin(a, b, k) for "
     "min(a, b); multiply out what divides by 0, or take bounds without that place"},
    {unresolved::degenerate,
     "the surface may be singular along a curve, or several singular points may be one: a small "
     "term such as + 0.001*x + 0.002*y - 0.0015*z after the formula parts them, and each event is "
     "proved"},
    {unresolved::along_curve,
     "a small term such as + 0.001*x + 0.002*y - 0.0015*z after the formula leaves points of the "
     "curve, and each event is proved; where the curve is in a wall of the bounds, take others, a "
     "little larger or smaller"},
    {unresolved::along_surface,
     "a small term such as + 0.001*x + 0.002*y - 0.0015*z after the formula leaves points, and "
     "each event is proved"},
    {unresolved::lasting_point,
     "what is singular at all times has no moment: a small number after the formula, + 0.001 or - "
     "0.001, opens or closes all such points, and each event is proved"},
    {unresolved::lasting_curve,
     "what is singular at all times has no moment: a small number after the formula, + 0.001 or - "
     "0.001, opens or closes all along the curve, and each event is proved"},
    {unresolved::index,
     "the surface may be singular along a curve: a small term such as + 0.001*x + 0.002*y - "
     "0.0015*z after the formula leaves points of it, and each event is proved"},
    {unresolved::on_edge,
     "take other bounds, a little larger or smaller, or moved; where a whole edge is reached at "
     "once, "
     "a small term such as + 0.001*x + 0.002*y - 0.0015*z after the formula parts the events"},
    {unresolved::touches_edge,
     "take other bounds, a little larger or smaller, or moved; where a whole edge is reached at "
     "once, "
     "a small term such as + 0.001*x + 0.002*y - 0.0015*z after the formula parts the events"},
    {unresolved::rule_changes, "put no key at that moment"},
    {unresolved::rests,
     "let the motion pass that moment without resting: another key, or ease = \"linear\""},
    {unresolved::jumps, "let the motion go from one shape to the other without a jump"},
    {unresolved::no_bounds, "give bounds that hold something at all times"},
};

bool is_interrupted(const Timeline& timeline) {
    return std::ranges::any_of(timeline.doubts, [](const std::string& doubt) {
        return doubt.find("interrupted") != doubt.npos;
    });
}

// What the first event of unknown kind needs; empty if nothing is known to help.
std::string for_unknown_kinds(const Timeline& timeline, animation::FrameRate fps) {
    const auto first = std::ranges::find(timeline.events, Kind::unknown, &Event::kind);
    const double frame = mid(frames_at(fps, first->time));
    const auto at_once = std::ranges::count_if(timeline.events, [&](const Event& event) {
        return event.time.lo <= first->time.hi && event.time.hi >= first->time.lo;
    });
    if (at_once > 1) {
        return fmt::format("{} events at frame {} are at one moment, as symmetry has them, and not "
                           "all of their kinds are told: a body that is moved a little, or a small "
                           "term such as + 0.001*x + 0.002*y - 0.0015*z after the formula, parts "
                           "them",
                           at_once, frame_text(frame));
    }
    // The frames beside it, which are not its own: there the surface is singular.
    constexpr double least_apart = 1e-3;
    const formula::Interval at = frames_at(fps, first->time);
    const double from = std::ceil(at.lo - least_apart) - 1,
                 to = std::floor(at.hi + least_apart) + 1;
    const formula::Interval all(std::round(frame_at(fps, timeline.range.lo)),
                                std::round(frame_at(fps, timeline.range.hi)));
    if (from < all.lo || to > all.hi || (from == all.lo && to == all.hi)) return "";
    return fmt::format("a short span around an event of unknown kind may tell its kind, such as "
                       "--frames {:.0f}-{:.0f}",
                       from, to);
}

} // namespace

std::vector<std::string> advice(const Timeline& timeline, animation::FrameRate fps) {
    std::vector<std::string> found;
    const auto add = [&](std::string_view words) {
        if (std::ranges::find(found, words) == found.end()) found.emplace_back(words);
    };
    const std::vector<UnresolvedGroup> groups = unresolved_groups(timeline);
    const auto is_met = [&](std::string_view why) {
        return std::ranges::any_of(timeline.unresolved,
                                   [&](const Unresolved& place) { return place.why == why; });
    };
    for (const Advice& one : of_places) {
        if (is_met(one.why)) add(one.words);
    }
    const bool turns_between = std::ranges::any_of(groups, [&](const UnresolvedGroup& group) {
        return group.places.front()->why == unresolved::turns &&
               when(group, timeline) == When::between;
    });
    const bool steps = std::ranges::any_of(timeline.doubts, [](const std::string& doubt) {
        return doubt.find("steps from value to value") != doubt.npos;
    });
    if (steps)
        add("let what steps be a parameter with keys, which may jump: jumps of keys are told");
    if (turns_between) add("let the motion pass that moment without turning or resting");
    if (const std::string spans = spans_beside(groups, timeline, fps); !spans.empty())
        add(fmt::format("search beside what is unresolved: --frames {}", spans));
    // What is unresolved says more.
    if (!timeline.unresolved.empty()) return found;
    if (is_interrupted(timeline)) {
        add("let the search run to its end; --frames A-B searches a part, --certify fast takes "
            "about a second");
        return found;
    }
    const auto unknown = std::ranges::find(timeline.events, Kind::unknown, &Event::kind);
    if (unknown != timeline.events.end()) {
        if (const std::string words = for_unknown_kinds(timeline, fps); !words.empty()) add(words);
    }
    if (!timeline.start || !timeline.end) {
        add("begin or end at another frame, --frames A-B: the first and the last are proved where "
            "the surface has no singular point, and nothing too thin for the boxes of the proof; a "
            "small term such as + 0.001*x + 0.002*y - 0.0015*z after the formula makes smooth what "
            "is singular all the time");
    } else if (!timeline.start_is_proved || !timeline.end_is_proved) {
        add("--certify full proves what signs on a grid show");
    }
    return found;
}

} // namespace isomotion::topology
