#include "render/read_back.h"

#include <algorithm>
#include <cstddef>
#include <thread>

#include "base/workers.h"

namespace isomotion::render {
namespace {

// Some rows at a time, which stay in a processor's cache from one copy to the next.
constexpr int floats_of_a_strip = 1 << 16;

// More threads wait for memory.
constexpr int most_at_once = 8;

struct Strip {
    const Attachment* attachment;
    int y, rows;
};

std::vector<Strip> strips_of(std::span<const Attachment> attachments, const gpu::Rectangle& tile) {
    const int rows = std::clamp(floats_of_a_strip / (4 * tile.width), 1, tile.height);
    std::vector<Strip> strips;
    for (const Attachment& attachment : attachments) {
        for (int y = 0; y < tile.height; y += rows)
            strips.push_back({&attachment, y, std::min(rows, tile.height - y)});
    }
    return strips;
}

} // namespace

std::vector<Attachment> attachments_of(const Layers& layers, image::Frame& frame) {
    std::vector<Attachment> all;
    layers.for_each_attachment(frame, [&](int number, const auto& channels) {
        all.push_back({number, channels});
    });
    return all;
}

ReadBack::ReadBack(int threads)
    : threads_(threads > 0 ? threads : std::max(1, int(std::thread::hardware_concurrency()))) {}

void ReadBack::in_strips(const gpu::Target& from, glm::ivec2 corner,
                         std::span<const Attachment> attachments, const gpu::Rectangle& tile,
                         const Planes& planes) {
    for (const Strip& strip : strips_of(attachments, tile)) {
        strip_.resize(4 * std::size_t(tile.width) * std::size_t(strip.rows));
        from.read(strip.attachment->number, corner.x, corner.y + strip.y, tile.width, strip.rows,
                  strip_);
        planes.copy(strip_.data(), tile, strip.y, strip.rows, strip.attachment->channels);
    }
}

void ReadBack::at_once(const gpu::Target& from, glm::ivec2 corner,
                       std::span<const Attachment> attachments, const gpu::Rectangle& tile,
                       const Planes& planes, gpu::Transfer& pixels) const {
    const gpu::Rectangle drawn{corner.x, corner.y, tile.width, tile.height};
    std::size_t end = 0;
    for (const Attachment& attachment : attachments)
        end = pixels.ask(from, attachment.number, drawn, end);
    pixels.send();
    pixels.read([&](std::span<const std::byte> bytes) {
        std::vector<const float*> texels;
        for (const Attachment& attachment : attachments) {
            texels.push_back(reinterpret_cast<const float*>(bytes.data()));
            bytes = bytes.subspan(from.bytes_in(attachment.number, drawn));
        }
        copy(attachments, texels, tile, planes);
    });
}

void ReadBack::copy(std::span<const Attachment> attachments, std::span<const float* const> texels,
                    const gpu::Rectangle& tile, const Planes& planes) const {
    const std::vector<Strip> strips = strips_of(attachments, tile);
    base::share({strips.size(), std::min(threads_, most_at_once)}, [&] {
        return [&](std::size_t k) {
            const Strip& strip = strips[k];
            const auto attachment = std::size_t(strip.attachment - attachments.data());
            const std::size_t before = 4 * std::size_t(tile.width) * std::size_t(strip.y);
            planes.copy(texels[attachment] + before, tile, strip.y, strip.rows,
                        strip.attachment->channels);
        };
    });
}

} // namespace isomotion::render
