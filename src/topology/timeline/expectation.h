// An expectation of an animation's topology: a timeline kept from an earlier run, or the claims of
// a person in a few lines of JSON or TOML:
//
//     { "components": { "1": 75, "end": 1 },      at these frames; "5..9": at all frames from 5 on
//       "tunnels": { "40.5": 2 }, "voids": {...},
//       "events": ["merge at frame 12..13", "no split", "nothing else"],      see statement.h
//       "tolerance": 2 }                          frames around each lone frame of an event
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "topology/timeline/check.h"
#include "topology/timeline/statement.h"
#include "topology/timeline/timeline_header.h"

namespace isomotion::topology {

// The claim that one of the solid's Betti numbers is `value` at all these frames.
struct BettiClaim {
    std::string key; // "components.5..9"
    int Betti::*number = &Betti::components;
    formula::Interval frames; // infinite ends stand for those of the frames searched
    int value = 0;
};

struct Claims {
    std::vector<BettiClaim> betti;
    std::vector<Statement> events;
};

using Expectation = std::variant<TimelineRecord, Claims>;

// Throws base::InputError: "expected.json: events[2]: there is no event 'mege'; did you mean
// 'merge'?" Frames of a person's claims are at `fps`.
Expectation read_expectation(const std::filesystem::path& file, animation::FrameRate fps);
Claims parse_claims(std::string_view text, const std::string& file, animation::FrameRate fps);

Check check(const Claims& claims, const TimelineRecord& found);
// `dt`: the number of seconds by which events may have moved from those of a record. Throws
// std::invalid_argument if it is negative or not finite.
Check check(const Expectation& expectation, const TimelineRecord& found, double dt = 1e-9);

// For the terminal: the differences, the undecided points, the verdict.
std::string text(const Check& check, const std::string& file);

} // namespace isomotion::topology
