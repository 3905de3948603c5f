#include "gpu/compute.h"

#include "gpu/error.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include <utility>

namespace isomotion::gpu {
namespace {

GLenum image_format(Format format) {
    switch (format) {
    case Format::r32f:
        return GL_R32F;
    case Format::rg32f:
        return GL_RG32F;
    case Format::r32ui:
        return GL_R32UI;
    case Format::rgba32ui:
        return GL_RGBA32UI;
    case Format::rgba32f:
    case Format::depth16: // no image can be one
        break;
    }
    return GL_RGBA32F;
}

} // namespace

bool has_compute(const ContextInfo& info) {
    return std::pair(info.major, info.minor) >= std::pair(4, 3);
}

void expect_compute(const ContextInfo& info, std::string_view what) {
    if (has_compute(info)) return;
    throw ResourceError(fmt::format("{}: needs OpenGL 4.3, this driver has {}.{} ({})", what,
                                    info.major, info.minor, info.renderer));
}

void bind_image(const Texture& texture, int unit) {
    glBindImageTexture(GLuint(unit), texture.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY,
                       image_format(texture.format()));
}

void dispatch(glm::ivec2 groups) {
    // Image stores are not ordered by themselves, not even after earlier fetches of their texels.
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    glDispatchCompute(GLuint(groups.x), GLuint(groups.y), 1);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT |
                    GL_TEXTURE_UPDATE_BARRIER_BIT);
}

} // namespace isomotion::gpu
