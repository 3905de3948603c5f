#include <algorithm>

#include "api/scene/errors.h"
#include "api/scene/parts.h"
#include "roots/certify.h"
#include "scene/scene_at.h"

namespace isomotion {
namespace {

FirstRoot::Answer answer_of(roots::Answer answer) {
    switch (answer) {
    case roots::Answer::miss:
        return FirstRoot::Answer::miss;
    case roots::Answer::hit:
        return FirstRoot::Answer::hit;
    case roots::Answer::touching:
        return FirstRoot::Answer::touching;
    case roots::Answer::undecided:
        break;
    }
    return FirstRoot::Answer::undecided;
}

FirstRoot root_of(const roots::FirstRoot& found) {
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
        if (std::max(width, height) > largest_side)
            throw Error(Error::Code::limit, "a picture has at most 16384 pixels a side");
        const scene::Scene& all = scene.parts().scene;
        roots::Certifying how;
        how.progress = [&](double part) {
            if (watcher.stop && watcher.stop()) api::throw_stopped();
            if (watcher.progress) watcher.progress("first roots", part);
        };
        const roots::Truth truth = roots::certify(
            all, scene::at_frame(all, api::checked_frame(frame)), width, height, how);
        std::vector<FirstRoot> roots;
        roots.reserve(truth.roots.size());
        for (const roots::FirstRoot& found : truth.roots) roots.push_back(root_of(found));
        return roots;
    });
}

} // namespace isomotion
