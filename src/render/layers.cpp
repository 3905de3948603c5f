#include "render/layers.h"

#include <algorithm>
#include <string>

namespace isomotion::render {

bool Layers::wants(shader::Channel channel) const {
    return std::ranges::find(wanted_, channel) != wanted_.end();
}

image::Frame Layers::blank(int width, int height, image::Frame memory) const {
    image::Frame blank;
    blank.width = width;
    blank.height = height;
    const auto area = std::size_t(width) * std::size_t(height);
    const auto add = [&](std::string_view name) {
        const std::size_t k = blank.channels.size();
        std::vector<float> samples;
        if (k < memory.channels.size()) samples = std::move(memory.channels[k].samples);
        samples.resize(area);
        blank.channels.push_back({std::string(name), std::move(samples)});
    };
    for (const char* name : {"R", "G", "B", "A"}) add(name);
    for (const auto& entry : shader::channel_names()) {
        if (!wants(entry.channel)) continue;
        for (const auto layer : entry.layers) add(layer);
    }
    return blank;
}

std::vector<image::Channel*> Layers::of(image::Frame& frame, shader::Channel channel) {
    std::vector<image::Channel*> targets;
    for (const auto& entry : shader::channel_names()) {
        if (entry.channel != channel) continue;
        for (const auto layer : entry.layers) {
            const auto it = std::ranges::find(frame.channels, layer, &image::Channel::name);
            targets.push_back(it == frame.channels.end() ? nullptr : &*it);
        }
    }
    return targets;
}

void Layers::for_each_attachment(
    image::Frame& frame,
    const std::function<void(int attachment, const std::vector<image::Channel*>&)>& visit) const {
    const auto color = [&](std::size_t k) { return &frame.channels[k]; };
    visit(0, {color(0), color(1), color(2), color(3)});
    for (std::size_t a = 0; a < attachments_.size(); ++a) {
        const auto layers = of(frame, attachments_[a]);
        if (!layers.empty()) visit(2 + int(a), layers);
    }
}

} // namespace isomotion::render
