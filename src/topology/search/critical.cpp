#include "topology/search/critical.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "formula/graph/roughness.h"
#include "topology/field/monotone_track.h"
#include "topology/field/motion.h"
#include "topology/field/moving_field.h"
#include "topology/search/comoving_fit.h"
#include "topology/search/kinked_search.h"
#include "topology/search/krawczyk.h"
#include "topology/search/morse.h"
#include "topology/search/search.h"
#include "topology/search/seeded.h"
#include "topology/search/sphere.h"
#include "topology/search/stratum_places.h"
#include "topology/timeline/advice.h"

namespace isomotion::topology {
namespace {

using formula::Interval;
namespace why = unresolved;

int sign_of(const Interval& a) { return a.lo > 0 ? 1 : a.hi < 0 ? -1 : 0; }

// Searches the strata of one piece of the motion, and turns points into events.
class Stratified {
public:
    Stratified(const Motion& motion, const MonotoneTrack* driven, Timeline& timeline)
        : motion_(motion)
        , track_(driven)
        , timeline_(timeline) {}

    void add(const MovingField& field, const SearchResult& found) {
        Enclosures enclosures(field);
        for (const CriticalPoint& point : found.points) add(field, enclosures, point);
        for (const Box& box : found.unresolved) {
            unresolved(field, box, may_have_kink(field, box) ? why::kink : why::degenerate);
        }
    }

    void add(const KinkedResult& found) {
        for (const KinkedPoint& kinked : found.points) {
            Enclosures enclosures(kinked.of->field());
            add(kinked.of->field(), enclosures, kinked.point, kinked.index_across);
        }
        for (const Box& box : found.unresolved) {
            unresolved(*found.field, box,
                       may_have_kink(*found.field, box) ? why::kinks_meet : why::degenerate);
        }
    }

    void add_reaching(const MovingField& field, const std::function<bool()>& stopped) {
        constexpr std::size_t most = 4096;
        const std::vector<Box> boxes =
            merged(on_the_sphere(field, most, stopped), field.domain(), 1e-6);
        for (const Box& box : boxes) unresolved(field, box, why::reaches_sphere);
    }

private:
    SpaceBox place(const MovingField& field, const Box& box) const {
        return StratumPlaces(motion_, field.stratum()).at(field, box);
    }

    bool may_have_kink(const MovingField& field, const Box& box) {
        if (!rough_) {
            formula::Graph graph = motion_.graph;
            const formula::NodeId rough =
                formula::anywhere(graph, {formula::roughness(graph, motion_.field).kinks, {}, {}});
            rough_ = formula::schedule(graph, std::array{rough});
        }
        const std::array<Interval, 3> at = place(field, box);
        const std::array<Interval, 4> inputs{at[0], at[1], at[2], box[field.clock()]};
        Interval value;
        formula::Evaluator<Interval>(*rough_).point(formula::convert<Interval>(motion_.bindings),
                                                    inputs, {&value, 1});
        return value != Interval(0.0);
    }

    std::vector<MonotoneTrack::Time> times(Interval clock) const {
        if (track_) return track_->times(clock);
        const bool is_inside = motion_.clock.lo < clock.lo && clock.hi < motion_.clock.hi;
        return {{clock, is_inside ? 1 : 0}};
    }

    // A turn of the track takes no longer than doubles need to tell it.
    bool rests(Interval time) const { return width(time) > 1e-4 * width(timeline_.range); }

    void unresolved(const MovingField& field, const Box& box, const std::string& why) {
        for (const MonotoneTrack::Time& time : times(box[field.clock()])) {
            timeline_.unresolved.push_back({time.at, place(field, box), why, {}, {}});
        }
    }

    // `across` is the part of the index that kinks have.
    void add(const MovingField& field, Enclosures& enclosures, const CriticalPoint& point,
             int across = 0) {
        const std::size_t d = field.clock();
        const int multipliers = int(d) - field.dimension();
        switch (enclosures.place(point.where)) {
        case Enclosures::Place::outside:
            return;
        case Enclosures::Place::unknown:
            return unresolved(field, point.where, why::on_edge);
        case Enclosures::Place::inside:
            break;
        }
        const Interval clock = point.where[d];
        if (!track_ && is_empty(intersect(clock, motion_.clock))) return;
        const int by_clock = sign_of(point.jet.gradient[d]);
        const auto index = negative_eigenvalues(point.jet.hessian, int(d));
        if (by_clock == 0 || !index) {
            return unresolved(field, point.where, why::index);
        }
        // A face matters where F rises inwards: there the solid has a side of its own on it.
        bool changes_solid = true;
        for (const Interval& inward : enclosures.inward(point.where)) {
            if (sign_of(inward) == 0) {
                return unresolved(field, point.where, why::touches_edge);
            }
            changes_solid &= inward.lo > 0;
        }
        for (const MonotoneTrack::Time& time : times(clock)) {
            const std::array<Interval, 3> where = place(field, point.where);
            if (time.direction == 0) {
                timeline_.unresolved.push_back({time.at,
                                                where,
                                                !track_          ? why::rule_changes
                                                : rests(time.at) ? why::rests
                                                                 : why::turns,
                                                {},
                                                {}});
                continue;
            }
            Event event;
            event.time = time.at;
            event.where = where;
            event.stratum = field.dimension();
            event.index = *index - multipliers + across;
            event.grows = by_clock * time.direction < 0;
            event.is_proved = true;
            const std::vector<Kind> kinds = kinds_of(event.index, event.grows);
            if (!changes_solid) {
                event.kind = Kind::none;
            } else if (kinds.size() == 1) {
                event.kind = kinds[0];
            }
            if (event.kind != Kind::unknown) event.kind_proof = "index";
            timeline_.events.push_back(event);
        }
    }

    const Motion& motion_;
    const MonotoneTrack* track_;
    Timeline& timeline_;
    std::optional<formula::Program> rough_; // once it was asked for
};

std::vector<Stratum> strata(const Motion& motion) {
    if (motion.shape == scene::Bounds::Shape::box) return strata_of_box();
    return {Stratum{}};
}

// About how much of the time a stratum takes.
double effort(const Stratum& stratum) { return std::pow(8, stratum.dimension()); }

} // namespace

Timeline find_events(const scene::Scene& scene, Side side, Interval range,
                     const EventSearchOptions& how, SearchCost* cost) {
    Timeline timeline;
    timeline.range = range;
    timeline.is_proved = true;
    const Motions all = motions(scene, side, range);
    timeline.doubts = all.doubts;
    if (how.seeds > 0) timeline.doubts.emplace_back("found from seeds: events may be missing");
    for (const double jump : all.jumps) {
        timeline.unresolved.push_back({Interval(jump), {}, why::jumps, {}, {}});
    }
    for (const Interval& time : all.collapses) {
        timeline.unresolved.push_back({time, {}, why::no_bounds, {}, {}});
    }
    const auto is_stopped = [&] { return how.stopped && how.stopped(); };
    double done = 0;
    for (const Motion& motion : all.pieces) {
        if (!motion.moves || is_stopped()) continue;
        std::optional<MonotoneTrack> driven;
        if (motion.driver) driven.emplace(scene, *motion.driver, range);
        Stratified events(motion, driven ? &*driven : nullptr, timeline);
        const std::vector<Stratum> parts = strata(motion);
        double whole = 0;
        for (const Stratum& part : parts) whole += effort(part);
        whole *= double(all.pieces.size());
        const bool is_kinked = how.seeds == 0 && KinkTree(bound_formula(motion), 3).has_kinks();
        for (const Stratum& part : parts) {
            const double share = effort(part) / whole;
            std::function<void(double)> progress;
            if (how.progress) {
                progress = [&how, done, share](double of_this) {
                    how.progress(done + of_this * share);
                };
            }
            const SearchOptions searching{how.smallest, how.threads, how.stopped, progress};
            done += share;
            if (is_kinked) {
                const KinkedResult found = search_kinked(motion, part, searching);
                if (cost) cost->boxes += found.work.boxes;
                events.add(found);
                if (motion.shape == scene::Bounds::Shape::sphere)
                    events.add_reaching(*found.field, how.stopped);
                continue;
            }
            const MovingField field =
                how.seeds > 0 ? MovingField(motion, part) : comoving_field(motion, part);
            const SearchResult found =
                how.seeds > 0 ? from_seeds(field, {how.seeds, how.threads, how.stopped, progress})
                              : search(field, searching);
            if (cost) cost->boxes += found.work.boxes;
            events.add(field, found);
            if (motion.shape == scene::Bounds::Shape::sphere)
                events.add_reaching(field, how.stopped);
        }
    }
    if (is_stopped()) timeline.doubts.emplace_back("the search was interrupted");
    if (!timeline.doubts.empty() || !timeline.unresolved.empty()) timeline.is_proved = false;
    const auto earlier = [](const auto& a, const auto& b) { return mid(a.time) < mid(b.time); };
    std::stable_sort(timeline.events.begin(), timeline.events.end(), earlier);
    std::stable_sort(timeline.unresolved.begin(), timeline.unresolved.end(), earlier);
    return timeline;
}

} // namespace isomotion::topology
