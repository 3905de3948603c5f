// A frame as the mean of pictures, each with its own place in the pixel, point of the lens and time
// while the shutter is open. So one sum gives anti-aliasing, depth of field and motion blur.
//
// After Haeberli and Akeley, "The accumulation buffer" (1990). With one sample, a frame equals the
// picture that Renderer::draw makes, bit for bit.
#pragma once

#include "render/renderer.h"

namespace isomotion::render {

// The pictures of one frame, added one by one.
class Exposure {
public:
    void add(Picture picture);
    int count() const { return count_; }
    // The frame after the pictures added so far, at least one. Channels without a mean (depth, a
    // normal, a verdict) are those of the first picture; verdicts, evaluations, passes and the time
    // of drawing are sums. After one picture it equals that picture, bit for bit.
    Picture mean() const&;
    Picture mean() &&;

private:
    void write_mean(Picture& into) const;

    static constexpr std::size_t color_channels_ = 4; // R G B A, a frame's first
    Picture first_;
    // In double the sum of up to 2^29 equal floats is exact, so a flat region keeps its colour.
    std::array<std::vector<double>, color_channels_> sums_;
    int count_ = 0;
};

// Draws a frame. R, G, B and A are the means over its pictures, in linear light and premultiplied.
// Channels without a mean (depth, a normal, a verdict) are those of the first picture: at pixel
// centres, seen from the eye at the frame's time. Verdicts, evaluations, passes and the time of
// drawing are sums over all pictures.
Picture expose(Renderer& renderer, const FrameInputs& frame);
// Evaluates the frame first. Throws SceneError if a value leaves its range while the shutter is
// open.
Picture expose(Renderer& renderer, const scene::Scene& scene, int frame);

// Starts a frame of one picture if another may be in flight meanwhile; renderer.take() returns it.
// If the result is false, nothing was started, and expose() draws the frame.
bool ask(Renderer& renderer, const FrameInputs& frame);

// Throws the SceneError that expose would throw.
void check_exposure(const scene::Scene& scene, int frame);

} // namespace isomotion::render
