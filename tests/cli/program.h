// Runs a program as a shell would, and tells how it ended.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace isomotion::cli {

struct Ending {
    int code = -1;  // what it returned, or -1
    int signal = 0; // what ended it, or 0
    std::string out, err;
};

// For gtest's messages.
std::ostream& operator<<(std::ostream& to, const Ending& ending);

struct Circumstances {
    std::filesystem::path folder = "."; // where it runs
    // Changes to this process's environment; a variable without a value is removed.
    std::map<std::string, std::optional<std::string>> environment = {};
    // Asked often while the program runs; when first true, the signal is sent once.
    std::function<bool(std::chrono::milliseconds running)> interrupt_when = {};
    int interrupt_signal = 0;
};

// The path of isomotion that is tested: ISOMOTION_PROGRAM of the environment where it is set, which
// is how a program with sanitizers is tried by tests of another build; else what `built` says, the
// build's own.
std::string tested_program(const char* built);

// `arguments` starts with the program's path. A program that runs for minutes is killed.
Ending run(const std::vector<std::string>& arguments, const Circumstances& circumstances);

} // namespace isomotion::cli
