#include "gpu/buffer.h"

#include "gpu/draw.h"
#include "gpu/error.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include <array>
#include <stdexcept>

namespace isomotion::gpu {
namespace {

void expect_within(std::size_t wanted, GLenum limit_name, const std::string& what) {
    GLint limit = 0;
    glGetIntegerv(limit_name, &limit);
    if (wanted < 1 || wanted > std::size_t(limit))
        throw ResourceError(fmt::format("{}: 1 to {} are possible here", what, limit));
}

void allocate(GLenum target, GLuint buffer, std::size_t bytes, const std::string& what) {
    forget_errors();
    glBindBuffer(target, buffer);
    glBufferData(target, GLsizeiptr(bytes), nullptr, GL_DYNAMIC_DRAW);
    expect_success(what);
}

void replace(GLenum target, GLuint buffer, std::span<const std::byte> bytes,
             std::size_t capacity_bytes) {
    if (bytes.size() > capacity_bytes)
        throw std::length_error(
            fmt::format("{} bytes for a buffer of {}", bytes.size(), capacity_bytes));
    glBindBuffer(target, buffer);
    glBufferSubData(target, 0, GLsizeiptr(bytes.size()), bytes.data());
}

} // namespace

UniformBuffer::UniformBuffer(std::size_t capacity_bytes)
    : capacity_(capacity_bytes) {
    const auto what = fmt::format("a uniform block of {} bytes", capacity_bytes);
    expect_within(capacity_bytes, GL_MAX_UNIFORM_BLOCK_SIZE, what);
    allocate(GL_UNIFORM_BUFFER, name_.get(), capacity_bytes, what);
}

void UniformBuffer::update(std::span<const std::byte> bytes) {
    replace(GL_UNIFORM_BUFFER, name_.get(), bytes, capacity_);
}

void UniformBuffer::bind(unsigned binding) const {
    glBindBufferBase(GL_UNIFORM_BUFFER, binding, name_.get());
}

TextureBuffer::TextureBuffer(std::size_t capacity_texels)
    : capacity_(capacity_texels) {
    const auto what = fmt::format("a texture buffer of {} texels", capacity_texels);
    expect_within(capacity_texels, GL_MAX_TEXTURE_BUFFER_SIZE, what);
    allocate(GL_TEXTURE_BUFFER, buffer_.get(), capacity_texels * sizeof(glm::vec4), what);
    bind(editing_unit);
    glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, buffer_.get());
    expect_success(what);
}

void TextureBuffer::update(std::span<const glm::vec4> texels) {
    replace(GL_TEXTURE_BUFFER, buffer_.get(), std::as_bytes(texels), capacity_ * sizeof(glm::vec4));
}

void TextureBuffer::bind(int unit) const {
    glActiveTexture(GL_TEXTURE0 + GLenum(unit));
    glBindTexture(GL_TEXTURE_BUFFER, texture_.get());
}

void TextureBuffer::bind_storage(unsigned binding) const {
    // Stores are not ordered by themselves, not even after earlier fetches of what they overwrite.
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffer_.get());
}

void TextureBuffer::wait_for_storage() const {
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT |
                    GL_BUFFER_UPDATE_BARRIER_BIT);
}

IntegerBuffer::IntegerBuffer(Texel texel)
    : texel_(texel) {
    update(std::array<std::uint32_t, 2>{});
    bind(editing_unit);
    glTexBuffer(GL_TEXTURE_BUFFER, texel == Texel::two ? GL_RG32UI : GL_R32UI, buffer_.get());
    expect_success("a texture buffer of integers");
}

void IntegerBuffer::update(std::span<const std::uint32_t> numbers) {
    const std::size_t texels = texel_ == Texel::two ? numbers.size() / 2 : numbers.size();
    if (texels == 0) return;
    const auto what = fmt::format("a texture buffer of {} texels", texels);
    expect_within(texels, GL_MAX_TEXTURE_BUFFER_SIZE, what);
    forget_errors();
    glBindBuffer(GL_TEXTURE_BUFFER, buffer_.get());
    glBufferData(GL_TEXTURE_BUFFER, GLsizeiptr(numbers.size_bytes()), numbers.data(),
                 GL_DYNAMIC_DRAW);
    expect_success(what);
}

void IntegerBuffer::bind(int unit) const {
    glActiveTexture(GL_TEXTURE0 + GLenum(unit));
    glBindTexture(GL_TEXTURE_BUFFER, texture_.get());
}

} // namespace isomotion::gpu
