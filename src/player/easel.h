// Which picture is asked for next: of what moves one that keeps up, of what rests a better one.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include <glm/glm.hpp>

#include "player/draw_thread.h"
#include "player/pacing.h"
#include "player/session.h"

namespace isomotion::player {

// The largest size of this aspect within an area, pixels.
glm::ivec2 fitted_size(glm::ivec2 area, double aspect);

// Asks a DrawThread for a session's pictures.
class Easel {
public:
    explicit Easel(DrawThread& thread)
        : thread_(thread) {}

    // A scene was opened or read again: what a draw costs is unknown.
    void begin_scene();

    // Asks for what `session` shows at `frame` in a picture of `size` if that is not asked for yet:
    // as large as keeps `rate` pictures a second; and, once nothing has changed for a moment,
    // whole. `hand_rests`: no mouse button is held that changes it. A held one's changes wait for
    // the picture on its way, so that the next one has all of them and no other is before it.
    // Throws scene::SceneError where a value leaves its range at this frame.
    void ask(Session& session, std::int64_t frame, glm::ivec2 size, double now, bool hand_rests);
    // A picture came, or was given up; one takes `display` seconds to get to the screen.
    void learn(const Shown& shown, double display);
    void learn(const GivenUp& picture);
    // When ask() is to be called again though nothing has happened, in seconds of `now`: never
    // where it would ask for nothing.
    std::optional<double> next_change() const;

    // Whether the last picture asked for is whole and has come.
    bool at_rest() const { return whole_ && came_; }
    // Whether a picture was asked for that has not come.
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

    void post(const Session& session, double scale, int samples, bool may_be_dropped, double now);
    bool holds_back(double now) const;

    DrawThread& thread_;
    Pacing pacing_;
    std::optional<Subject> subject_; // of the last request
    std::optional<Subject> wanted_;  // what it should be
    std::uint64_t number_ = 0;       // of the last request
    std::uint64_t begin_ = 1;        // of the first one of this scene
    bool whole_ = false, came_ = false, hand_rests_ = true;
    double changed_ = 0, posted_ = 0;
    std::optional<std::chrono::steady_clock::time_point> noticed_; // what is not asked for yet
};

} // namespace isomotion::player
