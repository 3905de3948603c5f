#include "player/ui/gallery_sheet.h"

#include <stdexcept>

#include "image/decode.h"
#include "player/draw/views.h"
#include "scene/data_folder.h"

namespace isomotion::player {
namespace gallery_sheet {

std::array<int, 2> corner(std::size_t picture) {
    const int row = int(picture) / columns, column = int(picture) % columns;
    return {margin + column * (side + margin), margin + row * (side + caption + margin)};
}

std::array<int, 2> size(std::size_t pictures) {
    const int rows = (int(pictures) + columns - 1) / columns;
    return {margin + columns * (side + margin), margin + rows * (side + caption + margin)};
}

} // namespace gallery_sheet

GallerySheet::GallerySheet(std::size_t pictures) {
    try {
        const image::Frame frame = image::decode(scene::media_file("gallery.png"));
        if (gallery_sheet::size(pictures) != std::array{frame.width, frame.height}) return;
        sheet_.update(frame.width, frame.height, shaded(frame).rgba,
                      gpu::ScreenTexture::Enlarged::smooth);
    } catch (const std::runtime_error&) { // the gallery draws all pictures
    }
}

std::optional<GallerySheet::Part> GallerySheet::part(std::size_t picture) const {
    if (sheet_.empty()) return std::nullopt;
    const auto [x, y] = gallery_sheet::corner(picture);
    const auto at = [&](int right, int down) {
        return std::array{float(right) / float(sheet_.width()),
                          float(down) / float(sheet_.height())};
    };
    return Part{sheet_.id(), at(x, y), at(x + gallery_sheet::side, y + gallery_sheet::side)};
}

} // namespace isomotion::player
