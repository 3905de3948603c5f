#include "render/exposure.h"

#include <algorithm>
#include <utility>

#include "render/sample_pattern.h"
#include "scene/fingerprint.h"

namespace isomotion::render {
namespace {

constexpr std::size_t color_channels = 4; // R G B A, a frame's first

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

// In double the sum of up to 2^29 equal floats is exact: a flat region keeps its colour.
class ColorSum {
public:
    void add(const image::Frame& frame) {
        for (std::size_t c = 0; c < color_channels; ++c) {
            const auto& from = frame.channels[c].samples;
            sums_[c].resize(from.size());
            std::transform(from.begin(), from.end(), sums_[c].begin(), sums_[c].begin(),
                           [](float sample, double sum) { return sum + double(sample); });
        }
    }
    void write_mean(int count, image::Frame& frame) const {
        for (std::size_t c = 0; c < color_channels; ++c) {
            std::transform(sums_[c].begin(), sums_[c].end(), frame.channels[c].samples.begin(),
                           [&](double sum) { return float(sum / count); });
        }
    }

private:
    std::array<std::vector<double>, color_channels> sums_;
};

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

Picture expose(Renderer& renderer, const scene::Scene& scene, int frame) {
    const int count = scene.output.samples;
    const std::optional<Motion> motion = motion_of(renderer, scene, frame);
    if (count == 1) {
        return renderer.draw(scene::at(scene, scene.timeline.values(frame)), {},
                             motion ? &*motion : nullptr);
    }
    std::optional<Picture> exposed;
    ColorSum sum;
    for_each_picture(scene, frame, [&](const scene::SceneAt& now, const scene::Aim& aim) {
        Picture picture = renderer.draw(now, aim, motion && !exposed ? &*motion : nullptr);
        sum.add(picture.frame);
        if (exposed) {
            add_record(picture, *exposed);
        } else {
            exposed = std::move(picture);
        }
    });
    sum.write_mean(count, exposed->frame);
    return std::move(*exposed);
}

std::string fingerprint(const Renderer& renderer, const scene::Scene& scene, int frame) {
    const std::optional<Motion> motion = motion_of(renderer, scene, frame);
    const scene::SceneAt first = scene::at(scene, scene.timeline.values(frame));
    const std::string of_first = renderer.fingerprint(first, {}, motion ? &*motion : nullptr);
    if (scene.output.samples == 1) return of_first;
    scene::Fingerprint print;
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
