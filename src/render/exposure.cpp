#include "render/exposure.h"

#include <algorithm>
#include <utility>

#include "render/frame_pictures.h"

namespace isomotion::render {
namespace {

void add_record(const Picture& from, Picture& to) {
    for (std::size_t v = 0; v < to.verdicts.size(); ++v) to.verdicts[v] += from.verdicts[v];
    for (std::size_t k = 0; k < to.proofs.size(); ++k) to.proofs[k] += from.proofs[k];
    add(from.rays, to.rays);
    to.passes += from.passes;
    to.drawing += from.drawing;
}

} // namespace

void Exposure::add(Picture picture) {
    if (++count_ == 1) { // its own sum
        first_ = std::move(picture);
        return;
    }
    for (std::size_t c = 0; c < color_channels_; ++c) {
        const auto& from = picture.frame.channels[c].samples;
        const auto& first = first_.frame.channels[c].samples;
        if (count_ == 2) sums_[c].assign(first.begin(), first.end());
        std::transform(from.begin(), from.end(), sums_[c].begin(), sums_[c].begin(),
                       [](float sample, double sum) { return sum + double(sample); });
    }
    add_record(picture, first_);
}

void Exposure::write_mean(Picture& into) const {
    if (count_ <= 1) return;
    for (std::size_t c = 0; c < color_channels_; ++c) {
        std::transform(sums_[c].begin(), sums_[c].end(), into.frame.channels[c].samples.begin(),
                       [&](double sum) { return float(sum / count_); });
    }
}

Picture Exposure::mean() const& {
    Picture picture = first_;
    write_mean(picture);
    return picture;
}

Picture Exposure::mean() && {
    write_mean(first_);
    return std::move(first_);
}

Picture expose(Renderer& renderer, const FrameInputs& frame) {
    if (frame.pictures.size() == 1) return renderer.draw(frame.pictures.front());
    Exposure exposure;
    for (const PictureInputs& picture : frame.pictures) {
        renderer.start(picture);
        // Taking one may find that others of the scene cannot overlap.
        while (renderer.in_flight() >= renderer.most_in_flight()) exposure.add(renderer.take());
    }
    while (renderer.in_flight() > 0) exposure.add(renderer.take());
    return std::move(exposure).mean();
}

Picture expose(Renderer& renderer, const scene::Scene& scene, int frame) {
    return expose(renderer, renderer.prepare(scene, frame));
}

bool ask(Renderer& renderer, const FrameInputs& frame) {
    const bool is_plain = frame.pictures.size() == 1 && !frame.pictures.front().moving;
    if (!is_plain || renderer.most_in_flight() < 2) return false;
    renderer.start(frame.pictures.front());
    return true;
}

void check_exposure(const scene::Scene& scene, int frame) {
    for_each_picture(scene, frame, [](const scene::SceneAt&, const scene::Aim&) {});
}

} // namespace isomotion::render
