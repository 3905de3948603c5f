#include <algorithm>

#include <fmt/format.h>

#include "api/drawing/parts.h"
#include "api/drawing/statistics.h"
#include "api/scene/errors.h"
#include "base/file.h"
#include "image/encode.h"
#include "image/pixel_hash.h"
#include "image/rgba8.h"

namespace isomotion {

const Picture::Plane* Picture::find(std::string_view name) const {
    const auto found = std::ranges::find(planes, name, &Plane::name);
    return found == planes.end() ? nullptr : &*found;
}

std::vector<std::uint8_t> Picture::rgba8() const {
    return api::with_errors([&] { return image::rgba8(api::frame_of(*this)); });
}

std::string Picture::fingerprint() const {
    image::PixelHash hash(width, height);
    for (const Plane& plane : planes) hash.add_channel(plane.name, plane.values, 0, 1);
    return hash.text();
}

void Picture::write(const std::filesystem::path& file) const {
    api::with_errors([&] {
        base::write_whole(file, image::encode(api::frame_of(*this), image::format_of(file)));
    });
}

namespace api {

Picture picture_of(render::Picture drawn) {
    Picture picture;
    static_cast<RayStatistics&>(picture) =
        statistics_of(drawn.verdicts, drawn.rays, drawn.proofs, drawn.drawing);
    picture.width = drawn.frame.width;
    picture.height = drawn.frame.height;
    for (image::Channel& channel : drawn.frame.channels)
        picture.planes.push_back({std::move(channel.name), std::move(channel.samples)});
    return picture;
}

image::Frame frame_of(const Picture& picture) {
    image::Frame frame{picture.width, picture.height, {}, {}};
    for (const Picture::Plane& plane : picture.planes)
        frame.channels.push_back({plane.name, plane.values});
    image::check(frame);
    return frame;
}

std::vector<shader::Channel> channels_of(const std::vector<std::string>& names) {
    std::vector<shader::Channel> channels;
    for (const std::string& name : names) {
        const auto channel = shader::parse_channel(name);
        if (!channel) {
            std::vector<std::string_view> known;
            for (const auto& entry : shader::channel_names()) known.push_back(entry.name);
            throw Error(Error::Code::setting,
                        fmt::format("channels: there is no channel '{}'; known: {}", name,
                                    fmt::join(known, ", ")));
        }
        channels.push_back(*channel);
    }
    // One order, whatever the caller's: it decides the shaders' text.
    std::ranges::sort(channels);
    channels.erase(std::unique(channels.begin(), channels.end()), channels.end());
    return channels;
}

} // namespace api
} // namespace isomotion
