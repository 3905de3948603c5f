#include <array>
#include <utility>

#include <fmt/format.h>

#include "api/scene/errors.h"
#include "api/scene/parts.h"
#include "api/topology/parts.h"
#include "probe/found_bounds.h"
#include "scene/scene_at.h"
#include "scene/surfaces.h"
#include "topology/subject.h"
#include "topology/timeline/betti_csv.h"
#include "topology/timeline/contact_words.h"
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
    if (first == second) {
        throw Error(Error::Code::setting,
                    fmt::format("touching {}: a surface touches another one", settings.touching));
    }
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

void check_settings(const TopologySettings& settings, int last) {
    using Certify = TopologySettings::Certify;
    if (!(1 <= settings.first && settings.first < last)) {
        throw Error(
            Error::Code::setting,
            fmt::format("first, last: frames {} to {}: a timeline needs two frames, counted from 1",
                        settings.first, last));
    }
    if (settings.grid && (*settings.grid < 8 || *settings.grid > 1024)) {
        throw Error(Error::Code::setting,
                    fmt::format("grid {}: write vertices along a side, 8 to 1024", *settings.grid));
    }
    if (settings.grid && settings.certify == Certify::full) {
        throw Error(Error::Code::setting,
                    "grid: proofs use no grid; write it with --certify off or fast");
    }
    if (!settings.touching.empty() && settings.certify != Certify::full) {
        throw Error(Error::Code::setting,
                    "certify: contact of surfaces is proved or not found, with `full`");
    }
}

// The solid that the settings say, otherwise what topology::solid_side() says.
topology::Side solid_of(const scene::OneSurface& one, const std::vector<Solid>& settings) {
    std::optional<bool> is_negative;
    for (const std::string& name : {std::string(), one.surface.label}) {
        for (const Solid& solid : settings) {
            if (solid.surface == name) is_negative = solid.is_negative;
        }
    }
    if (!is_negative) return topology::solid_side(one);
    return *is_negative ? topology::Side::negative : topology::Side::positive;
}

// All that a search needs. It refers to the scene.
struct Search {
    topology::Subject subject;
    topology::AnalyseOptions how;
    topology::TimelineHeader header;
};

Search search_of(const scene::Scene& scene, const TopologySettings& settings) {
    topology::AnalyseOptions how;
    how.certify = certify_of(settings.certify);
    how.first = settings.first;
    how.last = settings.last != 0 ? settings.last : scene.timeline.frames;
    how.grid = settings.grid;
    how.threads = settings.threads;
    check_settings(settings, how.last);
    topology::Subject subject = subject_of(scene, settings);
    const topology::Side first = solid_of(subject.first, settings.solid);
    const std::array solids{first,
                            subject.second ? solid_of(*subject.second, settings.solid) : first};
    how.solids = {solids[0], solids[1]};
    const formula::Interval range{scene.timeline.time(how.first), scene.timeline.time(how.last)};
    topology::TimelineHeader header = topology::header_of(subject, range, solids);
    return {std::move(subject), std::move(how), std::move(header)};
}

// Bounds that had to be found hold the scene's own frames: a scene of more frames has others.
Scene with_bounds_of_all(const Scene& scene, const TopologySettings& settings) {
    if (settings.last <= scene.frames() || !probe::are_bounds_found(scene.parts().scene))
        return scene;
    return api::with_frames(scene, settings.last);
}

Interval interval(const formula::Interval& from) { return {from.lo, from.hi}; }

Box box(const std::array<formula::Interval, 3>& from) {
    return {interval(from[0]), interval(from[1]), interval(from[2])};
}

std::optional<Betti> betti(const std::optional<topology::Betti>& from) {
    if (!from) return std::nullopt;
    return Betti{from->components, from->tunnels, from->voids};
}

TopologyEvent event_of(const topology::Event& from) {
    return {.kind = std::string(topology::name(from.kind)),
            .time = interval(from.time),
            .where = box(from.where),
            .proved = from.is_proved,
            .before = betti(from.before),
            .after = betti(from.after)};
}

std::vector<Solid> solids_of(const topology::Subject& subject,
                             const topology::TimelineHeader& header) {
    std::vector<Solid> solids{{subject.first.surface.label, header.solids[0] < 0}};
    if (subject.second) solids.push_back({subject.second->surface.label, header.solids[1] < 0});
    return solids;
}

} // namespace

Topology::Topology(std::shared_ptr<const Parts> parts)
    : parts_(std::move(parts)) {
    const topology::TimelineRecord& record = parts_->record;
    const topology::Timeline& timeline = record.timeline;
    for (const topology::Event& event : timeline.events) {
        // On the bounds, where nothing changes, an event is no change of topology.
        if (event.kind != topology::Kind::none) events.push_back(event_of(event));
    }
    for (const topology::Unresolved& place : timeline.unresolved) {
        unresolved.push_back({.time = interval(place.time),
                              .where = box(place.where),
                              .why = place.why,
                              .before = betti(place.before),
                              .after = betti(place.after)});
    }
    start = betti(timeline.start);
    end = betti(timeline.end);
    complete = timeline.is_complete();
    doubts = topology::gaps(timeline, record.header.fps);
    solids = solids_of(subject_of(parts_->scene.parts().scene, parts_->settings), record.header);
}

std::string Topology::summary() const { return topology::summary(parts_->record); }
std::string Topology::json() const { return topology::to_json(parts_->record); }
std::string Topology::csv() const { return topology::betti_csv(parts_->record); }

std::string Topology::contact() const {
    return api::with_errors([&] {
        const auto subject = subject_of(parts_->scene.parts().scene, parts_->settings);
        if (!subject.second) return std::string();
        const auto to_world = [&](double time, const std::array<double, 3>& place) {
            const scene::SurfaceAt now = scene::surface_at(subject.first, time);
            const auto& origin = subject.first.surface.field->origin.point;
            const glm::dvec3 at = now.placement.to_world(
                {place[0] - origin[0], place[1] - origin[1], place[2] - origin[2]});
            return std::array{at.x, at.y, at.z};
        };
        return topology::contact_text(
            {subject.first.surface.label, subject.second->surface.label, to_world},
            parts_->record.timeline, parts_->record.header.fps);
    });
}

std::string topology_plan(const Scene& scene, const TopologySettings& settings) {
    return api::with_errors([&] {
        const Scene searched = with_bounds_of_all(scene, settings);
        return search_of(searched.parts().scene, settings).header.title;
    });
}

Topology topology_of(const Scene& scene, const TopologySettings& settings, const Watcher& watcher) {
    return api::with_errors([&] {
        const Scene searched = with_bounds_of_all(scene, settings);
        Search search = search_of(searched.parts().scene, settings);
        search.how.stop = watcher.stop;
        search.how.progress = watcher.progress;
        // Where F has no bounds, all that the search tells is that it could not prove anything.
        for (const std::string& why : topology::why_unbounded(search.subject, search.how.first)) {
            if (watcher.warn) watcher.warn(why);
        }
        topology::Timeline timeline = topology::analyse(search.subject, search.how);
        Topology::Parts parts{searched, settings, {std::move(search.header), std::move(timeline)}};
        return Topology(std::make_shared<const Topology::Parts>(std::move(parts)));
    });
}

} // namespace isomotion
