// Decides which picture to request next: a fast one while something changes, then a better one.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include <glm/glm.hpp>

#include "player/draw/draw_thread.h"
#include "player/draw/resolution_controller.h"
#include "player/model/session.h"

namespace isomotion::player {

// The largest size with this aspect inside an area, in pixels.
glm::ivec2 fitted_size(glm::ivec2 area, double aspect);

// Requests a session's pictures from a DrawThread.
class FrameScheduler {
public:
    explicit FrameScheduler(DrawThread& thread)
        : thread_(thread) {
        begin_scene();
    }

    // A scene was opened or reloaded, so the cost of a draw is unknown: the next picture is small.
    void begin_scene();

    // Requests the picture of `session` at `frame`, with at most `size`, unless it is requested
    // already. The picture is as large as `rate` pictures per second allow. Once nothing has
    // changed for a moment, it has full size; if that takes long, the size grows in steps of twice
    // the width and height. `hand_rests`: no mouse button is held. One request is in flight; later
    // changes are merged into the next. On two processors this finishes sooner, and with a newer
    // picture, than drawing pictures and the window at once. Throws scene::SceneError if a value
    // leaves its range at this frame.
    void ask(Session& session, std::int64_t frame, glm::ivec2 size, double now, bool hand_rests);
    // Call these when a picture has come or was given up. It takes `display` seconds on average to
    // reach the screen.
    void learn(const Shown& shown, double display, double now);
    void learn(const GivenUp& picture, double display, double now);
    // The time, in seconds of `now`, at which to call ask() again without an event; none if that
    // would request nothing.
    std::optional<double> next_change() const;

    // Whether the last picture requested has full quality and has come.
    bool at_rest() const { return whole_ && came_; }
    // Whether a request is in flight.
    bool awaits() const { return subject_ && !came_; }
    std::uint64_t number() const { return number_; } // of the last request, even if it failed

    static constexpr double rate = 30;

private:
    struct Subject {
        std::uint64_t revision = 0;
        std::int64_t frame = 0;
        glm::ivec2 size{0};
        bool operator==(const Subject&) const = default;
    };

    double next_scale(int samples) const;
    void post(const Session& session, const Subject& subject, double scale, int samples,
              bool may_be_dropped, double now);
    bool holds_back(double now) const;

    DrawThread& thread_;
    ResolutionController resolution_;
    std::optional<Subject> subject_; // of the last request
    std::optional<Subject> wanted_;  // the request that it should be
    std::uint64_t number_ = 0;       // of the last request
    std::uint64_t begin_ = 1;        // of this scene's first request
    double scale_ = 1;               // of the last request
    bool grows_ = false;             // it is larger than the rate allows
    bool whole_ = false, came_ = false, hand_rests_ = true;
    double changed_ = 0, posted_ = 0;
    std::optional<std::chrono::steady_clock::time_point>
        noticed_; // the first change not yet requested
};

} // namespace isomotion::player
