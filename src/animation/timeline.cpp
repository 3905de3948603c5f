#include "animation/timeline.h"

#include <charconv>
#include <numeric>

#include <fmt/format.h>

namespace isomotion::animation {
namespace {

std::optional<std::int64_t> parse_integer(std::string_view text) {
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

std::optional<FrameRate> checked(std::optional<std::int64_t> numerator,
                                 std::optional<std::int64_t> denominator) {
    // The bounds keep (frame - 1) * denominator exact in 64 bits for every frame number of an int,
    // and the numerator exact in a double.
    constexpr std::int64_t largest_numerator = 1'000'000'000'000'000;
    constexpr std::int64_t largest_denominator = 1'000'000'000;
    if (!numerator || !denominator) return std::nullopt;
    if (*numerator <= 0 || *denominator <= 0) return std::nullopt;
    const std::int64_t common = std::gcd(*numerator, *denominator);
    const FrameRate rate{*numerator / common, *denominator / common};
    if (rate.numerator > largest_numerator) return std::nullopt;
    if (rate.denominator > largest_denominator) return std::nullopt;
    return rate;
}

} // namespace

std::optional<FrameRate> parse_frame_rate(std::string_view text) {
    if (const std::size_t slash = text.find('/'); slash != text.npos) {
        return checked(parse_integer(text.substr(0, slash)), parse_integer(text.substr(slash + 1)));
    }
    const std::size_t point = text.find('.');
    if (point == text.npos) return checked(parse_integer(text), 1);
    const std::string_view fraction = text.substr(point + 1);
    if (fraction.size() > 9) return std::nullopt;
    std::int64_t scale = 1;
    for (std::size_t k = 0; k < fraction.size(); ++k) scale *= 10;
    return checked(parse_integer(std::string(text.substr(0, point)) + std::string(fraction)),
                   scale);
}

std::string to_string(FrameRate rate) {
    return rate.denominator == 1 ? fmt::format("{}", rate.numerator)
                                 : fmt::format("{}/{}", rate.numerator, rate.denominator);
}

} // namespace isomotion::animation
