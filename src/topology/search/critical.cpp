#include "topology/search/critical.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <fmt/format.h>

#include "formula/graph/roughness.h"
#include "topology/field/monotone_track.h"
#include "topology/field/motion.h"
#include "topology/field/moving_field.h"
#include "topology/field/sphere_chart.h"
#include "topology/search/comoving_fit.h"
#include "topology/search/critical_system.h"
#include "topology/search/kinked_search.h"
#include "topology/search/knot_events.h"
#include "topology/search/krawczyk.h"
#include "topology/search/morse.h"
#include "topology/search/search.h"
#include "topology/search/seeded.h"
#include "topology/search/separable_search.h"
#include "topology/search/singular_set.h"
#include "topology/search/stratum_places.h"
#include "topology/timeline/advice.h"

namespace isomotion::topology {
namespace {

using formula::Interval;
namespace why = unresolved;

// Points on a sphere, each once: charts overlap.
class OnSphere {
public:
    enum class Known { no, yes, unclear };

    // Whether the point is one that was added from another chart. `path` tells formulas apart.
    Known find(const SphereChart& chart, const CriticalPoint& point, std::size_t clock,
               std::span<const char> path) const {
        const SpaceBox direction = chart.direction(point.where[0], point.where[1]);
        Known known = Known::no;
        for (const Found& other : found_) {
            if (other.chart == chart) continue;
            const auto at = other.chart.coordinates(direction);
            if (!at) continue;
            const std::array<Interval, 3> here{(*at)[0], (*at)[1], point.where[clock]};
            const auto are_all = [&](const std::array<Interval, 3>& there, auto&& is) {
                return is(there[0], here[0]) && is(there[1], here[1]) && is(there[2], here[2]);
            };
            if (!are_all(other.where,
                         [](Interval a, Interval b) { return !is_empty(intersect(a, b)); }))
                continue;
            const bool is_it =
                std::ranges::equal(path, other.path) &&
                are_all(other.alone, [](Interval a, Interval b) { return contains(a, b); });
            if (is_it) return Known::yes;
            known = Known::unclear;
        }
        return known;
    }

    void add(const SphereChart& chart, const CriticalPoint& point, std::size_t clock,
             std::span<const char> path) {
        const auto of = [&](const Box& box) { return std::array{box[0], box[1], box[clock]}; };
        found_.push_back({chart, {path.begin(), path.end()}, of(point.where), of(point.alone)});
    }

private:
    struct Found {
        SphereChart chart;
        std::vector<char> path;
        std::array<Interval, 3> where, alone; // u, v and the clock
    };
    std::vector<Found> found_;
};

// What is searched of one piece of the motion: strata of its bounds. A chart of a sphere has a
// motion of its own.
struct Part {
    Motion motion;
    std::vector<Stratum> strata;
    std::optional<SphereChart> chart{};
};

std::vector<Part> parts_of(const Motion& motion) {
    if (motion.shape == scene::Bounds::Shape::box) return {{motion, strata_of_box()}};
    std::vector<Part> parts{{motion, {Stratum{}}}};
    for (const SphereChart& chart : SphereChart::all())
        parts.push_back({chart.motion(motion), {SphereChart::wall()}, chart});
    return parts;
}

Event event_of(int stratum, int index, bool grows, bool changes_solid) {
    Event event;
    event.stratum = stratum;
    event.index = index;
    event.grows = grows;
    event.is_proved = true;
    const std::vector<Kind> kinds = kinds_of(index, grows);
    if (!changes_solid) {
        event.kind = Kind::none;
    } else if (kinds.size() == 1) {
        event.kind = kinds[0];
    }
    if (event.kind != Kind::unknown) event.kind_proof = "index";
    return event;
}

// Points at the ends of a piece of the motion.
struct AtEnds {
    std::vector<KnotPoint> first, last;
};

// Searches the strata of one part, and turns points into events.
class Stratified {
public:
    // `whole` is the motion that the part is of, the part's number `number`.
    Stratified(const Part& part, int number, const Motion& whole, const MonotoneTrack* driven,
               Timeline& timeline, OnSphere& on_sphere, AtEnds& at_ends)
        : motion_(part.motion)
        , whole_(whole)
        , number_(number)
        , chart_(part.chart)
        , track_(driven)
        , timeline_(timeline)
        , on_sphere_(on_sphere)
        , at_ends_(at_ends) {
        if (chart_) sphere_.emplace(whole, *chart_);
    }

    void add(const MovingField& field, const SearchResult& found) {
        Enclosures enclosures(field);
        for (const CriticalPoint& point : found.points) add(field, enclosures, point);
        for (std::size_t k = 0; k < found.unresolved.size(); ++k) {
            const Box& box = found.unresolved[k];
            const Box& part = found.smallest.empty() ? box : found.smallest[k];
            unresolved(field, box,
                       may_have_kink(field, box) ? why::kink
                                                 : reason(field, part, why::degenerate));
        }
    }

    void add(const KinkedResult& found) {
        for (const KinkedPoint& kinked : found.points) {
            Enclosures enclosures(kinked.of->field());
            add(kinked.of->field(), enclosures, kinked.point, kinked.index_across, kinked.path,
                {kinked.of, &kinked.of->field()});
        }
        for (const Box& box : found.unresolved) {
            unresolved(*found.field, box,
                       may_have_kink(*found.field, box)
                           ? why::kinks_meet
                           : reason(*found.field, box, why::degenerate));
        }
    }

private:
    // The place of a box in space.
    SpaceBox place(const MovingField& field, const Box& box) {
        if (sphere_) return sphere_->at(box[0], box[1], box[field.clock()]);
        return places(field.stratum()).at(field, box);
    }
    const StratumPlaces& places(const Stratum& stratum) {
        if (!places_ || !(of_places_ == stratum)) {
            places_.emplace(motion_, stratum);
            of_places_ = stratum;
        }
        return *places_;
    }

    // Whether a box is in another chart's part of the sphere: what is there is found by that chart.
    bool is_beyond(const Box& box) const {
        return chart_ && SphereChart::is_beyond(box[0], box[1]);
    }

    bool may_have_kink(const MovingField& field, const Box& box) {
        if (!rough_) {
            formula::Graph graph = motion_.graph;
            const auto kinks =
                formula::roughness(graph, motion_.field, formula::least_part_of_rays).kinks;
            const formula::NodeId rough = formula::anywhere(graph, {kinks, {}, {}});
            rough_ = formula::schedule(graph, std::array{rough});
        }
        const SpaceBox at = places(field.stratum()).at(field, box);
        const std::array<Interval, 4> inputs{at[0], at[1], at[2], box[field.clock()]};
        Interval value;
        formula::Evaluator<Interval>(*rough_).point(formula::convert<Interval>(motion_.bindings),
                                                    inputs, {&value, 1});
        return value != Interval(0.0);
    }

    // Seeks the reason of so many unresolved places: each takes some thousand evaluations.
    static constexpr int most_reasons = 100;

    // Why a place is unresolved that has one of these sets; `otherwise` if it has none.
    const char* reason(const MovingField& field, const Box& box, const char* otherwise) {
        if (reasons_told_ == most_reasons) return otherwise;
        ++reasons_told_;
        const auto set = singular_set(field, box);
        if (!set) return otherwise;
        if (set->lasts) return set->dimension == 0 ? why::lasting_point : why::lasting_curve;
        const std::array at_a_moment{otherwise, why::along_curve, why::along_surface};
        return at_a_moment[std::size_t(set->dimension)];
    }

    // Why a place on the bounds is, where F's derivative across them may be 0 as well.
    const char* reason_at_edge(const MovingField& field, const Box& box) {
        if (!in_space_) in_space_.emplace(whole_, Stratum{});
        const SpaceBox at = place(field, box);
        return reason(*in_space_, {at[0], at[1], at[2], box[field.clock()]}, why::touches_edge);
    }

    std::vector<MonotoneTrack::Time> times(Interval clock) const {
        if (track_) return track_->times(clock);
        const Interval whole = motion_.easing ? motion_.easing->span : motion_.clock;
        const Interval time = motion_.easing ? motion_.easing->time(clock) : clock;
        const bool is_inside = whole.lo < time.lo && time.hi < whole.hi;
        return {{time, is_inside ? 1 : 0}};
    }

    // A turn of the track takes no longer than doubles need to tell it.
    bool rests(Interval time) const { return width(time) > 1e-4 * width(timeline_.range); }

    void unresolved(const MovingField& field, const Box& box, const std::string& why) {
        if (is_beyond(box)) return;
        for (const MonotoneTrack::Time& time : times(box[field.clock()])) {
            timeline_.unresolved.push_back({time.at, place(field, box), why, {}, {}});
        }
    }

    // It may be an event with a point of the next piece, or of the one before.
    void keep_at_end(const MovingField& field, const Box& where, int across,
                     std::span<const char> path, std::shared_ptr<const MovingField> shared,
                     Interval time, const SpaceBox& place) {
        KnotPoint point;
        point.field =
            shared ? std::move(shared) : std::make_shared<MovingField>(motion_, field.stratum());
        point.where = where;
        for (std::size_t k = 0; k < std::size_t(field.dimension()); ++k)
            point.where[k] = field.x(where, k);
        const Interval clock = where[field.clock()];
        const bool is_last = mid(clock) > mid(motion_.clock);
        point.knot = is_last ? motion_.clock.hi : motion_.clock.lo;
        point.part = number_;
        point.index_across = across;
        point.path.assign(path.begin(), path.end());
        point.time = time;
        point.place = place;
        (is_last ? at_ends_.last : at_ends_.first).push_back(std::move(point));
    }

    // `across` is the part of the index that kinks have; `shared`, if any, is the field.
    void add(const MovingField& field, Enclosures& enclosures, const CriticalPoint& point,
             int across = 0, std::span<const char> path = {},
             const std::shared_ptr<const MovingField>& shared = {}) {
        if (is_beyond(point.where)) return;
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
        if (!track_ && is_empty(intersect(clock, with_ends_in_doubt(motion_.clock)))) return;
        const int by_clock = sign_of(point.jet.gradient[d]);
        const auto index = negative_eigenvalues(point.jet.hessian, int(d));
        if (by_clock == 0 || !index) {
            return unresolved(field, point.where, why::index);
        }
        // A face matters where F rises inwards: there the solid has a side of its own on it.
        bool changes_solid = true;
        for (const Interval& inward : enclosures.inward(point.where)) {
            if (sign_of(inward) == 0) {
                return unresolved(field, point.where, reason_at_edge(field, point.where));
            }
            changes_solid &= inward.lo > 0;
        }
        if (chart_) {
            const OnSphere::Known known = on_sphere_.find(*chart_, point, d, path);
            if (known == OnSphere::Known::yes) return;
            if (known == OnSphere::Known::unclear)
                return unresolved(field, point.where, why::degenerate);
            on_sphere_.add(*chart_, point, d, path);
        }
        for (const MonotoneTrack::Time& time : times(clock)) {
            const std::array<Interval, 3> where = place(field, point.where);
            // A root that may be at both ends would be compared at one of them only.
            if (time.direction == 0 && !track_ && !contains(clock, motion_.clock)) {
                keep_at_end(field, point.where, across, path, shared, time.at, where);
                continue;
            }
            if (time.direction == 0) {
                timeline_.unresolved.push_back(
                    {time.at, where, rests(time.at) ? why::rests : why::turns, {}, {}});
                continue;
            }
            Event event = event_of(field.dimension(), *index - multipliers + across,
                                   by_clock * time.direction < 0, changes_solid);
            event.time = time.at;
            event.where = where;
            timeline_.events.push_back(event);
        }
    }

    const Motion &motion_, &whole_;
    int number_;
    int reasons_told_ = 0;
    std::optional<MovingField> in_space_; // once it was asked for
    std::optional<SphereChart> chart_;
    std::optional<SpherePlaces> sphere_;  // with the chart
    std::optional<StratumPlaces> places_; // of the stratum that was asked for last
    Stratum of_places_;
    const MonotoneTrack* track_;
    Timeline& timeline_;
    OnSphere& on_sphere_;
    AtEnds& at_ends_;
    std::optional<formula::Program> rough_; // once it was asked for
};

// What is at the knot between two pieces of the motion, which may both have moved up to it.
void add_at_knot(std::vector<KnotPoint> before, std::vector<KnotPoint> after, bool jumps,
                 Timeline& timeline) {
    const auto leave = [&](const KnotPoint& point, const char* why) {
        timeline.unresolved.push_back({point.time, point.place, why, {}, {}});
    };
    for (const KnotPoint& point : before) {
        std::optional<AtKnot> met;
        auto same = after.begin();
        for (; !jumps && same != after.end(); ++same) {
            met = meet(point, *same);
            if (met) break;
        }
        if (!met) {
            leave(point, why::rule_changes);
            continue;
        }
        if (met->rises == 0) {
            leave(point, why::turns);
            leave(*same, why::turns);
        } else {
            Event event =
                event_of(point.field->dimension(), met->index, met->rises < 0, met->changes_solid);
            event.time = hull(point.time, same->time);
            event.where = hull_of(point.place, same->place);
            timeline.events.push_back(event);
        }
        after.erase(same);
    }
    for (const KnotPoint& point : after) leave(point, why::rule_changes);
}

// About how much of the time a stratum takes.
double effort(const Stratum& stratum) { return std::pow(8, stratum.dimension()); }

// `one`: whose tracks drive motions that do not go by time.
Timeline found_in(const Motions& all, const scene::OneSurface* one, Interval range,
                  const EventSearchOptions& how, SearchCost* cost) {
    Timeline timeline;
    timeline.range = range;
    timeline.is_proved = true;
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
    std::vector<KnotPoint> at_last; // the last moment of the piece before
    for (const Motion& motion : all.pieces) {
        AtEnds at_ends;
        const auto end_piece = [&] {
            const double knot = (motion.easing ? motion.easing->span : motion.clock).lo;
            const bool jumps = std::ranges::find(all.jumps, knot) != all.jumps.end();
            add_at_knot(std::move(at_last), std::move(at_ends.first), jumps, timeline);
            at_last = std::move(at_ends.last);
        };
        if (!motion.moves || is_stopped()) {
            end_piece();
            continue;
        }
        std::optional<MonotoneTrack> driven;
        assert(one || !motion.driver); // what two surfaces have in common moves by time
        if (one && motion.driver) driven.emplace(*one, *motion.driver, range);
        const std::vector<Part> parts = parts_of(motion);
        double whole = 0;
        for (const Part& part : parts) {
            for (const Stratum& stratum : part.strata) whole += effort(stratum);
        }
        whole *= double(all.pieces.size());
        const bool is_kinked = how.seeds == 0 && KinkTree(bound_formula(motion), 3).has_kinks();
        OnSphere on_sphere;
        for (std::size_t number = 0; number < parts.size(); ++number) {
            const Part& part = parts[number];
            Stratified events(part, int(number), motion, driven ? &*driven : nullptr, timeline,
                              on_sphere, at_ends);
            for (const Stratum& stratum : part.strata) {
                if (is_stopped()) break;
                const double share = effort(stratum) / whole;
                std::function<void(double)> progress;
                if (how.progress) {
                    progress = [&how, done, share](double of_this) {
                        how.progress(done + of_this * share);
                    };
                }
                const SearchOptions searching{how.smallest, how.threads, how.stopped, progress};
                done += share;
                if (how.seeds == 0) {
                    if (const auto found = search_separable(part.motion, stratum, searching)) {
                        if (cost) cost->boxes += found->found.work.boxes;
                        events.add(found->field, found->found);
                        continue;
                    }
                }
                if (is_kinked) {
                    const KinkedResult found = search_kinked(part.motion, stratum, searching);
                    if (cost) cost->boxes += found.work.boxes;
                    events.add(found);
                    continue;
                }
                const MovingField field = how.seeds > 0 ? MovingField(part.motion, stratum)
                                                        : comoving_field(part.motion, stratum);
                const SearchResult found =
                    how.seeds > 0
                        ? from_seeds(field, {how.seeds, how.threads, how.stopped, progress})
                        : search(field, searching);
                if (cost) cost->boxes += found.work.boxes;
                events.add(field, found);
            }
        }
        end_piece();
    }
    add_at_knot(std::move(at_last), {}, false, timeline);
    if (is_stopped()) timeline.doubts.emplace_back("the search was interrupted");
    if (!timeline.doubts.empty() || !timeline.unresolved.empty()) timeline.is_proved = false;
    const auto earlier = [](const auto& a, const auto& b) { return mid(a.time) < mid(b.time); };
    std::stable_sort(timeline.events.begin(), timeline.events.end(), earlier);
    std::stable_sort(timeline.unresolved.begin(), timeline.unresolved.end(), earlier);
    return timeline;
}

} // namespace

Timeline find_events(const scene::OneSurface& one, Side side, Interval range,
                     const EventSearchOptions& how, SearchCost* cost) {
    return found_in(motions(one, side, range), &one, range, how, cost);
}

Timeline find_events(const Motions& all, Interval range, const EventSearchOptions& how,
                     SearchCost* cost) {
    return found_in(all, nullptr, range, how, cost);
}

} // namespace isomotion::topology
