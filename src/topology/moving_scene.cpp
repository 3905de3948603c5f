#include "topology/moving_scene.h"

#include <algorithm>
#include <memory>

namespace isomotion::topology {

using formula::Interval;

MovingScene::MovingScene(const scene::OneSurface& one, Side solid, Interval range)
    : MovingScene(motions(one, solid, range, Clock::time)) {}

MovingScene::MovingScene(const Motions& all) {
    for (const Motion& piece : all.pieces) pieces_.emplace_back(piece);
    if (all.at_end) at_end_.emplace(*all.at_end);
}

const TimedFormula& MovingScene::piece_at(Interval time) const {
    if (at_end_ && time.lo == at_end_->clock().hi) return *at_end_;
    const auto now = std::ranges::find_if(
        pieces_, [&](const TimedFormula& piece) { return contains(piece.clock(), mid(time)); });
    return now == pieces_.end() ? pieces_.back() : *now;
}

MovingScene::Still MovingScene::at(Interval time) const {
    const TimedFormula& piece = piece_at(time);
    Still frame{piece.formula(), piece.bounds(mid(time))};
    frame.formula.bindings = piece.bindings(time);
    return frame;
}

CertifiedFrame MovingScene::certify(double time, const FrameLimits& limits) const {
    if (!(pieces_.front().clock().lo <= time && time <= pieces_.back().clock().hi))
        return {.betti = {}, .why = "the time is outside of the range", .where = {}};
    const Still frame = at(time);
    return certify_frame(frame.formula, frame.bounds, limits);
}

KindProofs MovingScene::proofs(std::vector<Event> events, const PathOptions& seeking,
                               const FrameLimits& limits) const {
    KindProofs proofs;
    const auto paths = std::make_shared<EventPaths>(pieces_, std::move(events));
    proofs.paths = [paths, seeking](std::span<const std::size_t> which, int effort) {
        PathOptions how = seeking;
        how.effort = effort;
        return paths->seek(which, how);
    };
    proofs.frame = [this, limits](double time) { return certify(time, limits).betti; };
    return proofs;
}

} // namespace isomotion::topology
