// Playing as a pure function of a clock: which frame is to be seen at a moment.
//
// A playback is a straight line: at the moment of its anchor it stood at the anchor's position, and
// since then it moves by fps x speed. Whatever a person does (pause, step, scrub, another speed)
// is a new line with an anchor of its own; nothing is added up from draw to draw, so that a slow
// draw, a sleep or an hour of looping leaves no error behind. What a frame shows is the Timeline's
// business alone: playing only chooses frames.
//
// A position is a frame and the part of its duration gone by: 7.9 shows frame 7. Moments are
// seconds of any clock that does not run backwards; were it to, playing would stand at its anchor.
#pragma once

#include <cstdint>
#include <optional>

#include "animation/timeline.h"

namespace isomotion::player {

struct Playback {
    animation::FrameRate fps;
    std::int64_t first = 1, last = 1; // the frames played; last >= first
    bool loop = false;                // first follows last
    bool playing = false;
    int doublings = 0; // 2^doublings times as fast, least_doublings to most_doublings
    double anchor = 1; // position, at `moment`: in [first, last + 1)
    double moment = 0;

    double speed() const;

    bool operator==(const Playback&) const = default;
};

inline constexpr int least_doublings = -3, most_doublings = 3; // 1/8 to 8 times

// All of a timeline, paused at its first frame. Loops if the timeline says so.
Playback playback_of(const animation::Timeline& timeline);

// From one frame to another, paused at the first. 1 <= first <= last.
Playback with_frames(Playback playback, std::int64_t first, std::int64_t last);

struct Position {
    std::int64_t frame = 1;
    double part = 0;    // of the frame's duration gone by, in [0, 1)
    bool ended = false; // played up to `last`, which is shown; only where it does not loop
};

// The frame at a moment, always within [first, last].
Position frame_at(const Playback& playback, double now);

// The earliest moment after `now` at which frame_at() gives another frame or has ended; none if it
// never does: paused, ended, or a loop of one frame. Until then there is nothing to draw.
std::optional<double> next_change(const Playback& playback, double now);

// What has ended is paused at its last frame; what has not is given back as it is.
Playback settled(const Playback& playback, double now);

// Each stands at `now` where the given one stands then.
Playback paused(const Playback& playback, double now);
Playback played(const Playback& playback, double now);  // from the first frame, if it has ended
Playback toggled(const Playback& playback, double now); // paused or played
Playback with_speed(const Playback& playback, int doublings, double now); // clamped
Playback with_loop(const Playback& playback, bool loop, double now);

// Pauses `frames` frames further on (back, if negative), at a frame's beginning: past an end it
// goes round where it loops, else it stops there.
Playback stepped(const Playback& playback, std::int64_t frames, double now);
// To a frame's beginning, clamped to the range; plays on if it played.
Playback scrubbed(const Playback& playback, std::int64_t frame, double now);
// To the frame that is shown at a time of the scene: the last one whose own time is not after it.
Playback jumped_to_time(const Playback& playback, double time, double now);

// The last frame whose time is not after `time` (seconds), by the timeline's own times: that of
// frame f gives f, whatever division rounded. Saturates at +-2^53.
std::int64_t frame_of_time(animation::FrameRate fps, double time);

// The same moment of the scene in a timeline that has changed: after a reload with other frames or
// another rate. The range is all of the new one; loop, speed and playing stay, unless the timeline
// changed its mind about loops.
Playback moved_to(const Playback& playback, const animation::Timeline& from,
                  const animation::Timeline& to, double now);

} // namespace isomotion::player
