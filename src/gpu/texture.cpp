#include "gpu/texture.h"

#include "gpu/draw.h"
#include "gpu/error.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include <stdexcept>

namespace isomotion::gpu {
namespace {

struct Layout {
    GLint internal;
    GLenum external, type;
    int channels;
};

Layout layout(Format format) {
    switch (format) {
    case Format::r32f:
        return {GL_R32F, GL_RED, GL_FLOAT, 1};
    case Format::rg32f:
        return {GL_RG32F, GL_RG, GL_FLOAT, 2};
    case Format::r32ui:
        return {GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, 1};
    case Format::rgba32ui:
        return {GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT, 4};
    case Format::depth16:
        return {GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT, GL_FLOAT, 1};
    case Format::rgba32f:
        break;
    }
    return {GL_RGBA32F, GL_RGBA, GL_FLOAT, 4};
}

void expect_size(Format format, int width, int height, std::span<const float> texels) {
    if (is_whole(format)) throw std::invalid_argument("floats for a texture of whole numbers");
    const auto wanted = std::size_t(width) * std::size_t(height) * std::size_t(channels(format));
    if (texels.size() != wanted)
        throw std::invalid_argument(fmt::format("a {} x {} texture takes {} floats, not {}", width,
                                                height, wanted, texels.size()));
}

} // namespace

int channels(Format format) { return layout(format).channels; }

bool is_whole(Format format) { return layout(format).type == GL_UNSIGNED_INT; }

Texture::Texture(Format format, int width, int height, std::span<const float> texels)
    : format_(format)
    , width_(width)
    , height_(height) {
    GLint limit = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    const auto what = fmt::format("a texture of {} x {} texels", width, height);
    if (width < 1 || height < 1 || width > limit || height > limit)
        throw ResourceError(fmt::format("{}: each side must be 1 to {} here", what, limit));
    if (!texels.empty()) expect_size(format, width, height, texels);

    const auto [internal, external, type, count] = layout(format);
    forget_errors();
    bind(editing_unit);
    glTexImage2D(GL_TEXTURE_2D, 0, internal, width, height, 0, external, type,
                 texels.empty() ? nullptr : texels.data());
    expect_success(what);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
}

void Texture::update(std::span<const float> texels) {
    expect_size(format_, width_, height_, texels);
    update_rows(0, texels);
}

void Texture::update_rows(int first, std::span<const float> texels) {
    const int rows = int(texels.size() / (std::size_t(width_) * std::size_t(channels(format_))));
    expect_size(format_, width_, rows, texels);
    if (first < 0 || first + rows > height_)
        throw std::invalid_argument(
            fmt::format("rows {} to {} of a texture with {}", first, first + rows - 1, height_));
    bind(editing_unit);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, first, width_, rows, layout(format_).external, GL_FLOAT,
                    texels.data());
}

void Texture::bind(int unit) const {
    glActiveTexture(GL_TEXTURE0 + GLenum(unit));
    glBindTexture(GL_TEXTURE_2D, name_.get());
}

} // namespace isomotion::gpu
