// Notices over the picture: progress, errors, help.
#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace isomotion::player {

class Notices {
public:
    std::string load_error; // of the scene file; the last good scene stays in view
    std::string draw_error; // of a shader or a value
    bool help = false;

    // `compiling`: the start time of the compilation in progress.
    void show(std::optional<std::chrono::steady_clock::time_point> compiling);

private:
    void show_error(const std::string& text);
    void show_progress(double seconds);
    void show_help();
};

} // namespace isomotion::player
