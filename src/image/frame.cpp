#include "image/frame.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace isomotion::image {
namespace {

struct Text {
    std::string operator()(const std::string& text) const { return text; }
    std::string operator()(int number) const { return fmt::format("{}", number); }
    std::string operator()(double number) const { return fmt::format("{}", number); }
    std::string operator()(const Rational& ratio) const {
        return fmt::format("{}/{}", ratio.numerator, ratio.denominator);
    }
    std::string operator()(const std::vector<double>& numbers) const {
        return fmt::format("[{}]", fmt::join(numbers, ", "));
    }
};

} // namespace

const Value* find(const Metadata& metadata, std::string_view name) {
    const auto entry = std::ranges::find(metadata, name, &Entry::name);
    return entry == metadata.end() ? nullptr : &entry->value;
}

std::string to_text(const Value& value) { return std::visit(Text{}, value); }

const Channel* Frame::find(std::string_view name) const {
    const auto channel = std::ranges::find(channels, name, &Channel::name);
    return channel == channels.end() ? nullptr : &*channel;
}

std::int64_t count_without_colour(const Frame& frame) {
    std::vector<const float*> planes;
    for (const char* name : {"R", "G", "B", "A"}) {
        if (const Channel* channel = frame.find(name)) planes.push_back(channel->samples.data());
    }
    const auto area = std::size_t(frame.width) * std::size_t(frame.height);
    std::int64_t count = 0;
    for (std::size_t i = 0; i < area; ++i) {
        bool is_finite = true;
        for (const float* plane : planes) is_finite = is_finite && std::isfinite(plane[i]);
        count += !is_finite;
    }
    return count;
}

void check(const Frame& frame) {
    if (frame.width < 1 || frame.height < 1)
        throw ImageError(
            fmt::format("a frame of {} x {} pixels has no area; both must be at least 1",
                        frame.width, frame.height));
    if (frame.channels.empty()) throw ImageError("a frame without channels holds nothing");

    const auto area = std::size_t(frame.width) * std::size_t(frame.height);
    std::set<std::string_view> names;
    for (const Channel& channel : frame.channels) {
        if (channel.name.empty()) throw ImageError("a channel has no name");
        if (!names.insert(channel.name).second)
            throw ImageError(fmt::format("two channels are named {}", channel.name));
        if (channel.samples.size() != area)
            throw ImageError(fmt::format("channel {} has {} samples; {} x {} pixels need {}",
                                         channel.name, channel.samples.size(), frame.width,
                                         frame.height, area));
    }
}

} // namespace isomotion::image
