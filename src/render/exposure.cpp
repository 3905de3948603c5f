#include "render/exposure.h"

#include <algorithm>
#include <utility>

#include "base/fingerprint.h"
#include "render/sample_pattern.h"

namespace isomotion::render {
namespace {

// Calls take(now, aim) for every picture of a frame, the one at its time first.
template<class Take> void for_each_picture(const scene::Scene& scene, int frame, Take&& take) {
    const scene::SceneAt first = scene::at(scene, scene.timeline.values(frame));
    for (const Sample& sample : sample_pattern(scene.output.samples)) {
        const double part = scene.camera.shutter * sample.part;
        if (part == 0) {
            take(first, sample.aim);
        } else {
            take(scene::at(scene, scene.timeline.values(frame, part)), sample.aim);
        }
    }
}

void add_record(const Picture& from, Picture& to) {
    for (std::size_t v = 0; v < to.verdicts.size(); ++v) to.verdicts[v] += from.verdicts[v];
    for (std::size_t k = 0; k < to.proofs.size(); ++k) to.proofs[k] += from.proofs[k];
    to.evaluations += from.evaluations;
    to.passes += from.passes;
    to.drawing += from.drawing;
}

// What the channel velocity needs, if it is asked for.
std::optional<Motion> motion_of(const Renderer& renderer, const scene::Scene& scene, int frame) {
    if (!renderer.needs_motion()) return {};
    return motion_about(scene, frame);
}

} // namespace

void Exposure::add(Picture picture) {
    ++count_;
    if (!first_) { // its own sum
        first_ = std::move(picture);
        return;
    }
    for (std::size_t c = 0; c < color_channels_; ++c) {
        const auto& from = picture.frame.channels[c].samples;
        const auto& first = first_->frame.channels[c].samples;
        if (count_ == 2) sums_[c].assign(first.begin(), first.end());
        std::transform(from.begin(), from.end(), sums_[c].begin(), sums_[c].begin(),
                       [](float sample, double sum) { return sum + double(sample); });
    }
    add_record(picture, *first_);
}

void Exposure::write_mean(Picture& into) const {
    if (count_ == 1) return;
    for (std::size_t c = 0; c < color_channels_; ++c) {
        std::transform(sums_[c].begin(), sums_[c].end(), into.frame.channels[c].samples.begin(),
                       [&](double sum) { return float(sum / count_); });
    }
}

Picture Exposure::mean() const& {
    Picture picture = first_.value();
    write_mean(picture);
    return picture;
}

Picture Exposure::mean() && {
    write_mean(first_.value());
    return std::move(*first_);
}

Picture expose(Renderer& renderer, const scene::Scene& scene, int frame) {
    const int count = scene.output.samples;
    const std::optional<Motion> motion = motion_of(renderer, scene, frame);
    if (count == 1) {
        return renderer.draw(scene::at(scene, scene.timeline.values(frame)), {},
                             motion ? &*motion : nullptr);
    }
    Exposure exposure;
    for_each_picture(scene, frame, [&](const scene::SceneAt& now, const scene::Aim& aim) {
        const bool is_first = exposure.count() + renderer.in_flight() == 0;
        renderer.start(now, aim, motion && is_first ? &*motion : nullptr);
        // Taking one may find that others of the scene cannot overlap.
        while (renderer.in_flight() >= renderer.most_in_flight()) exposure.add(renderer.take());
    });
    while (renderer.in_flight() > 0) exposure.add(renderer.take());
    return std::move(exposure).mean();
}

bool ask(Renderer& renderer, const scene::Scene& scene, int frame) {
    if (scene.output.samples > 1 || renderer.needs_motion() || renderer.most_in_flight() < 2) {
        return false;
    }
    renderer.start(scene::at(scene, scene.timeline.values(frame)));
    return true;
}

std::string fingerprint(const Renderer& renderer, const scene::Scene& scene, int frame) {
    const std::optional<Motion> motion = motion_of(renderer, scene, frame);
    const scene::SceneAt first = scene::at(scene, scene.timeline.values(frame));
    std::string of_first = renderer.fingerprint(first, {}, motion ? &*motion : nullptr);
    if (scene.output.samples == 1) return of_first;
    base::Fingerprint print;
    print.add(of_first);
    for_each_picture(scene, frame, [&](const scene::SceneAt& now, const scene::Aim& aim) {
        print.add(renderer.fingerprint(now, aim));
    });
    return print.text();
}

void check_exposure(const scene::Scene& scene, int frame) {
    for_each_picture(scene, frame, [](const scene::SceneAt&, const scene::Aim&) {});
}

} // namespace isomotion::render
