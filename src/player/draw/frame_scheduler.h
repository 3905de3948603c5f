// Decides which picture to request next: one that keeps up while something changes, then a better
// one.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include <glm/glm.hpp>

#include "player/draw/draw_thread.h"
#include "player/draw/resolution_controller.h"
#include "player/model/session.h"

namespace isomotion::player {

// The largest size of this aspect within an area, pixels.
glm::ivec2 fitted_size(glm::ivec2 area, double aspect);

// Requests a session's pictures from a DrawThread.
class FrameScheduler {
public:
    explicit FrameScheduler(DrawThread& thread)
        : thread_(thread) {}

    // A scene was opened or read again: the cost of a draw is unknown.
    void begin_scene();

    // Requests what `session` shows at `frame` in a picture of `size`, unless that is requested
    // already: as large as keeps `rate` pictures a second and, once nothing has changed for a
    // moment, whole; where that takes long, in steps of twice the width and height. `hand_rests`:
    // no mouse button is held. Changes wait for the picture in flight and are merged into the next
    // request: two processors that draw pictures and the window in turn are done sooner, and the
    // picture is newer, than if both were drawn at once. Throws scene::SceneError where a value
    // leaves its range at this frame.
    void ask(Session& session, std::int64_t frame, glm::ivec2 size, double now, bool hand_rests);
    // A picture came, or was given up. It takes `display` seconds in the mean to get to the screen.
    void learn(const Shown& shown, double display, double now);
    void learn(const GivenUp& picture, double now);
    // When to call ask() again though nothing has happened, in seconds of `now`; none where it
    // would request nothing.
    std::optional<double> next_change() const;

    // Whether the last picture requested is whole and has come.
    bool at_rest() const { return whole_ && came_; }
    // Whether a request is in flight.
    bool awaits() const { return subject_ && !came_; }
    std::uint64_t number() const { return number_; } // of the last request, also one that failed

    static constexpr double rate = 30;

private:
    struct Subject {
        std::uint64_t revision = 0;
        std::int64_t frame = 0;
        glm::ivec2 size{0};
        bool operator==(const Subject&) const = default;
    };

    double next_scale(int samples) const;
    void post(const Session& session, double scale, int samples, bool may_be_dropped, double now);
    bool holds_back(double now) const;

    DrawThread& thread_;
    ResolutionController resolution_;
    std::optional<Subject> subject_; // of the last request
    std::optional<Subject> wanted_;  // what it should be
    std::uint64_t number_ = 0;       // of the last request
    std::uint64_t begin_ = 1;        // of this scene's first request
    double scale_ = 1;               // of the last request
    bool grows_ = false;             // it is larger than what keeps up
    bool whole_ = false, came_ = false, hand_rests_ = true;
    double changed_ = 0, posted_ = 0;
    std::optional<std::chrono::steady_clock::time_point>
        noticed_; // the first change not yet requested
};

} // namespace isomotion::player
