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

// Where spans are few, each is counted at several times: events that are missed may undo each other
// before the middle or behind it.
constexpr std::size_t most_times = 15, times_of_all = most_spans;

// So many times in a span, evenly, never at its ends.
std::vector<double> times_in(formula::Interval span, std::size_t count) {
    std::vector<double> times;
    for (std::size_t k = 0; k < count; ++k) {
        const double part = (double(k) + 0.5) / double(count);
        const double time = span.lo + part * (span.hi - span.lo);
        const bool is_new = times.empty() || times.back() < time; // spans may have few doubles
        if (span.lo < time && time < span.hi && is_new) times.push_back(time);
    }
    return times;
}

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
    struct Moment {
        std::size_t span;
        double time;
        Answer answer = Answer::unknown;
    };
    std::vector<Moment> moments;
    const std::size_t count =
        spans.empty() ? 0 : std::clamp<std::size_t>(times_of_all / spans.size(), 1, most_times);
    for (std::size_t k = 0; k < spans.size(); ++k) {
        // An odd number has the middle among them.
        for (const double time : times_in(spans[k].time, count | 1)) moments.push_back({k, time});
    }
    base::share({moments.size(), how.threads, how.stopped, how.progress}, [&] {
        return [&](std::size_t m) {
            Moment& moment = moments[m];
            moment.answer = answer_of_grids(spans[moment.span].solid, moment.time, how);
        };
    });
    // One doubted moment of each span, so that a few spans do not take all proofs.
    std::vector<const Moment*> doubted;
    std::vector<int> agreeing(spans.size(), 0), differing(spans.size(), 0);
    for (const Moment& moment : moments) {
        agreeing[moment.span] += moment.answer == Answer::agrees;
        differing[moment.span] += moment.answer == Answer::differs;
        const bool is_first = doubted.empty() || doubted.back()->span != moment.span;
        if (moment.answer == Answer::differs && is_first && doubted.size() < most_proofs)
            doubted.push_back(&moment);
    }
    std::vector<std::optional<Betti>> proofs(doubted.size());
    base::share({doubted.size(), how.threads, how.stopped, {}},
                [&] { return [&](std::size_t d) { proofs[d] = how.frame(doubted[d]->time); }; });
    for (std::size_t d = 0; d < doubted.size(); ++d) {
        const Span& span = spans[doubted[d]->span];
        const auto& proof = proofs[d];
        if (!proof) continue;
        if (*proof != span.solid) {
            throw Error(Error::Code::internal,
                        fmt::format("isomotion contradicts itself: the events leave {} from {} s "
                                    "to {} s, and a proof of the frame at {} s has {}",
                                    in_words(span.solid), span.time.lo, span.time.hi,
                                    doubted[d]->time, in_words(*proof)));
        }
        // Grids are too coarse for this span.
        agreeing[doubted[d]->span] = 1;
        differing[doubted[d]->span] = 0;
    }
    int agree = 0;
    for (std::size_t k = 0; k < spans.size(); ++k) agree += agreeing[k] > 0 && differing[k] == 0;
    return {all_spans, agree};
}

} // namespace isomotion::topology
