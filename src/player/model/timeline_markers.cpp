#include "player/model/timeline_markers.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/input_error.h"
#include "scene/surfaces.h"
#include "topology/timeline/timeline_file.h"
#include "topology/timeline/words.h"

namespace isomotion::player {
namespace fs = std::filesystem;
namespace {

// The three components of a vector are one name.
std::vector<std::string> joined(const std::vector<std::string>& tracks) {
    const std::set<std::string> known(tracks.begin(), tracks.end());
    std::vector<std::string> names;
    for (const std::string& track : tracks) {
        const std::string stem =
            track.size() > 2 ? track.substr(0, track.size() - 2) : std::string();
        const bool whole = !stem.empty() && known.contains(stem + ".x") &&
                           known.contains(stem + ".y") && known.contains(stem + ".z");
        const std::string name = whole ? stem : track;
        if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    }
    return names;
}

// The middle of what is known of a time, which may be known to the end of the range only.
double middle(formula::Interval time, formula::Interval range) {
    return mid(
        formula::Interval(std::max(time.lo, range.lo),
                          std::max(std::min(time.hi, range.hi), std::max(time.lo, range.lo))));
}

// The middle of a place, counted as the surface's own coordinates are.
glm::dvec3 middle_of(const std::array<formula::Interval, 3>& where, const scene::OneSurface& one) {
    const auto& origin = one.surface.field->origin.point;
    return {mid(where[0]) - origin[0], mid(where[1]) - origin[1], mid(where[2]) - origin[2]};
}

// What makes a timeline anew.
std::string command_for(const scene::OneSurface& one, const std::string& timeline) {
    const std::string whole = timeline_path(one.scene).string();
    const std::string& label = one.surface.label;
    const bool is_named = timeline != whole && !label.empty();
    return fmt::format("isomotion topology {}{} -o {}", one.scene.file.string(),
                       is_named ? " --surface " + label : "", is_named ? timeline : whole);
}

std::string what(const topology::Event& event) {
    std::string text(event.kind == topology::Kind::unknown ? "event of unknown kind"
                                                           : topology::name(event.kind));
    if (!event.is_proved) text += " (not proved)";
    return text;
}

} // namespace

std::vector<TimelineMarker> key_markers(const scene::Scene& scene) {
    const animation::Timeline& timeline = scene.timeline;
    std::map<double, std::vector<std::string>> tracks; // by the time of a key
    for (const scene::Surface& surface : scene.surfaces) {
        for (const animation::Track& track : surface.animation.tracks()) {
            const auto* keys = std::get_if<animation::Keys>(&track.source);
            if (!keys) continue;
            for (const animation::Key& key : keys->keys) {
                auto& there = tracks[key.time];
                // What surfaces share is a track of each.
                if (!std::ranges::count(there, track.name)) there.push_back(track.name);
            }
        }
    }
    std::vector<TimelineMarker> markers;
    for (const auto& [time, names] : tracks) {
        const double frame = topology::frame_at(timeline.fps, time);
        if (frame < 1 || frame > timeline.frames) continue;
        const auto whole = joined(names);
        markers.push_back(
            {TimelineMarker::Kind::key, frame,
             fmt::format("{} of {}", whole.size() == 1 ? "key" : "keys", fmt::join(whole, ", "))});
    }
    return markers;
}

TopologyMarkers topology_markers(const scene::OneSurface& one,
                                 const topology::TimelineRecord& record, const std::string& file) {
    if (record.header.fingerprint != topology::fingerprint(one)) {
        return {{},
                {},
                fmt::format("{}: is of another scene than is shown: its formula, parameters or "
                            "bounds differ; {} makes it anew",
                            file, command_for(one, file))};
    }
    const animation::FrameRate fps = one.scene.timeline.fps;
    const topology::Timeline& timeline = record.timeline;
    TopologyMarkers found;
    // Whether it is within the scene's frames.
    const auto marker = [&](TimelineMarker::Kind kind, formula::Interval time,
                            const std::string& text) {
        const double frame = topology::frame_at(fps, middle(time, timeline.range));
        if (frame < 1 || frame > one.scene.timeline.frames) return false;
        found.markers.push_back(
            {kind, frame, fmt::format("{} at frame {}", text, topology::frame_text(frame))});
        return true;
    };
    for (const topology::Event& event : timeline.events) {
        if (event.kind == topology::Kind::none) continue;
        if (!marker(TimelineMarker::Kind::event, event.time, what(event))) continue;
        const double frame = found.markers.back().frame;
        found.events.push_back(
            {frame, frame, event.kind, true, event.is_proved, middle_of(event.where, one), 0});
    }
    for (const topology::Unresolved& place : timeline.unresolved) {
        if (!marker(TimelineMarker::Kind::unresolved, place.time,
                    fmt::format("unresolved ({})", place.why)))
            continue;
        const auto is_bounded = [](formula::Interval i) {
            return std::isfinite(i.lo) && std::isfinite(i.hi);
        };
        if (!std::ranges::all_of(place.where, is_bounded)) continue;
        found.events.push_back({std::max(1.0, topology::frame_at(fps, place.time.lo)),
                                topology::frame_at(fps, place.time.hi), topology::Kind::unknown,
                                false, false, middle_of(place.where, one), 0});
    }
    std::ranges::stable_sort(found.markers, {}, &TimelineMarker::frame);
    return found;
}

TopologyMarkers read_topology_markers(const scene::OneSurface& one, const fs::path& file) {
    std::error_code ignored;
    if (!fs::exists(file, ignored)) return {};
    try {
        return topology_markers(one, topology::read_timeline(file), file.string());
    } catch (const base::InputError& error) {
        return {{}, {}, error.what()};
    }
}

fs::path timeline_path(const scene::Scene& scene) {
    fs::path file = scene.file;
    return file.replace_extension(".timeline.json");
}

fs::path timeline_path(const scene::Scene& scene, const std::string& surface) {
    fs::path file = scene.file;
    return file.replace_extension("." + surface + ".timeline.json");
}

TopologyMarkers read_topology_markers_of_each(const scene::Scene& scene) {
    TopologyMarkers all;
    const std::vector<std::string> names = scene::surface_names(scene);
    for (int k = 0; k < int(names.size()); ++k) {
        const std::string& name = names[std::size_t(k)];
        TopologyMarkers one =
            read_topology_markers({scene, std::size_t(k)}, timeline_path(scene, name));
        for (TimelineMarker& marker : one.markers) {
            marker.label = name + ": " + marker.label;
            all.markers.push_back(std::move(marker));
        }
        for (PlacedEvent& event : one.events) {
            event.surface = k;
            all.events.push_back(event);
        }
        if (all.refusal.empty()) all.refusal = std::move(one.refusal);
    }
    std::ranges::stable_sort(all.markers, {}, &TimelineMarker::frame);
    return all;
}

} // namespace isomotion::player
