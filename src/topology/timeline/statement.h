// Parses a person's statement on an animation's events, in words: "merge at frame 12..13".
//
//     statement = [number] events [place] [when] | "nothing else"
//     number    = 3 | "three" | 2..4 | "no" | "a" | "an" | "at least" 3 | "at most" 3
//                                                                      (default: exactly 1)
//     events    = "merge" | "merges" | "tunnel closes" | "tunnels close" | ... | "event" | "events"
//     place     = "inside" | "on the bounds"                           (default: anywhere)
//     when      = "at frame" F ["+-" D] | "at frame" F..F | "between frames" F "and" F |
//                 "before frame" F | "after frame" F                   (default: at any time)
//
// "at time 1.28", "at 1.28 s" and "between 1 s and 2 s" count seconds. "start" and "end" are the
// ends of the range searched: F..end. A lone frame F is as precise as it is written: 12 means 11.5
// to 12.5, 40.2 means 40.15 to 40.25; or it extends D frames before and after. The ends of F..F, of
// "between" and of "+-" are exact (to a millionth of a frame) and included.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "animation/timeline.h"
#include "topology/timeline/event.h"

namespace isomotion::topology {

struct Statement {
    std::string text;
    bool is_nothing_else = false; // no events other than those of the other statements
    int least = 1, most = 1;      // number of events; `most` may be INT_MAX
    std::optional<Kind> kind;     // empty: of any kind
    // Inside the bounds, or on them; unset: either.
    std::optional<bool> is_inside;
    // Frames of the events; an infinite end stands for that of the frames searched.
    formula::Interval frames = formula::Interval::entire();
    // The frames as written: all of them must have been searched.
    formula::Interval asked = formula::Interval::entire();

    bool admits(Kind found) const { return !kind || *kind == found; }
    bool admits_place(const Event& event) const {
        return !is_inside || *is_inside == (event.stratum == 3);
    }
};

// `tolerance` is D, in frames, for lone frames without one of their own. Throws
// std::invalid_argument with what is wrong and what would be right.
Statement parse_statement(std::string_view text, animation::FrameRate fps,
                          std::optional<double> tolerance = {});

enum class Truth { holds, fails, open };

struct Judgement {
    Truth truth = Truth::open;
    std::string why; // what was found instead, or what is missing for a decision
};

// Uses only what the timeline proves. A statement holds only if all frames that it names were
// searched. Kind::none doesn't count as an event.
Judgement judge(const Statement& statement, const std::vector<Statement>& all,
                const Timeline& timeline, animation::FrameRate fps);

} // namespace isomotion::topology
