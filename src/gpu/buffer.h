#pragma once

#include "gpu/name.h"

#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace isomotion::gpu {

/// The contents of a uniform block (std140), with a fixed size.
class UniformBuffer {
public:
    /// Throws ResourceError if the driver's blocks are smaller.
    explicit UniformBuffer(std::size_t capacity_bytes);

    /// Replaces the first bytes without allocation. Throws std::length_error beyond the capacity.
    void update(std::span<const std::byte> bytes);

    void bind(unsigned binding) const;

    std::size_t capacity() const noexcept { return capacity_; }

private:
    Name name_{Kind::buffer};
    std::size_t capacity_;
};

/// A long array of RGBA32F texels: `texelFetch(samplerBuffer, i)`, with a fixed size.
class TextureBuffer {
public:
    /// Throws ResourceError if the driver's texture buffers are smaller.
    explicit TextureBuffer(std::size_t capacity_texels);

    /// Replaces the first texels without allocation. Throws std::length_error beyond the capacity.
    void update(std::span<const glm::vec4> texels);

    void bind(int unit) const;

    /// Bind it as a storage buffer (OpenGL 4.3) for shaders that write it; wait before others read
    /// it, as texels or as a storage buffer.
    void bind_storage(unsigned binding) const;
    void wait_for_storage() const;

    std::size_t capacity() const noexcept { return capacity_; }

private:
    Name buffer_{Kind::buffer};
    Name texture_{Kind::texture};
    std::size_t capacity_;
};

/// Unsigned integers, one or two per texel: `texelFetch(usamplerBuffer, i)`. Grows as needed.
class IntegerBuffer {
public:
    enum class Texel { one, two };
    explicit IntegerBuffer(Texel texel);

    /// Replaces all numbers. Throws ResourceError if the driver's texture buffers are smaller.
    void update(std::span<const std::uint32_t> numbers);

    void bind(int unit) const;

private:
    Name buffer_{Kind::buffer};
    Name texture_{Kind::texture};
    Texel texel_;
};

} // namespace isomotion::gpu
