// Shows the picture, and moves the camera by the mouse.
#pragma once

#include <optional>
#include <string>

#include <glm/glm.hpp>

#include "gpu/screen.h"
#include "player/draw/draw_thread.h"
#include "player/ui/window.h"
#include "scene/scene_at.h"

namespace isomotion::player {

class PictureArea {
public:
    // Receives a picture; the window's context must be current.
    void take(Shown shown);
    const std::optional<Shown>& shown() const { return shown_; }

    // Shows the last picture, unless it is plain(), in the middle of Dear ImGui's current window,
    // `size` pixels large. In View::difference the first method is left of the line; right of it is
    // the second method, or the `map` of the differences.
    void show(glm::ivec2 size, bool map);
    // Returns the camera after the mouse moved it; none if it did not.
    std::optional<scene::CameraAt> steer(const scene::CameraAt& camera);
    // Whether a button that moves the camera is held.
    bool held() const { return held_; }

    // The picture, if it is opaque and the only one. Then the window draws it, and show() does not.
    std::optional<PlacedPicture> plain() const;
    // Upper left corner of the picture shown last, in pixels of the window.
    glm::ivec2 corner() const { return corner_; }
    glm::ivec2 size() const { return size_; }

private:
    void show_split(bool map);
    glm::dvec2 in_heights(float x, float y) const; // from the picture's centre, to the right and up

    std::optional<Shown> shown_;
    gpu::ScreenTexture picture_, left_, right_;
    glm::ivec2 corner_{0}, size_{1};
    float split_ = 0.5f;
    bool held_ = false, splitting_ = false, holes_ = false;
};

} // namespace isomotion::player
