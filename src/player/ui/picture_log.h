// Logs each picture shown as a line of JSON, for measurements and tests.
#pragma once

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>

#include <glm/glm.hpp>

#include "player/draw/draw_thread.h"
#include "player/ui/widget_rects.h"

namespace isomotion::player {

class PictureLog {
public:
    // Writes nothing if the path is empty. Throws base::FileError.
    explicit PictureLog(const std::filesystem::path& file);

    // Call it after the picture was sent to the screen. `corner` and `size` are in the window;
    // `at_rest`: no better picture follows while nothing changes.
    void add(const Shown& shown, glm::ivec2 corner, glm::ivec2 size, bool at_rest);
    // Logs an audit's findings on the picture at rest.
    void add(const Audited& audited);
    void add_failure(const std::string& text);
    // Logs the widgets' places if they have changed.
    void add(const WidgetRects& rects);

private:
    using Clock = std::chrono::steady_clock;

    double seconds(Clock::time_point at) const; // since the program started, approximately
    void write(const std::string& line);

    WidgetRects last_;
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
    const Clock::time_point begin_ = Clock::now();
};

} // namespace isomotion::player
