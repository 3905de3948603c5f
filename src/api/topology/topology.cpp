#include <fmt/format.h>

#include "api/scene/errors.h"
#include "api/scene/parts.h"
#include "probe/found_bounds.h"
#include "scene/surfaces.h"
#include "topology/subject.h"
#include "topology/timeline/summary.h"
#include "topology/timeline/timeline_file.h"
#include "topology/timeline/words.h"

namespace isomotion {
namespace {

topology::Subject subject_of(const scene::Scene& scene, const TopologySettings& settings) {
    const bool is_plain = settings.surface.empty() && settings.touching.empty();
    if (scene.surfaces.size() == 1 && is_plain) return topology::subject_of(scene, 0);
    const std::size_t first = scene::surface_named(scene, settings.surface, "surface");
    if (settings.touching.empty()) return topology::subject_of(scene, first);
    const std::size_t second = scene::surface_named(scene, settings.touching, "touching");
    if (first == second)
        throw Error(Error::Code::input, "a surface touches another one: name two of the scene");
    return topology::subject_of(scene, first, second);
}

topology::Certify certify_of(TopologySettings::Certify certify) {
    switch (certify) {
    case TopologySettings::Certify::off:
        return topology::Certify::off;
    case TopologySettings::Certify::fast:
        return topology::Certify::fast;
    case TopologySettings::Certify::full:
        break;
    }
    return topology::Certify::full;
}

topology::AnalyseOptions options_of(const topology::Subject& subject,
                                    const TopologySettings& settings, const Watcher& watcher) {
    topology::AnalyseOptions how;
    how.certify = certify_of(settings.certify);
    how.first = settings.first;
    how.last = settings.last != 0 ? settings.last : subject.first.scene.timeline.frames;
    how.threads = settings.threads;
    if (!(1 <= how.first && how.first < how.last)) {
        throw Error(Error::Code::input,
                    fmt::format("frames {} to {}: a timeline needs two frames, counted from 1",
                                how.first, how.last));
    }
    const auto solid = [&](const scene::OneSurface& one) {
        if (!settings.solid_is_negative) return topology::solid_side(one);
        return *settings.solid_is_negative ? topology::Side::negative : topology::Side::positive;
    };
    how.solids[0] = solid(subject.first);
    how.solids[1] = subject.second ? solid(*subject.second) : how.solids[0];
    how.stop = watcher.stop;
    how.progress = watcher.progress;
    return how;
}

// Bounds that had to be found hold the scene's own frames: a scene of more frames has others.
Scene with_bounds_of_all(const Scene& scene, const TopologySettings& settings) {
    if (settings.last <= scene.frames() || !probe::are_bounds_found(scene.parts().scene))
        return scene;
    return scene.with("time.frames", settings.last);
}

Interval interval(const formula::Interval& from) { return {from.lo, from.hi}; }

std::optional<Betti> betti(const std::optional<topology::Betti>& from) {
    if (!from) return std::nullopt;
    return Betti{from->components, from->tunnels, from->voids};
}

TopologyEvent event_of(const topology::Event& from) {
    return {.kind = std::string(topology::name(from.kind)),
            .time = interval(from.time),
            .where = {interval(from.where[0]), interval(from.where[1]), interval(from.where[2])},
            .proved = from.is_proved,
            .before = betti(from.before),
            .after = betti(from.after)};
}

} // namespace

Topology topology_of(const Scene& scene, const TopologySettings& settings, const Watcher& watcher) {
    return api::with_errors([&] {
        const Scene searched = with_bounds_of_all(scene, settings);
        const topology::Subject subject = subject_of(searched.parts().scene, settings);
        const topology::AnalyseOptions how = options_of(subject, settings, watcher);
        if (watcher.warn) {
            for (const std::string& why : topology::why_unbounded(subject, how.first))
                watcher.warn(why);
        }
        const animation::Timeline& time = subject.first.scene.timeline;
        topology::TimelineRecord record{
            topology::header_of(subject, {time.time(how.first), time.time(how.last)},
                                {*how.solids[0], *how.solids[1]}),
            {}};
        record.timeline = topology::analyse(subject, how);
        const topology::Timeline& timeline = record.timeline;
        Topology found;
        found.start = betti(timeline.start);
        found.end = betti(timeline.end);
        found.complete = timeline.is_complete();
        found.doubts = topology::gaps(timeline, record.header.fps);
        found.summary = topology::summary(record);
        found.json = topology::to_json(record);
        for (const topology::Event& event : timeline.events) {
            // On the bounds, where nothing changes, an event is no change of topology.
            if (event.kind != topology::Kind::none) found.events.push_back(event_of(event));
        }
        return found;
    });
}

} // namespace isomotion
