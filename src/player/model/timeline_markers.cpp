#include "player/model/timeline_markers.h"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "topology/timeline/document.h"
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
    for (const animation::Track& track : timeline.animation.tracks()) {
        const auto* keys = std::get_if<animation::Keys>(&track.source);
        if (!keys) continue;
        for (const animation::Key& key : keys->keys) tracks[key.time].push_back(track.name);
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

TopologyMarkers topology_markers(const scene::Scene& scene, const topology::TimelineRecord& record,
                                 const std::string& file) {
    if (record.header.fingerprint != topology::fingerprint(scene)) {
        return {{},
                fmt::format("{}: is of another scene than is shown: its formula, parameters or "
                            "bounds differ; isomotion topology {} -o {} makes it anew",
                            file, scene.file.string(), timeline_path(scene).string())};
    }
    const animation::FrameRate fps = scene.timeline.fps;
    const topology::Timeline& timeline = record.timeline;
    TopologyMarkers found;
    const auto marker = [&](TimelineMarker::Kind kind, formula::Interval time,
                            const std::string& text) {
        const double frame = topology::frame_at(fps, middle(time, timeline.range));
        if (frame < 1 || frame > scene.timeline.frames) return;
        found.markers.push_back(
            {kind, frame, fmt::format("{} at frame {}", text, topology::frame_text(frame))});
    };
    for (const topology::Event& event : timeline.events) {
        if (event.kind != topology::Kind::none)
            marker(TimelineMarker::Kind::event, event.time, what(event));
    }
    for (const topology::Unresolved& place : timeline.unresolved) {
        marker(TimelineMarker::Kind::unresolved, place.time,
               fmt::format("unresolved ({})", place.why));
    }
    std::ranges::stable_sort(found.markers, {}, &TimelineMarker::frame);
    return found;
}

TopologyMarkers read_topology_markers(const scene::Scene& scene, const fs::path& file) {
    std::error_code ignored;
    if (!fs::exists(file, ignored)) return {};
    try {
        return topology_markers(scene, topology::read_timeline(file), file.string());
    } catch (const topology::DocumentError& error) {
        return {{}, error.what()};
    }
}

fs::path timeline_path(const scene::Scene& scene) {
    fs::path file = scene.file;
    return file.replace_extension(".timeline.json");
}

} // namespace isomotion::player
