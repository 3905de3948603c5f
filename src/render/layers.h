// The channels of a frame, by what fills them.
#pragma once

#include <functional>
#include <vector>

#include "image/frame.h"
#include "synthesis/channel.h"

namespace isomotion::render {

class Layers {
public:
    // Layers of frames with the channels `wanted` beside R, G, B and A. `attachments`: those of
    // them that the shade pass writes, from its third attachment on.
    Layers(std::vector<synthesis::Channel> wanted, std::vector<synthesis::Channel> attachments)
        : wanted_(std::move(wanted))
        , attachments_(std::move(attachments)) {}

    bool wants(synthesis::Channel channel) const;
    // In `memory`, as far as it goes: fresh memory costs as much as reading back.
    image::Frame blank(int width, int height, image::Frame memory) const;
    // The layers of a channel, component by component; null where the frame has none.
    static std::vector<image::Channel*> of(image::Frame& frame, synthesis::Channel channel);
    // Each attachment with colours in it, and which channels its components are.
    void for_each_attachment(
        image::Frame& frame,
        const std::function<void(int attachment, const std::vector<image::Channel*>&)>& visit)
        const;

private:
    std::vector<synthesis::Channel> wanted_, attachments_;
};

} // namespace isomotion::render
