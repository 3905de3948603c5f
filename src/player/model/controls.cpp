#include "player/model/controls.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

namespace isomotion::player {
namespace {

using animation::Animation;
using animation::Array;
using animation::ArrayField;
using animation::Track;

constexpr double most_factor = 4;
constexpr int most_samples = 64; // of a timeline, to see how far a track goes

std::string dotted(const Array& array, const ArrayField& field) {
    return array.name + "." + field.name;
}

double finite(const std::string& name, double value) {
    if (std::isfinite(value)) return value;
    throw animation::ExpressionError(name, fmt::format("must be a finite number, not {}", value));
}

const double* find(const std::map<std::string, double>& held, const std::string& name) {
    const auto found = held.find(name);
    return found == held.end() ? nullptr : &found->second;
}

// The column that a field takes from the samples, multiplied in all of them.
void multiply(std::shared_ptr<const animation::ElementSamples>& samples, std::size_t column,
              double factor) {
    samples =
        std::make_shared<const animation::ElementSamples>(samples->multiplied(column, factor));
}

void multiply(Array& array, ArrayField& field, double factor) {
    if (auto* number = std::get_if<double>(&field.source)) *number *= factor;
    if (auto* list = std::get_if<std::vector<double>>(&field.source)) {
        for (double& value : *list) value *= factor;
    }
    if (auto* expression = std::get_if<animation::Expression>(&field.source)) {
        expression->text = fmt::format("{}*({})", factor, expression->text);
    }
    if (const auto* column = std::get_if<animation::Column>(&field.source)) {
        multiply(array.samples, column->index, factor);
    }
}

// The times that a scene is looked at: frames from first to last, and every key between.
std::vector<double> times_of(const scene::OneSurface& one) {
    const animation::Timeline& timeline = one.scene.timeline;
    std::set<double> times;
    const int count = std::min(timeline.frames, most_samples);
    for (int k = 0; k < count; ++k) {
        const auto frame = 1 + std::int64_t(k) * (timeline.frames - 1) / std::max(count - 1, 1);
        times.insert(timeline.time(frame));
    }
    const double last = timeline.time(timeline.frames);
    for (const Track& track : one.surface.animation.tracks()) {
        const auto* keys = std::get_if<animation::Keys>(&track.source);
        if (!keys) continue;
        for (const animation::Key& key : keys->keys) {
            if (0 <= key.time && key.time <= last) times.insert(key.time);
        }
    }
    return {times.begin(), times.end()};
}

// Makes room on the sides that the catalogue leaves open.
void widen(SliderRange& range, const scene::Range& known) {
    const bool moves = range.least < range.most;
    const double size = std::max(std::abs(range.least), std::abs(range.most));
    const double room = moves ? 0.25 * (range.most - range.least) : size > 0 ? size : 1;
    const double low = range.least, high = range.most;
    range.least = std::isfinite(known.least) ? std::min(known.least, low) : low - room;
    range.most = std::isfinite(known.most) ? std::max(known.most, high) : high + room;
    // A value that is never negative does not get a negative range.
    if (!std::isfinite(known.least) && low >= 0 && high > 0)
        range.least = std::max(range.least, 0.0);
    if (!std::isfinite(known.most) && high <= 0 && low < 0) range.most = std::min(range.most, 0.0);
}

} // namespace

Animation apply(const Animation& animation, const Overrides& overrides) {
    if (overrides.empty()) return animation;
    std::vector<Track> tracks = animation.tracks();
    std::vector<Array> arrays = animation.arrays();
    for (Track& track : tracks) {
        if (const double* value = find(overrides.values, track.name)) {
            track.source = finite(track.name, *value);
        }
    }
    for (Array& array : arrays) {
        for (std::size_t f = 0; f < array.fields.size(); ++f) {
            ArrayField& field = array.fields[f];
            const std::string name = dotted(array, field);
            // A field that all elements share is a track; its siblings see it here.
            const double* value = find(overrides.values, name);
            if (value && animation.find(name)) {
                field.source = *value;
            } else if (const double* factor = find(overrides.factors, name)) {
                if (!animation.find(name)) multiply(array, field, finite(name, *factor));
            }
        }
    }
    return Animation(std::move(tracks), std::move(arrays), animation.seed());
}

namespace {

using Named = std::map<std::string, double>;

std::string prefix_of(const std::string& surface) { return surface + "/"; }

Named without_prefix(const Named& all, const std::string& prefix) {
    Named own;
    for (const auto& [name, value] : all) {
        if (name.starts_with(prefix)) own[name.substr(prefix.size())] = value;
    }
    return own;
}

void put(Named& all, const std::string& prefix, const Named& own) {
    std::erase_if(all, [&](const auto& entry) { return entry.first.starts_with(prefix); });
    for (const auto& [name, value] : own) all[prefix + name] = value;
}

} // namespace

Overrides of_surface(const Overrides& all, const scene::OneSurface& one) {
    if (one.is_alone()) return all;
    const std::string prefix = prefix_of(one.surface.label);
    return {without_prefix(all.values, prefix), without_prefix(all.factors, prefix)};
}

void put_surface(Overrides& all, const scene::OneSurface& one, const Overrides& own) {
    if (one.is_alone()) {
        all = own;
        return;
    }
    const std::string prefix = prefix_of(one.surface.label);
    put(all.values, prefix, own.values);
    put(all.factors, prefix, own.factors);
}

scene::Scene apply(scene::Scene scene, const Overrides& overrides) {
    for (std::size_t k = 0; k < scene.surfaces.size(); ++k) {
        animation::Animation& animation = scene.surfaces[k].animation;
        animation = apply(animation, of_surface(overrides, {scene, k}));
    }
    return scene;
}

std::vector<SliderRange> slider_ranges(const scene::OneSurface& one) {
    const scene::Surface& surface = one.surface;
    const auto& tracks = surface.animation.tracks();
    std::vector<SliderRange> ranges;
    ranges.reserve(std::size_t(surface.parameters));
    for (int k = 0; k < surface.parameters; ++k) {
        ranges.push_back({tracks[std::size_t(k)].name, k, HUGE_VAL, -HUGE_VAL, false});
    }
    for (const double time : times_of(one)) {
        const animation::Values values = surface.animation.at(time);
        for (SliderRange& range : ranges) {
            const double value = values.tracks[std::size_t(range.track)];
            if (!std::isfinite(value)) continue;
            range.least = std::min(range.least, value);
            range.most = std::max(range.most, value);
        }
    }
    for (SliderRange& range : ranges) {
        if (range.least > range.most) range.least = range.most = 0; // never a number
        range.moves = range.least < range.most;
        const auto k = std::size_t(range.track);
        widen(range, k < surface.ranges.size() ? surface.ranges[k] : scene::Range{});
    }
    return ranges;
}

std::vector<Slider> sliders(const std::vector<SliderRange>& ranges, const animation::Values& values,
                            const Overrides& overrides) {
    std::vector<Slider> sliders;
    sliders.reserve(ranges.size());
    for (const SliderRange& range : ranges) {
        sliders.push_back({range.name, values.tracks[std::size_t(range.track)], range.least,
                           range.most, range.moves, overrides.values.contains(range.name)});
    }
    return sliders;
}

std::vector<ArrayControls> array_controls(const Animation& animation,
                                          const animation::Values& values,
                                          const Overrides& overrides) {
    std::vector<ArrayControls> all;
    for (std::size_t a = 0; a < animation.arrays().size(); ++a) {
        const Array& array = animation.arrays()[a];
        if (array.is_of_formula) continue;
        ArrayControls controls{array.name, values.arrays[a].count, {}};
        for (const ArrayField& field : array.fields) {
            const std::string name = dotted(array, field);
            if (animation.find(name)) continue; // has one value, and so a slider of its own
            const double* factor = find(overrides.factors, name);
            controls.factors.push_back(
                {name, factor ? *factor : 1, 0, most_factor, false, factor != nullptr});
        }
        all.push_back(std::move(controls));
    }
    return all;
}

} // namespace isomotion::player
