#include "topology/timeline/falsehoods.h"

#include <algorithm>

#include <fmt/format.h>

#include "topology/timeline/event_differences.h"
#include "topology/timelines.h"

namespace isomotion::topology {
namespace {

using formula::Interval;

struct NumberName {
    const char* name;
    int Betti::*number;
};
constexpr NumberName numbers[] = {
    {"components", &Betti::components}, {"tunnels", &Betti::tunnels}, {"voids", &Betti::voids}};

class Liar {
public:
    Liar(const NamedTimeline& truth, double dt)
        : truth_(truth.record)
        , tolerance_(tolerance_of(truth.record, dt)) {
        falsify_ends();
        for (std::size_t k = 0; k < truth_.timeline.events.size(); k += truth.every) {
            falsify_numbers(k);
            falsify_kind(k);
            falsify_critical_point(k);
            falsify_time_and_place(k);
            falsify_proof(k);
            leave_out(k);
            say_twice(k);
        }
        swap_kinds();
        add_events();
    }

    std::vector<Falsehood> told() && { return std::move(told_); }

private:
    template<class Edit> void lie(std::string what, Edit&& edit) {
        TimelineRecord record = truth_;
        edit(record.timeline);
        // The events are in order, as a file has to have them.
        std::ranges::stable_sort(record.timeline.events, {},
                                 [](const Event& e) { return e.time.lo; });
        if (record.timeline == truth_.timeline) return;
        told_.push_back({std::move(what), std::move(record)});
    }
    // Alone, and with all numbers made to agree with it.
    template<class Edit> void lie_twice(const std::string& what, Edit&& edit) {
        lie(what, edit);
        lie(what + ", and numbers that follow", [&](Timeline& timeline) {
            edit(timeline);
            follow_from_start(timeline);
        });
    }
    template<class Edit> void lie_of(std::size_t k, const std::string& what, Edit&& edit) {
        lie(fmt::format("events[{}]: {}", k, what),
            [&](Timeline& timeline) { edit(timeline.events[k]); });
    }
    template<class Edit> void lie_twice_of(std::size_t k, const std::string& what, Edit&& edit) {
        lie_twice(fmt::format("events[{}]: {}", k, what),
                  [&](Timeline& timeline) { edit(timeline.events[k]); });
    }

    void falsify_ends() {
        for (const auto& [name, number] : numbers) {
            for (const int by : {1, -1}) {
                const auto add = [&, number = number](std::optional<Betti>& solid) {
                    if (solid && (*solid).*number + by >= 0) (*solid).*number += by;
                };
                const std::string what = fmt::format("{} {:+}", name, by);
                lie("start: " + what, [&](Timeline& t) { add(t.start); });
                lie("end: " + what, [&](Timeline& t) { add(t.end); });
                lie("start and end: " + what, [&](Timeline& t) {
                    add(t.start);
                    add(t.end);
                });
                lie("all numbers: " + what, [&](Timeline& t) {
                    add(t.start);
                    follow_from_start(t);
                });
                lie("the last numbers: " + what, [&](Timeline& t) {
                    if (!t.events.empty()) add(t.events.back().after);
                    add(t.end);
                });
            }
        }
        lie("the range begins earlier", [](Timeline& t) { t.range.lo -= 1e-3; });
        lie("the range ends later", [](Timeline& t) { t.range.hi += 1e-3; });
        lie("none is known at the start", [](Timeline& t) { t.start.reset(); });
        lie("none is known at the end", [](Timeline& t) { t.end.reset(); });
    }

    void falsify_numbers(std::size_t k) {
        for (const auto& [name, number] : numbers) {
            for (const int by : {1, -1}) {
                const auto add = [&, number = number](std::optional<Betti>& solid) {
                    if (solid && (*solid).*number + by >= 0) (*solid).*number += by;
                };
                const std::string what = fmt::format("{} {:+}", name, by);
                lie_of(k, "before: " + what, [&](Event& e) { add(e.before); });
                lie_of(k, "after: " + what, [&](Event& e) { add(e.after); });
                lie_of(k, "before and after: " + what, [&](Event& e) {
                    add(e.before);
                    add(e.after);
                });
            }
        }
    }

    void falsify_kind(std::size_t k) {
        for (int kind = 0; kind <= int(Kind::none); ++kind) {
            const std::string what(name(Kind(kind)));
            lie_twice_of(k, "kind " + what, [&](Event& e) { e.kind = Kind(kind); });
            // An index and a direction that the kind may have, too.
            const Event model = event_at(1, Kind(kind));
            lie_twice_of(k, what + " with an index and a direction of that", [&](Event& e) {
                if (e.kind == Kind(kind)) return;
                e.kind = Kind(kind);
                e.index = model.index;
                e.grows = model.grows;
            });
        }
    }

    void falsify_critical_point(std::size_t k) {
        for (int number = 0; number <= 3; ++number) {
            lie_of(k, fmt::format("index {}", number), [&](Event& e) { e.index = number; });
            lie_of(k, fmt::format("stratum {}", number), [&](Event& e) { e.stratum = number; });
            lie_of(k, fmt::format("index {}, other direction", number), [&](Event& e) {
                e.index = number;
                e.grows = !e.grows;
            });
        }
        lie_of(k, "direction", [](Event& e) { e.grows = !e.grows; });
    }

    void falsify_time_and_place(std::size_t k) {
        const double width = formula::width(truth_.timeline.events[k].time);
        for (const double by : {1.5 * tolerance_.time + 2 * width, 0.1, 1.0}) {
            for (const double way : {by, -by}) {
                const auto move = [&](Event& e) { e.time = {e.time.lo + way, e.time.hi + way}; };
                lie_of(k, fmt::format("{:+} s", way), move);
            }
            lie_of(k, fmt::format("{} s wider", by), [&](Event& e) { e.time.hi += by; });
        }
        for (std::size_t axis = 0; axis < 3; ++axis) {
            for (const double by : {1.5 * tolerance_.place, 0.1, 1.0}) {
                for (const double way : {by, -by}) {
                    lie_of(k, fmt::format("{:+} along axis {}", way, axis), [&](Event& e) {
                        e.where[axis] = {e.where[axis].lo + way, e.where[axis].hi + way};
                    });
                }
            }
            lie_of(k, fmt::format("anywhere along axis {}", axis),
                   [&](Event& e) { e.where[axis] = Interval::entire(); });
        }
    }

    void falsify_proof(std::size_t k) {
        lie_of(k, "not proved", [](Event& e) { e.is_proved = false; });
        lie_of(k, "proved again", [](Event& e) { e.is_proved_again = true; });
        if (truth_.timeline.events[k].kind != Kind::none)
            lie_of(k, "of a kind nobody proved", [](Event& e) { e.kind_proof.clear(); });
        if (truth_.timeline.events[k].kind_proof == "together")
            lie_of(k, "this very one is of its kind", [](Event& e) { e.kind_proof = "path"; });
    }

    void leave_out(std::size_t k) {
        lie_twice(fmt::format("events[{}] is left out", k), [&](Timeline& timeline) {
            timeline.events.erase(timeline.events.begin() + std::ptrdiff_t(k));
        });
    }

    void say_twice(std::size_t k) {
        for (const double by : {0.0, 0.05, -0.05}) {
            lie_twice(fmt::format("events[{}] again, {:+} s", k, by), [&](Timeline& timeline) {
                Event twin = timeline.events[k];
                twin.time = {twin.time.lo + by, twin.time.hi + by};
                timeline.events.insert(timeline.events.begin() + std::ptrdiff_t(k) + 1, twin);
            });
        }
    }

    // Each event of a pair of neighbours takes the other's kind, and all that goes with it.
    void swap_kinds() {
        const auto& events = truth_.timeline.events;
        for (std::size_t k = 1; k < events.size(); ++k) {
            const bool is_same_moment = are_interchangeable(events[k - 1], events[k]);
            if (events[k - 1].kind == events[k].kind || is_same_moment) continue;
            lie_twice(fmt::format("events[{}] and the one before change kinds", k),
                      [&](Timeline& timeline) {
                          Event &a = timeline.events[k - 1], &b = timeline.events[k];
                          std::swap(a.kind, b.kind);
                          std::swap(a.index, b.index);
                          std::swap(a.grows, b.grows);
                      });
        }
    }

    void add_events() {
        const Interval range = truth_.timeline.range;
        for (int kind = int(Kind::birth); kind <= int(Kind::none); ++kind) {
            const auto add = [&](double part, Timeline& timeline) {
                Event event = event_at(1, Kind(kind), {0.3, 0.3, 0.3});
                event.time = near(range.lo + part * (range.hi - range.lo));
                const auto later = std::ranges::find_if(timeline.events, [&](const Event& other) {
                    return other.time.lo > event.time.lo;
                });
                timeline.events.insert(later, event);
            };
            const std::string what = fmt::format("a {} too many", name(Kind(kind)));
            lie_twice(what, [&](Timeline& timeline) { add(0.137, timeline); });
            lie_twice(what + ", after all time", [&](Timeline& timeline) { add(1.2, timeline); });
        }
        lie("a place too many that is unresolved", [&](Timeline& timeline) {
            timeline.unresolved.push_back({near(range.lo), {}, "flat", {}, {}});
        });
        lie("a doubt", [](Timeline& timeline) { timeline.doubts.emplace_back("interrupted"); });
        lie("others may be missing", [](Timeline& timeline) { timeline.is_proved = false; });
    }

    const TimelineRecord& truth_;
    Tolerance tolerance_;
    std::vector<Falsehood> told_;
};

} // namespace

std::vector<Falsehood> falsehoods(const NamedTimeline& truth, double dt) {
    return Liar(truth, dt).told();
}

} // namespace isomotion::topology
