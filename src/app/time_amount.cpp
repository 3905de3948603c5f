#include "app/time_amount.h"

#include <charconv>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace isomotion::app {

TimeAmount parse_time_amount(std::string_view option, std::string_view text) {
    double number = 0;
    const char* last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data(), last, number);
    std::string_view unit(end, std::size_t(last - end));
    while (unit.starts_with(' ')) unit.remove_prefix(1);
    const bool in_frames = unit == "frames" || unit == "frame";
    const bool is_amount = error == std::errc{} && std::isfinite(number) && number >= 0;
    if (!is_amount || !(in_frames || unit.empty() || unit == "s")) {
        throw std::invalid_argument(fmt::format(
            "{} {}: write seconds, 0 or more: 1e-9; or frames: \"0.5 frames\"", option, text));
    }
    return {number, in_frames};
}

} // namespace isomotion::app
