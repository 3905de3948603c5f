#include "app/render_arguments.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "scene/method.h"

namespace isomotion::app {
namespace {

std::string size_key(const std::string& text) {
    int width = 0, height = 0;
    const char* end = text.data() + text.size();
    const auto first = std::from_chars(text.data(), end, width);
    const bool parted = first.ec == std::errc{} && first.ptr != end && *first.ptr == 'x';
    const auto second = parted ? std::from_chars(first.ptr + 1, end, height) : first;
    if (!parted || second.ec != std::errc{} || second.ptr != end || width < 1 || height < 1) {
        throw std::invalid_argument(fmt::format("--size {}: write WIDTHxHEIGHT, 1920x1080", text));
    }
    return fmt::format("output.size=[{},{}]", width, height);
}

std::string step_key(const std::string& text) {
    double step = 0;
    const char* end = text.data() + text.size();
    const auto [parsed, error] = std::from_chars(text.data(), end, step);
    if (error != std::errc{} || parsed != end || !(step > 0) || !std::isfinite(step)) {
        throw std::invalid_argument(
            fmt::format("--step {}: write a length above 0 in formula coordinates, 0.01", text));
    }
    return fmt::format("isolation.step={}", step);
}

std::string method_key(const std::string& text) {
    if (!scene::parse_method(text)) {
        std::vector<std::string_view> known;
        for (const auto& entry : scene::method_names) known.push_back(entry.name);
        throw std::invalid_argument(fmt::format("--method: there is no method '{}'; known: {}",
                                                text, fmt::join(known, ", ")));
    }
    return fmt::format("isolation.method=\"{}\"", text);
}

} // namespace

std::vector<scene::Override> overrides(const RenderArguments& arguments) {
    std::vector<scene::Override> all = arguments.settings;
    if (arguments.certify) all.push_back("isolation.certify=true");
    if (!arguments.method.empty()) all.push_back(method_key(arguments.method));
    if (!arguments.step.empty()) all.push_back(step_key(arguments.step));
    if (!arguments.size.empty()) all.push_back(size_key(arguments.size));
    return all;
}

std::vector<synthesis::Channel> parse_channels(const std::string& text) {
    std::vector<synthesis::Channel> channels;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t comma = std::min(text.find(',', begin), text.size());
        const std::string part = text.substr(begin, comma - begin);
        const auto channel = synthesis::parse_channel(part);
        if (!channel) {
            std::vector<std::string_view> known;
            for (const auto& entry : synthesis::channel_names()) known.push_back(entry.name);
            throw std::invalid_argument(fmt::format(
                "--channels: there is no channel '{}'; known: {}", part, fmt::join(known, ", ")));
        }
        if (std::find(channels.begin(), channels.end(), *channel) == channels.end()) {
            channels.push_back(*channel);
        }
        begin = comma + 1;
    }
    std::sort(channels.begin(), channels.end());
    return channels;
}

} // namespace isomotion::app
