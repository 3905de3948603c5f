#include "topology/analyse.h"

#include <algorithm>
#include <mutex>
#include <stdexcept>
#include <thread>

#include <fmt/format.h>

#include "base/workers.h"
#include "scene/error.h"
#include "topology/betti/frame_signs.h"
#include "topology/classify/recount.h"
#include "topology/field/common_solid.h"
#include "topology/moving_scene.h"
#include "topology/sampling.h"
#include "topology/search/arb_verifier.h"
#include "topology/search/critical.h"
#include "topology/timeline/advice.h"
#include "topology/timeline/unresolved_groups.h"

namespace isomotion::topology {
namespace {

using formula::Interval;

// Calls the caller back from one thread at a time, whichever threads search.
class SerialCallbacks {
public:
    explicit SerialCallbacks(const AnalyseOptions& how)
        : how_(how) {}

    bool stopped() const {
        const std::lock_guard lock(one_at_a_time_);
        return is_stopped();
    }
    void show(const char* what, double part) const {
        const std::lock_guard lock(one_at_a_time_);
        is_stopped();
        part_ = what_ == what ? std::max(part_, part) : part;
        what_ = what;
        if (how_.progress) how_.progress(what_, part_);
    }

private:
    bool is_stopped() const { return is_stopped_ = is_stopped_ || (how_.stop && how_.stop()); }

    const AnalyseOptions& how_;
    mutable std::mutex one_at_a_time_;
    mutable bool is_stopped_ = false;
    mutable std::string what_;
    mutable double part_ = 0; // of this
};

int threads_of(const AnalyseOptions& how) {
    return how.threads > 0 ? how.threads : std::max(1, int(std::thread::hardware_concurrency()));
}

// None where it was stopped.
std::optional<Betti> on_grid(const scene::OneSurface& one, const scene::SurfaceAt& now, Side side,
                             int grid, int threads, const SerialCallbacks& callbacks) {
    Work work([&] { return callbacks.stopped(); });
    const auto signs = FrameSigns(*one.surface.field, one.surface.animation.counts())
                           .at(now, side, grid, threads, work);
    return signs ? std::optional(betti(*signs)) : std::nullopt;
}

EventSearchOptions event_search(const AnalyseOptions& how, const SerialCallbacks& callbacks) {
    EventSearchOptions searching;
    searching.threads = threads_of(how);
    searching.stopped = [&] { return callbacks.stopped(); };
    searching.progress = [&](double part) { callbacks.show("events", part); };
    return searching;
}

// A sum that doesn't depend on kinds, so that events from seeds have it too.
void check_euler_number(Timeline& timeline) {
    if (!timeline.start || !timeline.end || !timeline.unresolved.empty()) return;
    int found = 0;
    for (const Event& event : timeline.events) found += euler_change(event);
    const int expected = timeline.end->euler() - timeline.start->euler();
    if (found == expected) return;
    timeline.doubts.push_back(
        fmt::format("events were missed, if the signs at both ends are right: these change the "
                    "Euler number by {}, from start to end it changes by {}",
                    found, expected));
}

// Seeds take all elements of sums at each of their steps, wherever they are.
void expect_few_elements(const scene::OneSurface& one, int seeds) {
    constexpr double most_operations = 1e12; // some quarter of an hour of a core
    constexpr double steps = 25;
    const double operations =
        formula::cost(one.surface.field->gradient, one.surface.animation.counts()).operations;
    if (operations * seeds * steps <= most_operations) return;
    throw std::invalid_argument(fmt::format(
        "--certify fast follows {} seeds, and each step sums all elements, {:g} operations: take "
        "--certify off, which finds elements by place",
        seeds, operations));
}

// Events from seeds, with the kinds that their index tells. Without the others there is nothing
// between the ends.
Timeline seeded(const scene::OneSurface& one, Side side, const AnalyseOptions& how, int first,
                int last, const SerialCallbacks& callbacks) {
    constexpr int seeds = 1 << 16;
    expect_few_elements(one, seeds);
    const int grid = how.grid.value_or(128);
    EventSearchOptions searching = event_search(how, callbacks);
    searching.seeds = seeds;
    Timeline timeline = find_events(
        one, side, {one.scene.timeline.time(first), one.scene.timeline.time(last)}, searching);
    const auto end = [&](int frame, std::optional<Betti>& betti) {
        if (callbacks.stopped()) return;
        const scene::SurfaceAt now = scene::surface_at(one, one.scene.timeline.time(frame));
        betti = on_grid(one, now, side, grid, how.threads, callbacks);
    };
    end(first, timeline.start);
    end(last, timeline.end);
    check_euler_number(timeline);
    timeline.doubts.push_back(
        fmt::format("first and last frame: signs on a grid of {0}x{0}x{0}, not proved", grid));
    return timeline;
}

// Counts signs at a time on a grid of so many vertices a side.
using CountSigns = std::function<std::optional<Betti>(double time, int grid)>;

CountSigns signs_of(const scene::OneSurface& one, Side side, const SerialCallbacks& callbacks) {
    const auto signs =
        std::make_shared<const FrameSigns>(*one.surface.field, one.surface.animation.counts());
    return [one, side, &callbacks, signs](double time, int grid) -> std::optional<Betti> {
        Work work([&] { return callbacks.stopped(); });
        const auto found = signs->at(scene::surface_at(one, time), side, grid, 1, work);
        return found ? std::optional(betti(*found)) : std::nullopt;
    };
}

// What two surfaces have in common has no scene of its own, and its formula may differ from one
// piece of the motion to the next.
CountSigns signs_of(const MovingScene& frames) {
    return [&frames](double time, int grid) {
        const MovingScene::Still still = frames.at(time);
        return std::optional(betti(frame_signs(still.formula, still.bounds, grid)));
    };
}

// Most frames that grids are too coarse for are close to events, where proofs fail late.
constexpr int most_boxes_of_recount = 50'000;
constexpr std::size_t most_cells_of_recount = 5'000;

// Takes the signs of the scene's own field, if there is one.
void count_again(Timeline& timeline, const MovingScene& frames, const CountSigns& signs,
                 const AnalyseOptions& how, const SerialCallbacks& callbacks) {
    callbacks.show("second opinion", 0);
    FrameLimits limits{.stopped = [&] { return callbacks.stopped(); }};
    limits.boxes = most_boxes_of_recount;
    limits.cells = most_cells_of_recount;
    Recounting counting;
    const CountSigns of_motions = signs_of(frames);
    counting.signs = [&](double time, int grid) {
        if (!signs) return of_motions(time, grid);
        try {
            return signs(time, grid);
        } catch (const scene::SceneError&) { // of the camera, say, between frames
            return of_motions(time, grid);
        }
    };
    counting.frame = [&](double time) { return frames.certify(time, limits).betti; };
    counting.threads = threads_of(how);
    counting.stopped = limits.stopped;
    counting.progress = [&](double part) { callbacks.show("second opinion", part); };
    timeline.recount = recount(timeline, counting);
}

// Adds to events, of which no kinds are known, all else that can be proved. `motions`: by time.
// Signs that the scene's own field has may be found faster than those of the motions' formula.
// Coordinates are those of `first`.
Timeline proved(Timeline timeline, const scene::OneSurface& first, const Motions& motions,
                const AnalyseOptions& how, Interval range, const SerialCallbacks& callbacks,
                CountSigns signs = {}) {
    const MovingScene frames(motions);
    const FrameLimits limits{.stopped = [&] { return callbacks.stopped(); }};
    struct {
        bool start = false, end = false;
    } is_by_cells;
    const auto prove_end = [&](double time, const char* not_known, std::optional<Betti>& betti,
                               bool& is_proved, bool& by_cells) {
        std::string why;
        if (callbacks.stopped()) return why;
        const CertifiedFrame frame = frames.certify(time, limits);
        betti = frame.betti;
        is_proved = betti.has_value();
        by_cells = frame.is_by_cells;
        if (!is_proved)
            why = fmt::format("{}: {}, near {}", not_known, frame.why,
                              place_text(moved(frame.where, first.surface.field->origin.point)));
        return why;
    };
    std::string no_start, no_end;
    const auto prove_ends = [&] {
        return [&](std::size_t k) {
            if (k == 0) {
                no_start = prove_end(range.lo, start_not_known, timeline.start,
                                     timeline.start_is_proved, is_by_cells.start);
            } else {
                no_end = prove_end(range.hi, end_not_known, timeline.end, timeline.end_is_proved,
                                   is_by_cells.end);
            }
        };
    };
    callbacks.show("first and last frame", 0);
    base::share({2, threads_of(how), limits.stopped,
                 [&](double part) { callbacks.show("first and last frame", part); }},
                prove_ends);

    PathOptions seeking;
    seeking.threads = threads_of(how);
    seeking.progress = [&](double part) { callbacks.show("kinds", part); };
    seeking.stopped = limits.stopped;
    KindProofs proofs = frames.proofs(timeline.events, seeking, limits);
    proofs.stopped = seeking.stopped;
    // Where boxes and paths tell nothing, as at kinks, frames between events do.
    constexpr int events_by_boxes_a_frame_by_cells = 64;
    if (is_by_cells.start || is_by_cells.end)
        proofs.events_a_frame = events_by_boxes_a_frame_by_cells;
    const auto open = std::ranges::count(timeline.events, Kind::unknown, &Event::kind);
    proofs.most_frames = std::max(proofs.most_frames, 2 * int(open));
    const bool is_late = callbacks.stopped();
    if (is_late && timeline.is_proved)
        timeline.doubts.emplace_back("interrupted before kinds were proved");
    find_kinds(timeline, is_late ? KindProofs{} : proofs);
    if (!timeline.start_is_proved && !no_start.empty()) timeline.doubts.push_back(no_start);
    if (!timeline.end_is_proved && !no_end.empty()) timeline.doubts.push_back(no_end);
    if (!timeline.events.empty() && !callbacks.stopped()) {
        callbacks.show("proofs again", 0);
        VerifyOptions confirming{.threads = threads_of(how)};
        confirming.stopped = limits.stopped;
        prove_again(timeline, ArbVerifier(motions), confirming);
    }
    if (!callbacks.stopped()) count_again(timeline, frames, signs, how, callbacks);
    if (callbacks.stopped()) {
        if (!is_late) timeline.doubts.emplace_back("interrupted while kinds were proved");
        timeline.is_proved = false;
    }
    return timeline;
}

Side solid(const scene::OneSurface& one, std::optional<Side> given) {
    return given ? *given : solid_side(one);
}

} // namespace

Timeline analyse(const scene::OneSurface& one, const AnalyseOptions& how) {
    const int last = how.last == 0 ? one.scene.timeline.frames : how.last;
    const Side side = solid(one, how.solids[0]);
    const SerialCallbacks callbacks(how);
    if (how.certify == Certify::off) {
        Sampling sampling;
        sampling.first = how.first;
        sampling.last = last;
        sampling.grid = how.grid;
        sampling.threads = how.threads;
        sampling.progress = [&](double part) { callbacks.show("sampling", part); };
        sampling.stopped = [&] { return callbacks.stopped(); };
        return sampled(one, side, sampling);
    }
    if (how.certify == Certify::fast) return seeded(one, side, how, how.first, last, callbacks);
    const Interval range{one.scene.timeline.time(how.first), one.scene.timeline.time(last)};
    return proved(find_events(one, side, range, event_search(how, callbacks)), one,
                  motions(one, side, range, Clock::time), how, range, callbacks,
                  signs_of(one, side, callbacks));
}

Timeline analyse_contact(const scene::OneSurface& first, const scene::OneSurface& second,
                         const AnalyseOptions& how) {
    if (how.certify != Certify::full)
        throw std::invalid_argument("contact is proved or not found: take --certify full");
    const int last = how.last == 0 ? first.scene.timeline.frames : how.last;
    const Interval range{first.scene.timeline.time(how.first), first.scene.timeline.time(last)};
    const SerialCallbacks callbacks(how);
    const Motions motions = common_motions({first, solid(first, how.solids[0])},
                                           {second, solid(second, how.solids[1])}, range);
    return proved(find_events(motions, range, event_search(how, callbacks)), first, motions, how,
                  range, callbacks);
}

} // namespace isomotion::topology
