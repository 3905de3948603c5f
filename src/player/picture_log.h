// What was shown, for those who measure it: a line of JSON for each picture.
#pragma once

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>

#include <glm/glm.hpp>

#include "player/draw_thread.h"
#include "player/landmarks.h"

namespace isomotion::player {

class PictureLog {
public:
    // An empty path writes nothing. Throws base::FileError.
    explicit PictureLog(const std::filesystem::path& file);

    // After the picture was sent to the screen: where it is in the window, and whether a better one
    // will follow though nothing changes.
    void add(const Shown& shown, glm::ivec2 corner, glm::ivec2 size, bool at_rest);
    void add_failure(const std::string& text);
    // Where widgets are, if that has changed.
    void add(const Landmarks& landmarks);

private:
    using Clock = std::chrono::steady_clock;

    double seconds(Clock::time_point at) const; // since the program began, about
    void write(const std::string& line);

    Landmarks last_;
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
    const Clock::time_point begin_ = Clock::now();
};

} // namespace isomotion::player
