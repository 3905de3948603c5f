#pragma once

#include "gpu/draw.h"
#include "gpu/name.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <span>

namespace isomotion::gpu {

/// A picture to show in a window: four sRGB codes per pixel, the top row first, shown unchanged.
class ScreenTexture {
public:
    /// How it is enlarged.
    enum class Enlarged { as_squares, smooth };

    /// Throws std::invalid_argument unless there are four codes per pixel, and ResourceError beyond
    /// the driver's limit.
    void update(int width, int height, std::span<const std::uint8_t> codes,
                Enlarged enlarged = Enlarged::as_squares);

    int width() const noexcept { return width_; }
    int height() const noexcept { return height_; }
    bool empty() const noexcept { return width_ == 0; }
    Enlarged enlarged() const noexcept { return enlarged_; }

    /// The GL name, for calls that this class does not make.
    unsigned id() const noexcept { return name_.get(); }

private:
    Name name_{Kind::texture};
    int width_ = 0, height_ = 0;
    Enlarged enlarged_ = Enlarged::as_squares;
};

/// Directs draws to the current context's window and fills all of its pixels with this colour.
void begin_screen(int width, int height, glm::vec3 color);

/// Fills a rectangle of the window with a picture, enlarged as the picture states.
void place(const ScreenTexture& picture, Rectangle where);

/// The codes of a pixel that is drawn but not yet shown: red, green, blue.
std::array<std::uint8_t, 3> drawn_pixel(int x, int y);

} // namespace isomotion::gpu
