#pragma once

#include "gpu/draw.h"
#include "gpu/texture.h"

#include <glm/vec4.hpp>

#include <span>
#include <vector>

namespace isomotion::gpu {

/// What is drawn into: several RGBA32F colour attachments of one size, no depth.
class Target {
public:
    /// Throws ResourceError if the driver cannot draw into that many attachments of that size.
    Target(int width, int height, int attachments = 1);

    /// Draws go here, over the whole area.
    void bind() const;

    /// Fills one attachment, inside the current scissor only.
    void clear(int attachment, glm::vec4 value = {}) const;

    /// Rows from the bottom, four floats a pixel: the format it is stored in, as a conversion in
    /// the driver costs more than the copy. Waits for the draws before it.
    std::vector<float> read(int attachment, int x, int y, int width, int height) const;
    void read(int attachment, int x, int y, int width, int height, std::span<float> into) const;

    const Texture& texture(int attachment) const { return textures_.at(std::size_t(attachment)); }
    int attachments() const noexcept { return int(textures_.size()); }
    int width() const noexcept { return textures_.front().width(); }
    int height() const noexcept { return textures_.front().height(); }
    Rectangle area() const noexcept { return {0, 0, width(), height()}; }

    /// The GL name, for calls this class does not make.
    unsigned id() const noexcept { return name_.get(); }

private:
    void expect_inside(int attachment, Rectangle area) const;

    std::vector<Texture> textures_;
    Name name_{Kind::framebuffer};
};

} // namespace isomotion::gpu
