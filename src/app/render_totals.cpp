#include "app/render_totals.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "animation/frame_range.h"

namespace isomotion::app {
namespace {

std::string frames(std::size_t count) {
    return fmt::format("{} frame{}", count, count == 1 ? "" : "s");
}

} // namespace

void RenderTotals::add(const render::Picture& picture) {
    for (std::size_t v = 0; v < verdicts.size(); ++v) verdicts[v] += picture.verdicts[v];
    for (std::size_t k = 0; k < proofs.size(); ++k) proofs[k] += picture.proofs[k];
    evaluations += picture.evaluations;
    drawing += picture.drawing;
    ++drawn;
}

std::string RenderTotals::summary(std::chrono::duration<double> wall) const {
    std::string text;
    if (drawn > 0) {
        const auto rays = std::accumulate(verdicts.begin(), verdicts.end(), std::int64_t(0));
        text += fmt::format("drawn {} in {:.2f} s ({:.1f} ms each, {:.1f} evaluations a ray); all "
                            "of it took {:.2f} s, {:.2f} times the drawing\n",
                            drawn, drawing.count(), 1e3 * drawing.count() / drawn,
                            double(evaluations) / double(rays), wall.count(), wall / drawing);
        text += "rays:";
        for (std::size_t v = 0; v < verdicts.size(); ++v) {
            text +=
                fmt::format("{} {} {}", v == 0 ? "" : ",", verdicts[v], render::verdict_names[v]);
        }
        text += "\n";
        const bool certified = std::ranges::any_of(proofs, [](auto count) { return count > 0; });
        if (certified) text += render::summary(proofs) + "\n";
    }
    if (reused > 0) text += frames(std::size_t(reused)) + " equal to the one before\n";
    std::string reasons;
    for (const auto& [standing, which] : found) {
        if (standing == sequence::Standing::whole) {
            text += frames(which.size()) + " kept from an earlier run\n";
        } else {
            reasons += fmt::format("{}{} {} ({})", reasons.empty() ? "" : "; ", which.size(),
                                   name(standing), animation::frame_range(which));
        }
    }
    if (!reasons.empty()) text += fmt::format("not kept: {}\n", reasons);
    return text;
}

} // namespace isomotion::app
