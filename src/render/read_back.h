// Brings what was drawn of a tile to a frame's channels.
#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "gpu/target.h"
#include "gpu/transfer.h"
#include "render/layers.h"
#include "render/planes.h"

namespace isomotion::render {

// An attachment, and the channels that its components go to: null for none.
struct Attachment {
    int number = 0;
    std::vector<image::Channel*> channels;
};

std::vector<Attachment> attachments_of(const Layers& layers, image::Frame& frame);

class ReadBack {
public:
    // `threads`: at most so many, the caller's included; 0: as many as the machine runs at once.
    explicit ReadBack(int threads);

    // Reads attachments of a tile that begins at `corner` of a target, strip by strip. For software
    // renderers, whose copies are as dear as the ones to the planes: a second thread for these
    // gained nothing.
    void in_strips(const gpu::Target& from, glm::ivec2 corner,
                   std::span<const Attachment> attachments, const gpu::Rectangle& tile,
                   const Planes& planes);

    // Reads all of them at once into a pixel buffer that has room for them, since each read waits
    // for the hardware.
    void at_once(const gpu::Target& from, glm::ivec2 corner,
                 std::span<const Attachment> attachments, const gpu::Rectangle& tile,
                 const Planes& planes, gpu::Transfer& pixels) const;

    // Copies attachments that are in memory: `texels` has where each begins. Threads share the
    // copies, which take longer than a graphics card takes to draw.
    void copy(std::span<const Attachment> attachments, std::span<const float* const> texels,
              const gpu::Rectangle& tile, const Planes& planes) const;

private:
    int threads_;
    std::vector<float> strip_;
};

} // namespace isomotion::render
