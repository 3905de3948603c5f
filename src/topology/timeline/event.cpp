#include "topology/timeline/event.h"

#include <algorithm>
#include <utility>

namespace isomotion::topology {
namespace {

struct Entry {
    Kind kind;
    std::string_view name;
    Betti change;
};

constexpr Entry entries[] = {
    {Kind::unknown, "unknown", {0, 0, 0}},
    {Kind::birth, "birth", {1, 0, 0}},
    {Kind::death, "death", {-1, 0, 0}},
    {Kind::merge, "merge", {-1, 0, 0}},
    {Kind::split, "split", {1, 0, 0}},
    {Kind::tunnel_forms, "tunnel forms", {0, 1, 0}},
    {Kind::tunnel_closes, "tunnel closes", {0, -1, 0}},
    {Kind::tunnel_opens, "tunnel opens", {0, 1, 0}},
    {Kind::tunnel_breaks, "tunnel breaks", {0, -1, 0}},
    {Kind::void_forms, "void forms", {0, 0, 1}},
    {Kind::void_fills, "void fills", {0, 0, -1}},
    {Kind::void_opens, "void opens", {0, 0, -1}},
    {Kind::void_born, "void born", {0, 0, 1}},
    {Kind::none, "none", {0, 0, 0}},
};

const Entry& entry(Kind kind) {
    return *std::find_if(std::begin(entries), std::end(entries),
                         [&](const Entry& e) { return e.kind == kind; });
}

} // namespace

std::string_view name(Kind kind) { return entry(kind).name; }

std::optional<Kind> parse_kind(std::string_view text) {
    for (const Entry& e : entries) {
        if (e.name == text) return e.kind;
    }
    return std::nullopt;
}

Betti change(Kind kind) { return entry(kind).change; }

std::vector<Kind> kinds_of(int index, bool grows) {
    switch (index) {
    case 0:
        return {grows ? Kind::birth : Kind::death};
    case 1:
        return grows ? std::vector{Kind::merge, Kind::tunnel_forms}
                     : std::vector{Kind::split, Kind::tunnel_breaks};
    case 2:
        return grows ? std::vector{Kind::tunnel_closes, Kind::void_forms}
                     : std::vector{Kind::tunnel_opens, Kind::void_opens};
    case 3:
        return {grows ? Kind::void_fills : Kind::void_born};
    default:
        return {};
    }
}

bool are_interchangeable(const Event& a, const Event& b) {
    return a.kind_proof == "together" && b.kind_proof == "together" && a.index == b.index &&
           a.grows == b.grows && a.time.lo <= b.time.hi && b.time.lo <= a.time.hi;
}

int euler_change(const Event& event) {
    if (event.kind == Kind::none) return 0;
    return event.index % 2 == (event.grows ? 0 : 1) ? 1 : -1;
}

bool Timeline::is_complete() const {
    const bool told = std::all_of(events.begin(), events.end(), [](const Event& event) {
        return event.is_proved && event.kind != Kind::unknown;
    });
    return is_proved && told && unresolved.empty() && doubts.empty() && start && end &&
           start_is_proved && end_is_proved;
}

std::array<formula::Interval, 3> moved(std::array<formula::Interval, 3> where,
                                       const std::array<double, 3>& by) {
    for (std::size_t k = 0; k < where.size(); ++k) {
        if (by[k] != 0) where[k] = where[k] + formula::Interval(by[k]); // sums are rounded outwards
    }
    return where;
}

void move(Timeline& timeline, const std::array<double, 3>& by) {
    for (Event& event : timeline.events) event.where = moved(event.where, by);
    for (Unresolved& place : timeline.unresolved) place.where = moved(place.where, by);
}

} // namespace isomotion::topology
