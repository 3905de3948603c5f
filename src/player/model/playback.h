// Playing as a pure function of a clock: the frame to be seen at a moment.
//
// A playback is linear: at the moment of its anchor it was at the anchor's position, and since then
// it moves by fps x speed. Every action of a person (pause, step, scrub, another speed) makes a new
// playback with its own anchor. Nothing accumulates from draw to draw, so a slow draw, a sleep or
// an hour of looping leaves no error. Playing only chooses frames; the Timeline alone decides what
// a frame shows.
//
// A position is a frame and the fraction of its duration that has passed: 7.9 shows frame 7.
// Moments are seconds of any clock that does not run backwards. If it did, playing would stay at
// its anchor.
#pragma once

#include <cstdint>
#include <optional>

#include "animation/timeline.h"

namespace isomotion::player {

struct Playback {
    animation::FrameRate fps;
    std::int64_t first = 1, last = 1; // the frames played; last >= first
    bool loop = false;                // the first frame follows the last
    bool playing = false;
    int doublings = 0; // 2^doublings times as fast, least_doublings to most_doublings
    double anchor = 1; // position at `moment`: in [first, last + 1)
    double moment = 0;

    double speed() const;

    bool operator==(const Playback&) const = default;
};

inline constexpr int least_doublings = -3, most_doublings = 3; // 1/8 to 8 times

// The whole timeline, paused at its first frame. Loops if the timeline does.
Playback playback_of(const animation::Timeline& timeline);

// The frames from `first` to `last`, paused at the first. 1 <= first <= last.
Playback with_frames(Playback playback, std::int64_t first, std::int64_t last);

struct Position {
    std::int64_t frame = 1;
    double part = 0;    // fraction of the frame's duration that has passed, in [0, 1)
    bool ended = false; // played to `last`, which is shown; only without a loop
};

// The frame at a moment, always within [first, last].
Position frame_at(const Playback& playback, double now);

// The earliest time after `now` at which frame_at() gives another frame or has ended. None if it
// never does: paused, ended, or a loop of one frame. Until then there is nothing to draw.
std::optional<double> next_change(const Playback& playback, double now);

// Pauses an ended playback at its last frame; returns any other unchanged.
Playback settled(const Playback& playback, double now);

// Each is at the same position at `now` as the given playback.
Playback paused(const Playback& playback, double now);
Playback played(const Playback& playback, double now);  // from the first frame, if it has ended
Playback toggled(const Playback& playback, double now); // paused or played
Playback with_speed(const Playback& playback, int doublings, double now); // clamped
Playback with_loop(const Playback& playback, bool loop, double now);

// Pauses `frames` frames later (earlier, if negative), at a frame's beginning. Past an end it wraps
// around if it loops, otherwise it stops there.
Playback stepped(const Playback& playback, std::int64_t frames, double now);
// Moves to a frame's beginning, clamped to the range; continues to play if it played.
Playback scrubbed(const Playback& playback, std::int64_t frame, double now);
// Moves to the frame that is shown at a time of the scene: the last one whose own time is not after
// it.
Playback jumped_to_time(const Playback& playback, double time, double now);

// The last frame whose time is not after `time` (seconds), by the timeline's own times: the time of
// frame f gives f, however division rounds. Saturates at +-2^53.
std::int64_t frame_of_time(animation::FrameRate fps, double time);

// The same time of the scene in a changed timeline: after a reload with other frames or another
// rate. The range is the whole new one. Loop, speed and playing stay, unless the timeline changed
// its own setting for loops.
Playback moved_to(const Playback& playback, const animation::Timeline& from,
                  const animation::Timeline& to, double now);

} // namespace isomotion::player
