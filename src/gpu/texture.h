#pragma once

#include "gpu/name.h"

#include <span>

namespace isomotion::gpu {

enum class Format { r32f, rg32f, rgba32f, r32ui, rgba32ui, depth16 };

int channels(Format format);
/// Whether it has unsigned integers, which draws write and targets read back.
bool is_whole(Format format);

/// A 2D texture of numbers, read with texelFetch: no filtering, clamped at the edges.
class Texture {
public:
    /// `texels` fills it row by row from the bottom. If empty, the texels are undefined; integer
    /// formats need it empty. Throws ResourceError beyond the driver's limit or out of memory.
    Texture(Format format, int width, int height, std::span<const float> texels = {});

    /// Replaces all texels.
    void update(std::span<const float> texels);

    /// Replaces whole rows from `first` on.
    void update_rows(int first, std::span<const float> texels);

    void bind(int unit) const;

    Format format() const noexcept { return format_; }
    int width() const noexcept { return width_; }
    int height() const noexcept { return height_; }

    /// The GL name, for calls that this class does not make.
    unsigned id() const noexcept { return name_.get(); }

private:
    Name name_{Kind::texture};
    Format format_;
    int width_, height_;
};

} // namespace isomotion::gpu
