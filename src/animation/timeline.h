// Converts a frame number to the time that the frame shows. There is no other way to do this.
//
// Playing, exporting, measuring and topology all call it, and all values are functions of time, so
// frame 812 alone equals frame 812 of the whole sequence. Frames count from 1; frame f shows time
// (f - 1) / fps.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace isomotion::animation {

struct FrameRate {
    std::int64_t numerator = 30;
    std::int64_t denominator = 1;

    bool operator==(const FrameRate&) const = default;
};

// "30", "30000/1001", "23.976" (an exact decimal fraction); empty if it isn't one of these or not
// positive.
std::optional<FrameRate> parse_frame_rate(std::string_view text);
std::string to_string(FrameRate rate); // "30", "30000/1001"

struct Timeline {
    FrameRate fps;
    int frames = 1;
    bool loops = false; // the frame after the last would equal the first

    double time(std::int64_t frame) const {
        return double((frame - 1) * fps.denominator) / double(fps.numerator);
    }
    // The time `part` of a frame's duration, 0 to 1, after the frame's time.
    double time(std::int64_t frame, double part) const {
        return time(frame) + part * double(fps.denominator) / double(fps.numerator);
    }
};

} // namespace isomotion::animation
