#include "gpu/target.h"

#include "gpu/error.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include <algorithm>
#include <stdexcept>

namespace isomotion::gpu {
namespace {

constexpr int pixel_floats = 4;

int attachment_limit() {
    GLint colors = 0, draws = 0;
    glGetIntegerv(GL_MAX_COLOR_ATTACHMENTS, &colors);
    glGetIntegerv(GL_MAX_DRAW_BUFFERS, &draws);
    return std::min(colors, draws);
}

std::size_t floats_in(int width, int height) {
    return std::size_t(width) * std::size_t(height) * pixel_floats;
}

} // namespace

Target::Target(int width, int height, int attachments) {
    const int limit = attachment_limit();
    if (attachments < 1 || attachments > limit)
        throw ResourceError(fmt::format("a target with {} attachments: 1 to {} are possible here",
                                        attachments, limit));
    textures_.reserve(std::size_t(attachments));
    std::vector<GLenum> drawn;
    for (int i = 0; i < attachments; ++i) {
        textures_.emplace_back(Format::rgba32f, width, height);
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

std::vector<float> Target::read(int attachment, int x, int y, int width, int height) const {
    expect_inside(attachment, {x, y, width, height});
    std::vector<float> pixels(floats_in(width, height));
    read(attachment, x, y, width, height, pixels);
    return pixels;
}

void Target::read(int attachment, int x, int y, int width, int height,
                  std::span<float> into) const {
    expect_inside(attachment, {x, y, width, height});
    if (into.size() != floats_in(width, height))
        throw std::invalid_argument(fmt::format("{} x {} pixels are {} floats, not {}", width,
                                                height, floats_in(width, height), into.size()));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, name_.get());
    glReadBuffer(GL_COLOR_ATTACHMENT0 + GLenum(attachment));
    forget_errors();
    glReadPixels(x, y, width, height, GL_RGBA, GL_FLOAT, into.data());
    expect_success("reading back pixels");
}

void Target::expect_inside(int attachment, Rectangle read) const {
    const bool inside = attachment >= 0 && attachment < attachments() && read.x >= 0 &&
                        read.y >= 0 && read.width >= 0 && read.height >= 0 &&
                        read.width <= width() - read.x && read.height <= height() - read.y;
    if (!inside)
        throw std::out_of_range(fmt::format(
            "reading {} x {} pixels at {}, {} of attachment {}: the target has {} x {} and {}",
            read.width, read.height, read.x, read.y, attachment, width(), height(), attachments()));
}

} // namespace isomotion::gpu
