#include "animation/frame_range.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

namespace isomotion::animation {
namespace {

constexpr int last_frame = 10'000'000;

int parse_number(std::string_view part, std::string_view digits) {
    int value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    const bool too_large = error == std::errc::result_out_of_range;
    if ((error != std::errc{} && !too_large) || end != digits.data() + digits.size()) {
        throw std::invalid_argument(fmt::format(
            "'{}' is not a frame range: write a frame (5), a range (1-10), or a range with a step "
            "(1-10x2), several separated by commas",
            part));
    }
    if (too_large || value < 1 || value > last_frame) {
        throw std::invalid_argument(
            fmt::format("'{}': frames and steps count from 1 to {}", part, last_frame));
    }
    return value;
}

} // namespace

std::vector<int> parse_frame_range(std::string_view text) {
    std::vector<int> frames;
    std::vector<bool> seen;
    int named = 0;
    while (true) {
        const std::size_t comma = text.find(',');
        const std::string_view part = text.substr(0, comma);
        const std::size_t x = part.find('x');
        const std::string_view span = part.substr(0, x);
        const int step = x == part.npos ? 1 : parse_number(part, part.substr(x + 1));
        const std::size_t dash = span.find('-');
        const int first = parse_number(part, span.substr(0, dash));
        const int last = dash == span.npos ? first : parse_number(part, span.substr(dash + 1));
        for (int frame = first; first <= last ? frame <= last : frame >= last;
             frame += first <= last ? step : -step) {
            if (++named > last_frame) {
                throw std::invalid_argument(
                    fmt::format("more than {} frames are named", last_frame));
            }
            if (std::size_t(frame) >= seen.size()) seen.resize(std::size_t(frame) + 1);
            if (!seen[std::size_t(frame)]) frames.push_back(frame);
            seen[std::size_t(frame)] = true;
        }
        if (comma == text.npos) return frames;
        text.remove_prefix(comma + 1);
    }
}

std::string frame_range(std::vector<int> frames) {
    std::ranges::sort(frames);
    frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
    std::string text;
    for (std::size_t k = 0; k < frames.size();) {
        const int step = k + 1 < frames.size() ? frames[k + 1] - frames[k] : 1;
        std::size_t end = k + 1; // of the frames that follow at this step
        while (end < frames.size() && frames[end] - frames[end - 1] == step) ++end;
        if (step > 1 && end - k < 3) end = k + 1; // "5,9" rather than "5-9x4"
        if (!text.empty()) text += ',';
        text += std::to_string(frames[k]);
        if (end - k > 1) text += fmt::format("-{}", frames[end - 1]);
        if (end - k > 1 && step > 1) text += fmt::format("x{}", step);
        k = end;
    }
    return text;
}

} // namespace isomotion::animation
