// A line on a terminal that shows the progress of a sequence; silent if the output isn't a
// terminal.
#pragma once

#include <chrono>
#include <string>

namespace isomotion::app {

// "12 s", "3 minutes".
std::string duration(double seconds);

class Progress {
public:
    Progress(std::string what, int total, bool quiet);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    // `done` of the total, in parts too.
    void show(double done, const std::string& note = {});

    // Prints a message of its own on stderr, above the line.
    void tell(const std::string& text);

private:
    std::string what_;
    int total_;
    bool terminal_;
    bool drawn_ = false;
    std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

} // namespace isomotion::app
