// What is told over the picture: progress, errors, help.
#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace isomotion::player {

class Notices {
public:
    std::string load_error; // of a scene file: the last good scene is still shown
    std::string draw_error; // of a shader or of values
    bool help = false;

    // `compiling`: since when a shader is.
    void show(std::optional<std::chrono::steady_clock::time_point> compiling);

private:
    void show_error(const std::string& text);
    void show_progress(double seconds);
    void show_help();
};

} // namespace isomotion::player
