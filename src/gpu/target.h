#pragma once

#include "gpu/draw.h"
#include "gpu/texture.h"

#include <glm/vec4.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace isomotion::gpu {

/// A render target: several colour attachments of one size, no depth.
class Target {
public:
    /// Attachments of RGBA32F. Throws ResourceError if the driver cannot draw into so many
    /// attachments of that size.
    Target(int width, int height, int attachments = 1);
    Target(int width, int height, std::span<const Format> attachments);

    /// Directs draws here, over the whole area.
    void bind() const;

    /// Fills one attachment of floats, inside the current scissor only.
    void clear(int attachment, glm::vec4 value = {}) const;
    /// The same for an attachment of integers.
    void clear(int attachment, std::uint32_t value) const;

    /// Takes the pixels of all attachments in an area from a target with the same ones.
    void copy_from(const Target& other, Rectangle area) const;

    /// Rows from the bottom, as many numbers a pixel as the attachment has: the format it is stored
    /// in, as a conversion in the driver costs more than the copy. Waits for the draws before it.
    std::vector<float> read(int attachment, int x, int y, int width, int height) const;
    void read(int attachment, int x, int y, int width, int height, std::span<float> into) const;
    void read(int attachment, int x, int y, int width, int height,
              std::span<std::uint32_t> into) const;

    /// The same into the bound pixel buffer, from `offset` on, and the number of bytes:
    /// gpu/transfer.h.
    std::size_t bytes_in(int attachment, Rectangle area) const;
    void pack(int attachment, Rectangle area, std::size_t offset) const;

    const Texture& texture(int attachment) const { return textures_.at(std::size_t(attachment)); }
    int attachments() const noexcept { return int(textures_.size()); }
    int width() const noexcept { return textures_.front().width(); }
    int height() const noexcept { return textures_.front().height(); }
    Rectangle area() const noexcept { return {0, 0, width(), height()}; }

    /// The GL name, for calls that this class does not make.
    unsigned id() const noexcept { return name_.get(); }

private:
    std::size_t numbers_in(int attachment, Rectangle read) const;
    template<class Number>
    void read_into(int attachment, Rectangle area, bool whole, std::span<Number> into) const;
    void ask(int attachment, Rectangle area, void* into) const;

    std::vector<Texture> textures_;
    Name name_{Kind::framebuffer};
};

} // namespace isomotion::gpu
