#include <algorithm>

#include "api/scene/errors.h"
#include "api/scene/parts.h"
#include "scene/limits.h"
#include "scene/scene_at.h"
#include "truth/certify.h"

namespace isomotion {
namespace {

FirstRoot::Answer answer_of(truth::Answer answer) {
    switch (answer) {
    case truth::Answer::miss:
        return FirstRoot::Answer::miss;
    case truth::Answer::hit:
        return FirstRoot::Answer::hit;
    case truth::Answer::touching:
        return FirstRoot::Answer::touching;
    case truth::Answer::undecided:
        break;
    }
    return FirstRoot::Answer::undecided;
}

FirstRoot root_of(const truth::FirstRoot& found) {
    return {.answer = answer_of(found.answer),
            .root = {found.low, found.high},
            .touch = {found.touch_low, found.touch_high},
            .hit_behind = found.after_is_hit,
            .surface = found.surface};
}

} // namespace

std::vector<FirstRoot> first_roots(const Scene& scene, int frame, int width, int height,
                                   const Watcher& watcher) {
    return api::with_errors([&] {
        if (width < 1 || height < 1)
            throw Error(Error::Code::input, "a picture has at least one pixel");
        if (std::max(width, height) > scene::limits::picture_side)
            throw Error(Error::Code::limit, "a picture has at most 16384 pixels a side");
        const scene::Scene& all = scene.parts().scene;
        truth::Certifying how;
        how.progress = [&](double part) {
            if (watcher.stop && watcher.stop()) api::throw_stopped();
            if (watcher.progress) watcher.progress("first roots", part);
        };
        const truth::Truth truth = truth::certify(
            all, scene::at_frame(all, api::checked_frame(frame)), width, height, how);
        std::vector<FirstRoot> roots;
        roots.reserve(truth.roots.size());
        for (const truth::FirstRoot& found : truth.roots) roots.push_back(root_of(found));
        return roots;
    });
}

} // namespace isomotion
