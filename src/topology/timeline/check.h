// The result of comparing a timeline with an expectation.
#pragma once

#include <string>
#include <vector>

namespace isomotion::topology {

enum class Outcome {
    passes,
    differs,
    incomplete, // nothing certainly differs, and something could not be decided
};

// Each entry is one line, without its end.
struct Check {
    std::vector<std::string> differences;
    std::vector<std::string> undecided;
    std::vector<std::string> notes; // for information only
    std::size_t agreed = 0;         // events or claims

    Outcome outcome() const {
        if (!differences.empty()) return Outcome::differs;
        return undecided.empty() ? Outcome::passes : Outcome::incomplete;
    }
};

} // namespace isomotion::topology
