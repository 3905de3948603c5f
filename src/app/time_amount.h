// An amount of time as options take it: "0.001", "0.001 s" or "2 frames".
#pragma once

#include <string_view>

namespace isomotion::app {

struct TimeAmount {
    double number = 0;
    bool in_frames = false;

    double seconds(double frames_per_second) const {
        return in_frames ? number / frames_per_second : number;
    }
};

// Throws std::invalid_argument for anything else and for negative values.
TimeAmount parse_time_amount(std::string_view option, std::string_view text);

} // namespace isomotion::app
