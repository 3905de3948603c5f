#include "topology/classify/recount.h"

#include <algorithm>
#include <array>
#include <functional>
#include <vector>

#include <fmt/format.h>
#include <isomotion/error.h>

#include "base/workers.h"
#include "topology/timeline/steps.h"
#include "topology/timeline/words.h"

namespace isomotion::topology {
namespace {

// Vertices along each side of the grids that are asked, one after the other.
constexpr std::array sides{48, 96, 144};

// Where hundreds of events crowd, grids tell little of the short spans between them, and would take
// many times as long as the search: only the longest spans are counted. A frame's proof takes as
// long as hundreds of grids, and mostly fails close to events.
constexpr std::size_t most_spans = 100, most_proofs = 4;

enum class Answer {
    unknown, // grids tell this or that
    agrees,
    differs, // all grids tell the same, and not what the events do
};

Answer answer_of_grids(const Betti& claimed, double time, const Recounting& how) {
    std::optional<Betti> told;
    for (const int side : sides) {
        const std::optional<Betti> found = how.signs(time, side);
        if (found == claimed) return Answer::agrees;
        if (!found || (told && found != told)) return Answer::unknown;
        told = found;
    }
    return Answer::differs;
}

} // namespace

Recount recount(const Timeline& timeline, const Recounting& how) {
    struct Span {
        formula::Interval time;
        Betti solid;
    };
    std::vector<Span> spans;
    for (const Step& step : steps_of(timeline).steps) {
        const double time = mid(step.time);
        const bool has_inside = step.time.lo < time && time < step.time.hi;
        const auto& solid = step.solid;
        if (step.is_proved && solid && has_inside) spans.push_back({step.time, *solid});
    }
    const auto all_spans = int(spans.size());
    std::ranges::stable_sort(spans, std::greater{}, [](const Span& s) { return width(s.time); });
    if (spans.size() > most_spans) spans.resize(most_spans);
    std::vector<Answer> answers(spans.size(), Answer::unknown);
    base::share({spans.size(), how.threads, how.stopped, how.progress}, [&] {
        return [&](std::size_t k) {
            answers[k] = answer_of_grids(spans[k].solid, mid(spans[k].time), how);
        };
    });
    std::vector<std::size_t> doubted;
    for (std::size_t k = 0; k < spans.size() && doubted.size() < most_proofs; ++k) {
        if (answers[k] == Answer::differs) doubted.push_back(k);
    }
    std::vector<std::optional<Betti>> proofs(doubted.size());
    base::share({doubted.size(), how.threads, how.stopped, {}}, [&] {
        return [&](std::size_t d) { proofs[d] = how.frame(mid(spans[doubted[d]].time)); };
    });
    Recount all{all_spans, int(std::ranges::count(answers, Answer::agrees))};
    for (std::size_t d = 0; d < doubted.size(); ++d) {
        const Span& span = spans[doubted[d]];
        const auto& proof = proofs[d];
        if (!proof) continue;
        if (*proof != span.solid) {
            throw Error(Error::Code::internal,
                        fmt::format("isomotion contradicts itself: the events leave {} from {} s "
                                    "to {} s, and a proof of the frame at {} s has {}",
                                    in_words(span.solid), span.time.lo, span.time.hi,
                                    mid(span.time), in_words(*proof)));
        }
        ++all.agree;
    }
    return all;
}

} // namespace isomotion::topology
