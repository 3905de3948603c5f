// The channels of a frame, grouped by what fills them.
#pragma once

#include <functional>
#include <vector>

#include "image/frame.h"
#include "shader/channel.h"

namespace isomotion::render {

class Layers {
public:
    // Layers of frames with the channels `wanted` besides R, G, B and A. `attachments`: those that
    // the shade pass writes, from its third attachment on.
    Layers(std::vector<shader::Channel> wanted, std::vector<shader::Channel> attachments)
        : wanted_(std::move(wanted))
        , attachments_(std::move(attachments)) {}

    bool wants(shader::Channel channel) const;
    // Reuses `memory` as far as possible, since allocating fresh memory takes as long as reading
    // back.
    image::Frame blank(int width, int height, image::Frame memory) const;
    // The layers of a channel, component by component; null if the frame has none.
    static std::vector<image::Channel*> of(image::Frame& frame, shader::Channel channel);
    // Calls `visit` for each attachment with channels in it, and passes the channels of its
    // components.
    void for_each_attachment(
        image::Frame& frame,
        const std::function<void(int attachment, const std::vector<image::Channel*>&)>& visit)
        const;

private:
    std::vector<shader::Channel> wanted_, attachments_;
};

} // namespace isomotion::render
