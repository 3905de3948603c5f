#include "topology/classify/event_paths.h"

#include <algorithm>
#include <map>
#include <memory>
#include <tuple>

#include "base/workers.h"
#include "topology/classify/field_snapshot.h"
#include "topology/classify/morse_graph.h"
#include "topology/classify/saddle_path.h"
#include "topology/classify/saddle_tracks.h"

namespace isomotion::topology {
namespace {

using formula::Interval;

constexpr int most_routes = 16, most_bridges = 3, most_seeds = 4096;
// So many saddles are tried first, then two times as many more, and so on.
constexpr std::size_t nearest_saddles = 16;
// Parts of the box: minima that are one, and saddles that are the event's own.
constexpr double same_minimum = 1e-5, own = 1e-6;

Domain domain_of(const FieldSnapshot& snapshot, bool is_solid) {
    Domain domain{snapshot.box, is_solid, snapshot.is_inside,
                  [&](const SpacePoint& p) { return snapshot.is_outside(point_box(p)); }};
    const EnclosedBounds& bounds = snapshot.bounds;
    if (bounds.shape == scene::Bounds::Shape::sphere)
        domain.sphere = {middle(bounds.centre), bounds.radius.lo};
    return domain;
}

// Looks for passes where a route is missing: its gaps themselves where all of them seems to be low
// enough, and saddles near their highest points. False where there are no gaps.
bool bridge(MorseGraph& graph, std::span<const DescentPath> ends, PointField& field,
            const Domain& domain, const std::function<void(std::span<const SpacePoint>)>& add) {
    constexpr int samples = 16;
    const auto gaps = graph.gaps(ends[0], ends[1], domain);
    std::vector<SpacePoint> points, tops;
    for (const auto& gap : gaps) {
        const SpacePoint across = difference(gap.to, gap.from);
        for (int k = 1; k < samples; ++k)
            points.push_back(along(gap.from, double(k) / samples, across));
    }
    std::vector<PointJet> jets;
    field.jets(points, jets);
    std::vector<SaddleConnection> straight;
    for (std::size_t g = 0; g < gaps.size(); ++g) {
        const auto first = jets.begin() + std::ptrdiff_t(g * (samples - 1));
        const auto top = std::ranges::max_element(first, first + samples - 1, {}, &PointJet::value);
        const SpacePoint at = points[std::size_t(top - jets.begin())];
        tops.push_back(at);
        if (!(top->value < 0)) continue;
        const auto end = [&](const SpacePoint& p) {
            return domain.is_outside(p) ? DescentPath::End::outside : DescentPath::End::minimum;
        };
        straight.push_back({top->value,
                            {DescentPath{{at, gaps[g].from}, end(gaps[g].from)},
                             DescentPath{{at, gaps[g].to}, end(gaps[g].to)}}});
    }
    const double size = longest_side(domain.box);
    std::vector<SpacePoint> saddles;
    for (const auto& saddle : saddles_near(field, tops, size, size / 8)) {
        if (saddle) saddles.push_back(*saddle);
    }
    add(saddles);
    graph.add(std::move(straight));
    return !gaps.empty();
}

// Whether two values may be one, and the hull of both.
struct Together {
    bool may_be_one = true;

    void add(Interval& a, const Interval& b) {
        may_be_one &= !is_empty(intersect(a, b));
        a = hull(a, b);
    }
    void add(formula::Bindings<Interval>& a, const formula::Bindings<Interval>& b) {
        for (std::size_t k = 0; k < a.parameters.size(); ++k) add(a.parameters[k], b.parameters[k]);
        for (std::size_t n = 0; n < a.arrays.size(); ++n) {
            for (std::size_t f = 0; f < a.arrays[n].fields.size(); ++f) {
                auto& to = a.arrays[n].fields[f];
                const auto& from = b.arrays[n].fields[f];
                for (std::size_t k = 0; k < to.size(); ++k) add(to[k], from[k]);
            }
        }
    }
    void add(EnclosedBounds& a, const EnclosedBounds& b) {
        for (std::size_t k = 0; k < 3; ++k) {
            add(a.low[k], b.low[k]);
            add(a.high[k], b.high[k]);
            add(a.centre[k], b.centre[k]);
        }
        add(a.radius, b.radius);
    }
};

} // namespace

// The surface at an event, or at several: a motion that swings comes back to it. A proof for all
// values in the enclosures is one for each event.
struct EventPaths::Surface {
    const TimedFormula* piece;
    formula::Bindings<Interval> bindings;
    EnclosedBounds bounds;
    std::vector<std::size_t> events;
};

// The fields of one thread: made once for each piece, then given the values of one event after the
// other.
struct EventPaths::Fields {
    std::map<const TimedFormula*, std::unique_ptr<PointField>> points;
    std::map<const TimedFormula*, std::shared_ptr<FrameField>> boxes;

    PointField& at(const TimedFormula& piece, const formula::Bindings<formula::Interval>& bindings,
                   int index) {
        auto& field = points[&piece];
        if (!field) field = std::make_unique<PointField>(piece.formula());
        field->bind(bindings, index == 2);
        return *field;
    }
    const std::shared_ptr<FrameField>& over(const TimedFormula& piece,
                                            const formula::Bindings<formula::Interval>& bindings) {
        auto& field = boxes[&piece];
        if (!field) field = std::make_shared<FrameField>(piece.formula());
        field->bind(bindings);
        return field;
    }
};

EventPaths::EventPaths(std::span<const TimedFormula> pieces, std::vector<Event> events)
    : pieces_(pieces)
    , events_(std::move(events)) {}

const TimedFormula& EventPaths::piece_of(double time) const {
    const auto now = std::ranges::find_if(
        pieces_, [&](const TimedFormula& piece) { return contains(piece.clock(), time); });
    return now == pieces_.end() ? pieces_.back() : *now;
}

void EventPaths::follow_saddles(int index, const std::function<bool()>& stopped) {
    Fields fields;
    const FieldAt field = [&](double time) -> PointField& {
        const TimedFormula& piece = piece_of(time);
        return fields.at(piece, piece.bindings(time), index);
    };
    SpaceBox box;
    const scene::BoundsAt bounds = pieces_.front().bounds(mid(pieces_.front().clock()));
    for (std::size_t i = 0; i < 3; ++i) box[i] = {bounds.min[int(i)], bounds.max[int(i)]};
    saddles_[std::size_t(index - 1)] = saddles_at_events(field, events_, index, box, stopped);
}

std::vector<EventPaths::Surface> EventPaths::surfaces(std::span<const std::size_t> which) const {
    std::vector<Surface> surfaces;
    const auto key = [](const Event& event) {
        return std::tuple(event.index, event.stratum, event.where[0].lo, event.where[1].lo,
                          event.where[2].lo);
    };
    std::map<decltype(key(events_[0])), std::vector<std::size_t>> at_place;
    for (const std::size_t k : which) {
        const Event& event = events_[k];
        const TimedFormula& piece = piece_of(mid(event.time));
        // At a knot another piece has a rule of its own.
        if (!contains(piece.clock(), event.time)) continue;
        Surface now{&piece, piece.bindings(event.time), piece.bounds(event.time), {k}};
        std::vector<std::size_t>& others = at_place[key(event)];
        const bool is_known = std::ranges::any_of(others, [&](std::size_t number) {
            Surface& other = surfaces[number];
            if (other.piece != &piece || events_[other.events[0]].where != event.where)
                return false;
            Surface both = now;
            Together together;
            together.add(both.bindings, other.bindings);
            together.add(both.bounds, other.bounds);
            if (!together.may_be_one) return false;
            both.events = other.events;
            both.events.push_back(k);
            other = std::move(both);
            return true;
        });
        if (is_known) continue;
        others.push_back(surfaces.size());
        surfaces.push_back(std::move(now));
    }
    return surfaces;
}

std::vector<Sides> EventPaths::seek(std::span<const std::size_t> which, const PathOptions& how) {
    std::vector<int> to_follow;
    for (const int index : {1, 2}) {
        const bool is_asked =
            std::ranges::any_of(which, [&](std::size_t k) { return events_[k].index == index; });
        bool& is_followed = is_followed_[std::size_t(index - 1)];
        if (is_asked && !is_followed) to_follow.push_back(index);
        is_followed |= is_asked;
    }
    const auto loop = [&](std::size_t count) {
        return base::SharedLoop{count, how.threads, how.stopped, how.progress};
    };
    base::share(loop(to_follow.size()),
                [&] { return [&](std::size_t k) { follow_saddles(to_follow[k], how.stopped); }; });
    std::vector<Sides> found(which.size(), Sides::unknown);
    std::vector<std::size_t> position(events_.size());
    for (std::size_t k = 0; k < which.size(); ++k) position[which[k]] = k;
    const std::vector<Surface> surfaces = this->surfaces(which);
    base::share(loop(surfaces.size()), [&] {
        return [&, fields = Fields{}](std::size_t k) mutable {
            const Sides answer = sides(fields, surfaces[k], how.effort, how.stopped);
            for (const std::size_t event : surfaces[k].events) found[position[event]] = answer;
        };
    });
    return found;
}

Sides EventPaths::sides(Fields& fields, const Surface& surface, int effort,
                        const std::function<bool()>& stopped) const {
    const std::size_t which = surface.events[0];
    const Event& event = events_[which];
    const bool is_solid = event.index == 1;
    if (event.index != 1 && event.index != 2) return Sides::unknown;
    const FieldSnapshot snapshot =
        field_snapshot(fields.over(*surface.piece, surface.bindings), surface.bounds);
    const SublevelSet region(snapshot, is_solid);
    const auto starts = both_sides(region, event);
    if (!starts) return Sides::unknown;

    // Paths tell most of hundreds of events; boxes take much longer for each.
    if (effort > 1) {
        const Sides by_boxes = sides_by_boxes(region, event, *starts, {.stopped = stopped});
        if (by_boxes != Sides::unknown) return by_boxes;
    }

    PointField& field = fields.at(*surface.piece, surface.bindings, event.index);
    const Domain domain = domain_of(snapshot, is_solid);
    Domain with_short_steps = domain;
    with_short_steps.longest /= 8;
    const std::vector<DescentPath> own_ways =
        descent_paths(field, domain, std::array{Start{(*starts)[0], {}}, Start{(*starts)[1], {}}});

    const double size = longest_side(snapshot.box);
    MorseGraph graph(same_minimum * size);
    // No way leads over the event itself, nor over others at its time.
    std::vector<SpacePoint> known;
    for (const Event& other : events_) {
        if (other.time.lo <= event.time.hi && other.time.hi >= event.time.lo)
            known.push_back(middle(other.where));
    }
    const auto add = [&](std::span<const SpacePoint> saddles) {
        const std::size_t before = known.size();
        std::vector<SpacePoint> inside;
        std::ranges::copy_if(saddles, std::back_inserter(inside),
                             [&](const SpacePoint& p) { return region.may_hold(p); });
        add_points(known, inside, own * size);
        const auto added = std::span(known).subspan(before);
        graph.add(saddle_connections(field, domain, added));
        // Ways by short steps may end elsewhere.
        if (effort > 0) graph.add(saddle_connections(field, with_short_steps, added));
    };
    // A way round is short, if there is one: the nearest saddles first, the others where these
    // don't do.
    std::vector<SpacePoint> saddles = saddles_[std::size_t(event.index - 1)][which];
    std::ranges::sort(saddles, {},
                      [&](const SpacePoint& p) { return distance(p, middle(event.where)); });
    std::span<const SpacePoint> not_added(saddles);
    const auto add_nearest = [&](std::size_t count) {
        const auto nearest = not_added.first(std::min(count, not_added.size()));
        not_added = not_added.subspan(nearest.size());
        add(nearest);
    };
    add_nearest(effort > 1 ? saddles.size() : nearest_saddles);
    if (effort > 1) add(saddles_from_seeds(field, snapshot.box, most_seeds));
    for (int tries = 0, bridges = effort > 0 ? most_bridges : 0; tries < most_routes;) {
        if (stopped && stopped()) return Sides::unknown;
        const auto route = graph.route(own_ways[0], own_ways[1]);
        if (!route) {
            if (!not_added.empty()) {
                add_nearest(std::max(2 * (saddles.size() - not_added.size()), nearest_saddles));
                continue;
            }
            if (bridges-- > 0 && bridge(graph, own_ways, field, domain, add)) continue;
            return Sides::unknown;
        }
        ++tries;
        std::size_t failed = 0;
        if (is_path(region, route->points, &failed)) return Sides::joined;
        if (route->over[failed] == Route::none) break;
        // A long step may have crossed a ridge.
        const DescentPath& path = graph.connection(route->over[failed]).paths[0];
        graph.close(route->over[failed]);
        if (path.points.size() < 2) continue;
        const SpacePoint across = difference(path.points[1], path.points[0]);
        const Start again{path.points[0], along({}, 1 / length(across), across)};
        graph.add(saddle_connections(field, with_short_steps, {&again, 1}));
    }
    return Sides::unknown;
}

} // namespace isomotion::topology
