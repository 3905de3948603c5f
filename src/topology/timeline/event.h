// The events of an animation in order: changes in the topology of its surface, with their times.
//
// The solid is where F has the sign that it doesn't have on the bounds (solid.h); below it is {F <
// 0}, and for the other sign F means -F. An event is a point (x, y, z, t) with F = 0 and grad F =
// 0. There the solid gains or loses a handle of the critical point's Morse index (Milnor 1963; Hart
// 1998; Stander and Hart 1997). On a face, an edge or at a corner of the bounds the gradient is
// that along the face or the edge (stratified Morse theory). `stratum` counts the free coordinates.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formula/interval/interval.h"
#include "topology/timeline/betti.h"

namespace isomotion::topology {

enum class Kind {
    unknown, // not determined: see Event::kind_proof
    birth,
    death,
    merge,
    split,
    tunnel_forms,
    tunnel_closes,
    tunnel_opens,
    tunnel_breaks,
    void_forms,
    void_fills,
    void_opens,
    void_born,
    none, // on the bounds, where the capped solid does not change
};

std::string_view name(Kind kind); // "tunnel forms"
std::optional<Kind> parse_kind(std::string_view text);

// The change that an event of this kind makes to the solid's Betti numbers.
Betti change(Kind kind);

// The kinds that a critical point may have by its index (0 to 3) and direction: one or two.
// `grows`: F falls in time there, and the solid gains a handle.
std::vector<Kind> kinds_of(int index, bool grows);

struct Event {
    formula::Interval time;                 // seconds; holds the exact time
    std::array<formula::Interval, 3> where; // formula coordinates; hold the exact point
    int stratum = 3;                        // 3: inside; 2, 1, 0: on a face, an edge, a corner
    int index = 0;                          // of F along the stratum
    bool grows = false;
    Kind kind = Kind::unknown;
    // Proved: its existence, index and direction, and that it is alone in the box of coordinates
    // and clock that it was found in. `time` and `where` are a hull of that box and may hold more.
    bool is_proved = false;
    // Proved in another arithmetic (arb_verifier.h): its existence, index and direction, and that
    // it is alone in `time` and `where`.
    bool is_proved_again = false;
    // How the kind was determined: "index", "path", "counting", "frames"; empty if it wasn't.
    // "together": only the number of events of this kind at its time is known, not that this event
    // is one of them.
    std::string kind_proof;
    std::optional<Betti> before, after; // of the solid; empty where unknown

    bool operator==(const Event&) const = default;
};

// Whether the kinds of the two are known only together, and may be the other way round.
bool are_interchangeable(const Event& a, const Event& b);

// The change that the event makes to the solid's Euler number b0 - b1 + b2, whatever its kind:
// (-1)^index if it grows, the negative of that if it shrinks.
int euler_change(const Event& event);

// A place where events may be that could not be resolved: a degenerate critical point, a singular
// curve. It never has a kind.
struct Unresolved {
    formula::Interval time;
    std::array<formula::Interval, 3> where;
    std::string why;
    std::optional<Betti> before, after;

    bool operator==(const Unresolved&) const = default;
};

// How many spans between events were counted again, at one time each, by a way that shares no code
// with the one that told their numbers (classify/recount.h).
struct Recount {
    int spans = 0;
    int agree = 0; // of the others nothing is known: too short to be asked, or finer than grids

    bool operator==(const Recount&) const = default;
};

// Everything known of an animation from one time to another.
struct Timeline {
    formula::Interval range;            // of time, seconds
    std::vector<Event> events;          // by time
    std::vector<Unresolved> unresolved; // by time
    std::optional<Betti> start, end;    // of the solid
    bool start_is_proved = false, end_is_proved = false;
    bool is_proved = false; // no event is missing; each event states whether it is proved itself
    Recount recount{};
    std::vector<std::string> doubts; // failed consistency checks and interruptions, in words
    // Whether everything is proved: no event is missing, each is proved and its kind known, both
    // ends are proved, and there are no doubts.
    bool is_complete() const;
    bool operator==(const Timeline&) const = default;
};

// A place moved by a vector; and all places of a timeline.
std::array<formula::Interval, 3> moved(std::array<formula::Interval, 3> where,
                                       const std::array<double, 3>& by);
void move(Timeline& timeline, const std::array<double, 3>& by);

} // namespace isomotion::topology
