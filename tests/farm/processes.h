// Processes of this machine, found by what they were started with.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace isomotion::farm {

struct Process {
    pid_t id = 0;
    pid_t parent = 0;
    std::string words;       // each ended by a NUL
    std::string environment; // the same
    bool has_word(const std::string& word) const;
};

// The processes that run and may be looked at, except this one.
std::vector<Process> processes(const std::function<bool(const Process&)>& wanted);

// `isomotion render` into a folder.
std::vector<Process> renders_into(const std::string& folder);

} // namespace isomotion::farm
