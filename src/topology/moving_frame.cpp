#include "topology/moving_frame.h"

#include <algorithm>
#include <memory>

namespace isomotion::topology {

using formula::Interval;

MovingFrames::MovingFrames(const scene::Scene& scene, Side solid, Interval range) {
    for (const Motion& piece : motions(scene, solid, range, Clock::time).pieces)
        pieces_.emplace_back(piece);
}

std::size_t MovingFrames::piece_at(Interval time) const {
    const auto now = std::ranges::find_if(
        pieces_, [&](const TimedFormula& piece) { return contains(piece.clock(), mid(time)); });
    return std::min(std::size_t(now - pieces_.begin()), pieces_.size() - 1);
}

MovingFrames::Frame MovingFrames::at(Interval time) const {
    const TimedFormula& piece = pieces_[piece_at(time)];
    Frame frame{piece.formula(), piece.bounds(mid(time))};
    frame.formula.bindings = piece.bindings(time);
    return frame;
}

CertifiedFrame MovingFrames::certify(double time, const FrameLimits& limits) const {
    const Frame frame = at(time);
    return certify_frame(frame.formula, frame.bounds, limits);
}

KindProofs MovingFrames::proofs(std::vector<Event> events, const SeekingPaths& seeking,
                                const FrameLimits& limits) const {
    KindProofs proofs;
    const auto paths = std::make_shared<EventPaths>(pieces_, std::move(events));
    proofs.paths = [paths, seeking](std::span<const std::size_t> which, int effort) {
        SeekingPaths how = seeking;
        how.effort = effort;
        return paths->seek(which, how);
    };
    proofs.frame = [this, limits](double time) { return certify(time, limits).betti; };
    return proofs;
}

} // namespace isomotion::topology
