#include "player/model/playback.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isomotion::player {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::int64_t count(const Playback& p) { return p.last - p.first + 1; }

// Frames a second.
double rate(const Playback& p) {
    return p.speed() * double(p.fps.numerator) / double(p.fps.denominator);
}

// The place as one number that still shows the frame, however near its part is to 1.
double number(std::int64_t frame, double part) {
    return std::min(double(frame) + part, std::nextafter(double(frame + 1), 0.0));
}

Position at(const Playback& p, double position) {
    const double offset =
        std::clamp(position - double(p.first), 0.0, std::nextafter(double(count(p)), 0.0));
    const double whole = std::floor(offset);
    return {p.first + std::int64_t(whole), offset - whole, false};
}

Playback anchored(Playback p, double position, double now) {
    const Position there = at(p, position);
    p.anchor = number(there.frame, there.part);
    p.moment = now;
    return p;
}

// The same place on the line, from here on.
Playback anchored(const Playback& p, double now) {
    const Position there = frame_at(p, now);
    return anchored(p, number(there.frame, there.part), now);
}

} // namespace

double Playback::speed() const { return std::ldexp(1.0, doublings); }

Playback with_frames(Playback playback, std::int64_t first, std::int64_t last) {
    playback.first = first;
    playback.last = last;
    playback.anchor = double(first);
    playback.playing = false;
    return playback;
}

Playback playback_of(const animation::Timeline& timeline) {
    Playback p;
    p.fps = timeline.fps;
    p.last = timeline.frames;
    p.loop = timeline.loops;
    return p;
}

Position frame_at(const Playback& p, double now) {
    if (!p.playing) return at(p, p.anchor);
    const double elapsed = now - p.moment;
    // If the time is no number or the clock ran back, no time has gone by.
    const double gone = elapsed > 0 && elapsed < infinity ? elapsed * rate(p) : 0;
    const double position = p.anchor + gone;
    if (p.loop) {
        return at(p, double(p.first) + std::fmod(position - double(p.first), double(count(p))));
    }
    if (position >= double(p.last)) return {p.last, 0, true};
    return at(p, position);
}

std::optional<double> next_change(const Playback& p, double now) {
    const Position here = frame_at(p, now);
    if (!p.playing || here.ended || (p.loop && count(p) == 1)) return std::nullopt;
    const auto differs = [&](double moment) {
        const Position there = frame_at(p, moment);
        return there.frame != here.frame || there.ended != here.ended;
    };
    double same = now, other = now + (1 - here.part) / rate(p);
    for (double more = other - now; !differs(other); more *= 2) other += more;
    // Rounding puts the moment some last bits off; it is found by halving.
    for (;;) {
        const double middle = same + (other - same) / 2;
        if (!(same < middle && middle < other)) return other;
        (differs(middle) ? other : same) = middle;
    }
}

Playback settled(const Playback& p, double now) {
    return frame_at(p, now).ended ? paused(p, now) : p;
}

Playback paused(const Playback& p, double now) {
    Playback still = anchored(p, now);
    still.playing = false;
    return still;
}

Playback played(const Playback& p, double now) {
    if (p.playing && !frame_at(p, now).ended) return p;
    Playback moving = anchored(p, now);
    moving.playing = true;
    if (frame_at(moving, now).ended) moving = anchored(moving, double(p.first), now);
    return moving;
}

Playback toggled(const Playback& p, double now) {
    return p.playing && !frame_at(p, now).ended ? paused(p, now) : played(p, now);
}

Playback with_speed(const Playback& p, int doublings, double now) {
    Playback other = anchored(p, now);
    other.doublings = std::clamp(doublings, least_doublings, most_doublings);
    return other;
}

Playback with_loop(const Playback& p, bool loop, double now) {
    Playback other = anchored(p, now);
    other.loop = loop;
    return other;
}

Playback stepped(const Playback& p, std::int64_t frames, double now) {
    const std::int64_t frame = frame_at(p, now).frame;
    Playback still = p;
    still.playing = false;
    if (!p.loop) {
        const std::int64_t most = p.last - frame, least = p.first - frame;
        return anchored(still, double(frame + std::clamp(frames, least, most)), now);
    }
    const std::int64_t offset = (frame - p.first + frames % count(p) + count(p)) % count(p);
    return anchored(still, double(p.first + offset), now);
}

Playback scrubbed(const Playback& p, std::int64_t frame, double now) {
    return anchored(p, double(std::clamp(frame, p.first, p.last)), now);
}

Playback jumped_to_time(const Playback& p, double time, double now) {
    return scrubbed(p, frame_of_time(p.fps, time), now);
}

std::int64_t frame_of_time(animation::FrameRate fps, double time) {
    const animation::Timeline timeline{fps};
    // (frame - 1) * denominator has to be an integer.
    const double most = 0x1p62 / double(fps.denominator);
    const double frames = std::floor(time * (double(fps.numerator) / double(fps.denominator)));
    if (!(frames > -most)) return std::isnan(frames) ? 1 : std::int64_t(-most);
    if (!(frames < most)) return std::int64_t(most);
    std::int64_t frame = 1 + std::int64_t(frames);
    while (timeline.time(frame) > time) --frame;
    while (timeline.time(frame + 1) <= time) ++frame;
    return frame;
}

Playback moved_to(const Playback& p, const animation::Timeline& from, const animation::Timeline& to,
                  double now) {
    const Position here = frame_at(p, now);
    Playback other = p;
    other.fps = to.fps;
    other.first = 1;
    other.last = to.frames;
    if (from.loops != to.loops) other.loop = to.loops;
    Position there = here;
    if (from.fps != to.fps) {
        const double time = from.time(here.frame, here.part);
        const double frames = double(to.fps.numerator) / double(to.fps.denominator);
        // A frame's beginning stays one, whichever way the time was rounded.
        there.frame = frame_of_time(to.fps, time + 1e-9 / frames);
        there.part = std::max((time - to.time(there.frame)) * frames, 0.0);
    }
    return anchored(other, std::min(number(there.frame, there.part), double(to.frames)), now);
}

} // namespace isomotion::player
