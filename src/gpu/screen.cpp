#include "gpu/screen.h"

#include "gpu/draw.h"
#include "gpu/error.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include <stdexcept>

namespace isomotion::gpu {

void ScreenTexture::update(int width, int height, std::span<const std::uint8_t> codes,
                           Enlarged enlarged) {
    if (width < 1 || height < 1 || codes.size() != 4 * std::size_t(width) * std::size_t(height))
        throw std::invalid_argument(
            fmt::format("{} codes are no picture of {} x {}", codes.size(), width, height));
    GLint limit = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    if (width > limit || height > limit)
        throw ResourceError(fmt::format("a picture of {} x {}: each side must be 1 to {} here",
                                        width, height, limit));
    enlarged_ = enlarged;
    glActiveTexture(GL_TEXTURE0 + editing_unit);
    glBindTexture(GL_TEXTURE_2D, name_.get());
    const GLint filter = enlarged == Enlarged::smooth ? GL_LINEAR : GL_NEAREST;
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    if (width == width_ && height == height_) {
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE,
                        codes.data());
        return;
    }
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 codes.data());
    width_ = width;
    height_ = height;
}

void begin_screen(int width, int height, glm::vec3 color) {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    set_viewport({0, 0, width, height});
    glClearColor(color.r, color.g, color.b, 1);
    glClear(GL_COLOR_BUFFER_BIT);
}

void place(const ScreenTexture& picture, Rectangle where) {
    const Name source(Kind::framebuffer);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, source.get());
    glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, picture.id(),
                           0);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    // The picture's first row is the top one, a window's the lowest.
    const bool is_smooth = picture.enlarged() == ScreenTexture::Enlarged::smooth;
    glBlitFramebuffer(0, 0, picture.width(), picture.height(), where.x, where.y + where.height,
                      where.x + where.width, where.y, GL_COLOR_BUFFER_BIT,
                      is_smooth ? GL_LINEAR : GL_NEAREST);
}

std::array<std::uint8_t, 3> drawn_pixel(int x, int y) {
    std::array<std::uint8_t, 4> codes{};
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, codes.data());
    return {codes[0], codes[1], codes[2]};
}

} // namespace isomotion::gpu
