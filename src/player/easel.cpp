#include "player/easel.h"

#include <algorithm>
#include <cmath>

#include "render/sample_pattern.h"

namespace isomotion::player {
namespace {

// After the last change the picture is refined: later than a wheel's next notch, sooner than a
// person looks closer.
constexpr double rests_after = 0.15;

} // namespace

glm::ivec2 fitted_size(glm::ivec2 area, double aspect) {
    const double height = std::min(double(area.y), area.x / aspect);
    return glm::max(glm::ivec2(1),
                    glm::ivec2(int(std::lround(height * aspect)), int(std::lround(height))));
}

void Easel::begin_scene() {
    pacing_ = {};
    subject_.reset();
    begin_ = number_ + 1;
}

void Easel::post(const Session& session, double scale, int samples, bool may_be_dropped) {
    came_ = false;
    Request request;
    request.number = ++number_;
    request.scene = session.shared_scene();
    request.isolation = session.look().isolation;
    request.view = session.look().view;
    if (request.view == View::difference) request.other = session.look().other;
    request.scale = scale;
    const glm::ivec2 size = subject_->size;
    request.width = std::max(1, int(std::lround(size.x * scale)));
    request.height = std::max(1, int(std::lround(size.y * scale)));
    request.frame = subject_->frame;
    request.may_be_dropped = may_be_dropped;
    const double shutter = session.scene().camera.shutter;
    const auto first = std::make_shared<const scene::SceneAt>(session.at(request.frame));
    for (const render::Sample& sample : render::sample_pattern(samples)) {
        const double part = shutter * sample.part;
        const auto now =
            part == 0 ? first
                      : std::make_shared<const scene::SceneAt>(session.at(request.frame, part));
        request.samples.push_back({now, sample.aim});
    }
    thread_.draw(std::move(request));
}

void Easel::ask(Session& session, std::int64_t frame, glm::ivec2 size, double now,
                bool hand_rests) {
    hand_rests_ = hand_rests;
    const Subject wanted{session.revision(), frame, size};
    if (subject_ != wanted) {
        session.set_size(size);
        subject_ = wanted;
        changed_ = now;
        whole_ = false;
        post(session, pacing_.scale(), 1, false);
        return;
    }
    const bool rests = hand_rests && now - changed_ >= rests_after;
    if (whole_ || !came_ || !rests) return;
    whole_ = true;
    post(session, 1, session.samples(), true);
}

void Easel::learn(const Shown& shown) {
    if (shown.number < begin_) return; // another scene's
    if (!shown.compiled && shown.asked == 1) {
        pacing_ = paced(pacing_, {shown.scale, 1e3 * shown.took.count()}, rate);
    }
    if (shown.number == number_ && shown.samples == shown.asked) came_ = true;
}

void Easel::learn(const GivenUp& picture) {
    if (picture.number < begin_) return;
    pacing_ = paced(pacing_, {picture.scale, 1e3 * picture.took.count()}, rate);
}

std::optional<double> Easel::next_change() const {
    if (!subject_ || whole_ || !came_ || !hand_rests_) return std::nullopt;
    return changed_ + rests_after;
}

} // namespace isomotion::player
