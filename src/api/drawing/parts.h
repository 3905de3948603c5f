// What a Device of the public header holds, and pictures of both kinds.
#pragma once

#include <memory>

#include "gpu/context.h"
#include "image/frame.h"
#include "isomotion/isomotion.h"
#include "render/renderer.h"
#include "shader/channel.h"

namespace isomotion {

struct Device::Parts {
    std::unique_ptr<gpu::Context> context;
};

namespace api {

Picture picture_of(render::Picture drawn);
image::Frame frame_of(const Picture& picture);
// Throws Error that lists the channels.
std::vector<shader::Channel> channels_of(const std::vector<std::string>& names);

} // namespace api
} // namespace isomotion
