#include "player/draw/frame_scheduler.h"

#include <algorithm>
#include <cmath>

#include "render/sample_pattern.h"
#include "scene/light_points.h"

namespace isomotion::player {
namespace {

// After the last change the picture is refined: later than a wheel's next notch, sooner than a
// person looks closer.
constexpr double rests_after = 0.15;

// A new request waits so long for the picture in flight, and then has it given up.
constexpr double longest_wait = 0.1;

// If a whole picture at rest takes more seconds than this, the picture grows towards it.
constexpr double grows_from = 0.25;

// Rays of a picture at rest.
constexpr int most_audited = 16'384;

// The cost of a scene's first picture is unknown, so it has an eighth of the pixels.
constexpr int first_rung = 6;

} // namespace

glm::ivec2 fitted_size(glm::ivec2 area, double aspect) {
    const double height = std::min(double(area.y), area.x / aspect);
    return glm::max(glm::ivec2(1),
                    glm::ivec2(int(std::lround(height * aspect)), int(std::lround(height))));
}

void FrameScheduler::begin_scene() {
    resolution_ = {};
    resolution_.rung = first_rung;
    subject_.reset();
    wanted_.reset();
    begin_ = number_ + 1;
}

void FrameScheduler::post(const Session& session, const Subject& subject, double scale, int samples,
                          bool may_be_dropped, double now) {
    came_ = false;
    posted_ = now;
    scale_ = scale;
    Request request;
    request.number = ++number_;
    request.scene = session.shared_scene();
    request.isolation = session.look().isolation;
    request.view = session.look().view;
    if (request.view == View::difference) request.other = session.look().other;
    request.scale = scale;
    const glm::ivec2 size = subject.size;
    request.width = std::max(1, int(std::lround(size.x * scale)));
    request.height = std::max(1, int(std::lround(size.y * scale)));
    request.frame = subject.frame;
    request.may_be_dropped = may_be_dropped;
    request.audited = whole_ ? most_audited : 0;
    request.asked_at = noticed_.value_or(std::chrono::steady_clock::now());
    noticed_.reset();
    const double shutter = session.scene().camera.shutter;
    const auto first = std::make_shared<const scene::SceneAt>(session.at(request.frame));
    for (const render::Sample& sample : render::sample_pattern(samples)) {
        const double part = shutter * sample.part;
        auto moment = part == 0
                          ? first
                          : std::make_shared<const scene::SceneAt>(session.at(request.frame, part));
        if (scene::is_lit_by_discs(*moment)) {
            moment =
                std::make_shared<const scene::SceneAt>(scene::lit_from(*moment, sample.aim.lens));
        }
        request.samples.push_back({moment, sample.aim});
    }
    thread_.draw(std::move(request));
}

// The scale of the next picture at rest, after one of the last request's scale. Pictures that grow
// cost a third more in all.
double FrameScheduler::next_scale(int samples) const {
    const double whole = 1e-3 * samples * resolution_.model.at(1);
    return whole > grows_from ? std::min(2 * scale_, 1.0) : 1;
}

bool FrameScheduler::holds_back(double now) const {
    return subject_ && !came_ && !whole_ && !grows_ && now - posted_ < longest_wait;
}

void FrameScheduler::ask(Session& session, std::int64_t frame, glm::ivec2 size, double now,
                         bool hand_rests) {
    hand_rests_ = hand_rests;
    const Subject wanted{session.revision(), frame, size};
    if (wanted_ != wanted) {
        session.set_size(size);
        wanted_ = wanted;
        changed_ = now;
        if (!noticed_) noticed_ = std::chrono::steady_clock::now();
    }
    if (subject_ != wanted) {
        if (holds_back(now)) return;
        subject_ = wanted;
        whole_ = grows_ = false;
        post(session, wanted, resolution_.scale(), 1, false, now);
        return;
    }
    const bool rests = hand_rests && now - changed_ >= rests_after;
    if (whole_ || !came_ || !rests) return;
    const double next = next_scale(session.samples());
    whole_ = next == 1;
    grows_ = true;
    post(session, wanted, next, whole_ ? session.samples() : 1, true, now);
}

void FrameScheduler::learn(const Shown& shown, double display, double now) {
    if (shown.number < begin_) return; // another scene's
    if (!shown.compiled && shown.asked == 1) {
        resolution_ = adjusted(resolution_,
                               {shown.scale, 1e3 * shown.took.count(), now, 1e3 * display}, rate);
    }
    if (shown.number == number_ && shown.samples == shown.asked) came_ = true;
}

void FrameScheduler::learn(const GivenUp& picture, double display, double now) {
    if (picture.number < begin_) return;
    resolution_ = adjusted(resolution_,
                           {picture.scale, 1e3 * picture.took.count(), now, 1e3 * display}, rate);
}

std::optional<double> FrameScheduler::next_change() const {
    if (subject_ != wanted_) return posted_ + longest_wait; // held back
    if (!subject_ || whole_ || !came_ || !hand_rests_) return std::nullopt;
    return changed_ + rests_after;
}

} // namespace isomotion::player
