#include "player/model/session.h"

#include <algorithm>
#include <utility>

#include "player/model/camera_override.h"
#include "player/model/held_steps.h"

namespace isomotion::player {
namespace {

// A picture at rest has so many samples where the scene itself asks for fewer.
constexpr int smooth_samples = 16;

// The most different method at hand: the paper's.
scene::Isolation beside(const scene::Isolation& isolation) {
    scene::Isolation other = isolation;
    other.method = isolation.method == scene::Method::amp_sign ? scene::Method::hermite
                                                               : scene::Method::amp_sign;
    return other;
}

} // namespace

Session::Session(scene::Scene scene)
    : playback(playback_of(scene.timeline))
    , scene_(std::make_shared<const scene::Scene>(std::move(scene))) {
    size_ = {scene_->output.width, scene_->output.height};
    look_.isolation = scene_->surfaces.front().isolation;
    look_.other = beside(look_.isolation);
    study();
}

void Session::study() {
    slider_ranges_.clear();
    for (std::size_t k = 0; k < scene_->surfaces.size(); ++k)
        slider_ranges_.push_back(player::slider_ranges({*scene_, k}));
    key_markers_ = player::key_markers(*scene_);
    hold();
    set(look_);
}

void Session::reload(scene::Scene scene, double now) {
    const std::shared_ptr<const scene::Scene> before = scene_;
    playback = moved_to(playback, before->timeline, scene.timeline, now);
    scene_ = std::make_shared<const scene::Scene>(std::move(scene));
    const scene::Isolation &was = before->surfaces.front().isolation,
                           &is = scene_->surfaces.front().isolation;
    if (look_.isolation == was) look_.isolation = is;
    if (look_.other == beside(was)) look_.other = beside(is);
    study();
}

void Session::set(const Look& look) {
    const bool holds_others = look.overrides != look_.overrides;
    look_ = look;
    if (holds_others) hold();
    ++revision_;
    move();
}

void Session::hold() {
    held_ = look_.overrides.empty() ? *scene_ : with_own_steps(apply(*scene_, look_.overrides));
}

void Session::set_size(glm::ivec2 size) {
    size_ = size;
    overridden_.output.width = size.x;
    overridden_.output.height = size.y;
}

void Session::move() {
    overridden_ = held_;
    if (look_.camera) overridden_ = with_camera(std::move(overridden_), *look_.camera);
    set_size(size_);
}

scene::SceneAt Session::at(std::int64_t frame, double part) const {
    return scene::at_frame(overridden_, frame, part);
}

int Session::samples() const {
    const int own = scene_->output.samples;
    if (look_.view != View::shaded) return 1; // of channels there is no mean
    return look_.smooth ? std::max(own, smooth_samples) : own;
}

} // namespace isomotion::player
