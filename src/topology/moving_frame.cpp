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

KindProofs MovingFrames::proofs(const FrameLimits& limits) const {
    KindProofs proofs;
    // One field a piece: making its programs takes longer than most paths.
    const auto fields = std::make_shared<std::vector<std::shared_ptr<FrameField>>>(pieces_.size());
    proofs.moment = [this, fields](const Event& event) {
        const std::size_t k = piece_at(event.time);
        std::shared_ptr<FrameField>& field = (*fields)[k];
        if (!field) field = std::make_shared<FrameField>(pieces_[k].formula());
        field->bind(pieces_[k].bindings(event.time));
        return field_moment(field, pieces_[k].bounds(mid(event.time)));
    };
    proofs.frame = [this, limits](double time) { return certify(time, limits).betti; };
    return proofs;
}

} // namespace isomotion::topology
