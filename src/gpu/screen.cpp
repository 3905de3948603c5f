#include "gpu/screen.h"

#include "gpu/draw.h"
#include "gpu/error.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include <stdexcept>

namespace isomotion::gpu {

void begin_screen(int width, int height, glm::vec3 color) {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    set_viewport({0, 0, width, height});
    glClearColor(color.r, color.g, color.b, 1);
    glClear(GL_COLOR_BUFFER_BIT);
}

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

} // namespace isomotion::gpu
