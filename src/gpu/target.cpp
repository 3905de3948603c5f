#include "gpu/target.h"

#include "gpu/error.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include <algorithm>
#include <stdexcept>

namespace isomotion::gpu {
namespace {

int attachment_limit() {
    GLint colors = 0, draws = 0;
    glGetIntegerv(GL_MAX_COLOR_ATTACHMENTS, &colors);
    glGetIntegerv(GL_MAX_DRAW_BUFFERS, &draws);
    return std::min(colors, draws);
}

} // namespace

Target::Target(int width, int height, int attachments)
    : Target(width, height,
             std::vector<Format>(std::size_t(std::max(attachments, 0)), Format::rgba32f)) {}

Target::Target(int width, int height, std::span<const Format> formats) {
    const int attachments = int(formats.size()), limit = attachment_limit();
    if (attachments < 1 || attachments > limit)
        throw ResourceError(fmt::format("a target with {} attachments: 1 to {} are possible here",
                                        attachments, limit));
    textures_.reserve(std::size_t(attachments));
    std::vector<GLenum> drawn;
    for (int i = 0; i < attachments; ++i) {
        textures_.emplace_back(formats[std::size_t(i)], width, height);
        drawn.push_back(GL_COLOR_ATTACHMENT0 + GLenum(i));
    }

    const auto what =
        fmt::format("a target of {} x {} pixels with {} attachments", width, height, attachments);
    forget_errors();
    glBindFramebuffer(GL_FRAMEBUFFER, name_.get());
    for (int i = 0; i < attachments; ++i)
        glFramebufferTexture2D(GL_FRAMEBUFFER, drawn[std::size_t(i)], GL_TEXTURE_2D,
                               texture(i).id(), 0);
    glDrawBuffers(attachments, drawn.data());
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    expect_success(what);
    if (status != GL_FRAMEBUFFER_COMPLETE)
        throw ResourceError(fmt::format("{}: incomplete ({:#06x})", what, status));
}

void Target::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, name_.get());
    set_viewport(area());
}

void Target::clear(int attachment, glm::vec4 value) const {
    glBindFramebuffer(GL_FRAMEBUFFER, name_.get());
    glClearBufferfv(GL_COLOR, attachment, &value.x);
}

void Target::clear(int attachment, std::uint32_t value) const {
    const GLuint values[4] = {value, value, value, value};
    glBindFramebuffer(GL_FRAMEBUFFER, name_.get());
    glClearBufferuiv(GL_COLOR, attachment, values);
}

void Target::copy_from(const Target& other, Rectangle area) const {
    forget_errors();
    glBindFramebuffer(GL_READ_FRAMEBUFFER, other.id());
    glActiveTexture(GL_TEXTURE0 + GLenum(editing_unit));
    for (int k = 0; k < attachments(); ++k) {
        glReadBuffer(GL_COLOR_ATTACHMENT0 + GLenum(k));
        glBindTexture(GL_TEXTURE_2D, texture(k).id());
        glCopyTexSubImage2D(GL_TEXTURE_2D, 0, area.x, area.y, area.x, area.y, area.width,
                            area.height);
    }
    expect_success("copying pixels");
}

std::vector<float> Target::read(int attachment, int x, int y, int width, int height) const {
    std::vector<float> pixels(numbers_in(attachment, {x, y, width, height}));
    read(attachment, x, y, width, height, pixels);
    return pixels;
}

void Target::read(int attachment, int x, int y, int width, int height,
                  std::span<float> into) const {
    read_into(attachment, {x, y, width, height}, false, into);
}

void Target::read(int attachment, int x, int y, int width, int height,
                  std::span<std::uint32_t> into) const {
    read_into(attachment, {x, y, width, height}, true, into);
}

template<class Number>
void Target::read_into(int attachment, Rectangle area, bool whole, std::span<Number> into) const {
    const std::size_t numbers = numbers_in(attachment, area);
    if (into.size() != numbers || is_whole(texture(attachment).format()) != whole)
        throw std::invalid_argument(
            fmt::format("{} x {} pixels are {} {}, not {} {}", area.width, area.height, numbers,
                        is_whole(texture(attachment).format()) ? "whole numbers" : "floats",
                        into.size(), whole ? "whole numbers" : "floats"));
    forget_errors();
    ask(attachment, area, into.data());
    expect_success("reading back pixels");
}

std::size_t Target::bytes_in(int attachment, Rectangle area) const {
    return numbers_in(attachment, area) * sizeof(float);
}

void Target::pack(int attachment, Rectangle area, std::size_t offset) const {
    forget_errors();
    ask(attachment, area, reinterpret_cast<void*>(offset)); // NOLINT: what OpenGL takes it for
    expect_success("reading back pixels");
}

void Target::ask(int attachment, Rectangle area, void* into) const {
    constexpr GLenum floats[] = {GL_RED, GL_RG, GL_NONE, GL_RGBA};
    constexpr GLenum wholes[] = {GL_RED_INTEGER, GL_NONE, GL_NONE, GL_RGBA_INTEGER};
    const Format format = texture(attachment).format();
    const auto k = std::size_t(channels(format) - 1);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, name_.get());
    glReadBuffer(GL_COLOR_ATTACHMENT0 + GLenum(attachment));
    glReadPixels(area.x, area.y, area.width, area.height, is_whole(format) ? wholes[k] : floats[k],
                 is_whole(format) ? GL_UNSIGNED_INT : GL_FLOAT, into);
}

std::size_t Target::numbers_in(int attachment, Rectangle read) const {
    const bool inside = attachment >= 0 && attachment < attachments() && read.x >= 0 &&
                        read.y >= 0 && read.width >= 0 && read.height >= 0 &&
                        read.width <= width() - read.x && read.height <= height() - read.y;
    if (!inside)
        throw std::out_of_range(fmt::format(
            "reading {} x {} pixels at {}, {} of attachment {}: the target has {} x {} and {}",
            read.width, read.height, read.x, read.y, attachment, width(), height(), attachments()));
    return std::size_t(read.width) * std::size_t(read.height) *
           std::size_t(channels(texture(attachment).format()));
}

} // namespace isomotion::gpu
