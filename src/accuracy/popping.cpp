#include "accuracy/popping.h"

#include "render/renderer.h"

namespace isomotion::accuracy {

void Popping::add(const image::Frame& drawn, const roots::Truth& truth) {
    Seen now;
    for (const float verdict : drawn.find("verdict")->samples) {
        const auto v = render::Verdict(int(verdict));
        now.hit.push_back(v == render::Verdict::hit || v == render::Verdict::zero_gradient);
    }
    for (const roots::FirstRoot& root : truth.roots) {
        now.certain.push_back(root.answer == roots::Answer::hit    ? 1
                              : root.answer == roots::Answer::miss ? 0
                                                                   : -1);
    }
    if (last_.size() == 2) {
        const Seen &before = last_[0], &middle = last_[1];
        for (std::size_t k = 0; k < now.hit.size(); ++k) {
            const bool steady = now.certain[k] >= 0 && now.certain[k] == middle.certain[k] &&
                                now.certain[k] == before.certain[k];
            count_ += steady && before.hit[k] == now.hit[k] && middle.hit[k] != now.hit[k];
        }
        last_.erase(last_.begin());
    }
    last_.push_back(std::move(now));
}

} // namespace isomotion::accuracy
