#include "player/ui/picture_area.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <imgui.h>

#include "player/model/orbit.h"
#include "player/ui/theme.h"

namespace isomotion::player {
namespace {

constexpr double wheel_notch = 0.12; // of the distance, as a logarithm

ImTextureID handle(const gpu::ScreenTexture& texture) {
    return reinterpret_cast<ImTextureID>(std::uintptr_t(texture.id()));
}

void upload(gpu::ScreenTexture& texture, const Raster& raster, glm::ivec2 shown_size) {
    if (raster.rgba.empty()) return;
    using Enlarged = gpu::ScreenTexture::Enlarged;
    const bool whole = glm::ivec2(raster.width, raster.height) == shown_size;
    texture.update(raster.width, raster.height, raster.rgba,
                   whole ? Enlarged::as_squares : Enlarged::smooth);
}

// Grey squares, seen through a picture that is transparent.
void draw_squares(ImDrawList& list, ImVec2 from, ImVec2 to) {
    const float side = 12;
    list.AddRectFilled(from, to, IM_COL32(92, 92, 95, 255));
    for (int row = 0; from.y + side * float(row) < to.y; ++row) {
        for (int column = row % 2; from.x + side * float(column) < to.x; column += 2) {
            const ImVec2 corner{from.x + side * float(column), from.y + side * float(row)};
            list.AddRectFilled(corner,
                               {std::min(corner.x + side, to.x), std::min(corner.y + side, to.y)},
                               IM_COL32(116, 116, 120, 255));
        }
    }
}

bool has_holes(const Raster& raster) {
    for (std::size_t k = 3; k < raster.rgba.size(); k += 4) {
        if (raster.rgba[k] != 255) return true;
    }
    return false;
}

} // namespace

void PictureArea::take(Shown shown) {
    upload(picture_, shown.raster, size_);
    upload(left_, shown.left, size_);
    upload(right_, shown.right, size_);
    shown_ = std::move(shown);
    holes_ = has_holes(shown_->raster);
}

std::optional<PlacedPicture> PictureArea::plain() const {
    if (!shown_ || shown_->difference || holes_) return std::nullopt;
    return PlacedPicture{&picture_, corner_, size_};
}

void PictureArea::show(glm::ivec2 size, bool map) {
    const ImVec2 corner = ImGui::GetWindowPos();
    const ImVec2 area = ImGui::GetWindowSize();
    const ImVec2 pixel = ImGui::GetIO().DisplayFramebufferScale; // pixels a unit of the screen
    size_ = size;
    const auto middle = [](float from, float length, float scale, int side) {
        return int(std::floor(from * scale + std::max(0.0f, (length * scale - float(side)) / 2)));
    };
    corner_ = {middle(corner.x, area.x, pixel.x, size.x),
               middle(corner.y, area.y, pixel.y, size.y)};
    if (!shown_ || plain()) return;
    const ImVec2 low{float(corner_.x) / pixel.x, float(corner_.y) / pixel.y};
    const ImVec2 high{float(corner_.x + size.x) / pixel.x, float(corner_.y + size.y) / pixel.y};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (shown_->difference) {
        show_split(map);
        return;
    }
    draw_squares(list, low, high);
    list.AddImage(handle(picture_), low, high);
}

void PictureArea::show_split(bool map) {
    const ImVec2 pixel = ImGui::GetIO().DisplayFramebufferScale;
    const ImVec2 low{float(corner_.x) / pixel.x, float(corner_.y) / pixel.y};
    const float width = float(size_.x) / pixel.x, height = float(size_.y) / pixel.y;
    const ImVec2 high{low.x + width, low.y + height};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float x = low.x + split_ * width;
    list.AddImage(handle(left_), low, {x, high.y}, {0, 0}, {split_, 1});
    list.AddImage(handle(map ? picture_ : right_), {x, low.y}, high, {split_, 0}, {1, 1});
    const float mouse = ImGui::GetIO().MousePos.x;
    const bool near = splitting_ || (ImGui::IsItemHovered() && std::abs(mouse - x) < 6);
    list.AddLine({x, low.y}, {x, high.y}, near ? accent_color() : text_color(), near ? 3.0f : 1.5f);
    if (near) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
}

glm::dvec2 PictureArea::in_heights(float x, float y) const {
    const ImVec2 pixel = ImGui::GetIO().DisplayFramebufferScale;
    const glm::dvec2 at{x * pixel.x, y * pixel.y};
    const glm::dvec2 middle = glm::dvec2(corner_) + 0.5 * glm::dvec2(size_);
    return glm::dvec2(at.x - middle.x, middle.y - at.y) / double(std::max(size_.y, 1));
}

std::optional<scene::CameraAt> PictureArea::steer(const scene::CameraAt& camera) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool over = ImGui::IsItemHovered();
    const bool active = ImGui::IsItemActive();
    if (shown_ && shown_->difference) {
        const double x = in_heights(io.MousePos.x, 0).x * size_.y / size_.x + 0.5;
        if (ImGui::IsItemActivated() && std::abs(x - double(split_)) * size_.x < 8) {
            splitting_ = true;
        }
        if (!active) splitting_ = false;
        if (splitting_) {
            split_ = float(std::clamp(x, 0.0, 1.0));
            held_ = false;
            return std::nullopt;
        }
    }
    const bool pans = active && (ImGui::IsMouseDown(ImGuiMouseButton_Middle) ||
                                 ImGui::IsMouseDown(ImGuiMouseButton_Right) || io.KeyShift);
    const bool orbits = active && !pans && ImGui::IsMouseDown(ImGuiMouseButton_Left);
    held_ = pans || orbits;
    const glm::dvec2 here = in_heights(io.MousePos.x, io.MousePos.y);
    const glm::dvec2 drag =
        here - in_heights(io.MousePos.x - io.MouseDelta.x, io.MousePos.y - io.MouseDelta.y);
    if (held_ && (drag.x != 0 || drag.y != 0)) {
        return pans ? panned(camera, drag) : orbited(camera, drag);
    }
    if (over && io.MouseWheel != 0) {
        return dollied(camera, wheel_notch * double(io.MouseWheel), here);
    }
    return std::nullopt;
}

} // namespace isomotion::player
