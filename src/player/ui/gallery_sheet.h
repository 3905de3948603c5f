// The pictures of all installed animations on one sheet, media/gallery.png: what the gallery shows
// of an animation until it has drawn it itself. tools/gallery makes the sheet.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "gpu/screen.h"

namespace isomotion::player {

// How tools/gallery lays out the sheet, in pixels: rows of pictures, each with a caption below it.
namespace gallery_sheet {
inline constexpr int columns = 9, side = 128, caption = 18, margin = 4;
// The upper left pixel of a picture, counted from the sheet's upper left one.
std::array<int, 2> corner(std::size_t picture);
// Width and height of a sheet of so many pictures.
std::array<int, 2> size(std::size_t pictures);
} // namespace gallery_sheet

class GallerySheet {
public:
    // Loads the sheet. Without one, or with one of another number of pictures, there is none to
    // show.
    explicit GallerySheet(std::size_t pictures);

    struct Part {
        unsigned texture;                // its GL name
        std::array<float, 2> begin, end; // from (0, 0) at the sheet's upper left corner to (1, 1)
    };
    std::optional<Part> part(std::size_t picture) const;

private:
    gpu::ScreenTexture sheet_;
};

} // namespace isomotion::player
