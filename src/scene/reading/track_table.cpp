#include "scene/reading/track_table.h"

#include <algorithm>
#include <cassert>
#include <set>

#include <fmt/format.h>

namespace isomotion::scene {

bool TrackTable::has(const std::string& name) const {
    return std::ranges::any_of(tracks_,
                               [&](const Entry& known) { return known.track.name == name; });
}

TrackId TrackTable::add(const std::string& name,
                        const std::optional<animation::TrackSource>& source, double otherwise,
                        const toml::node* at, const std::string& key) {
    tracks_.push_back({{name, source.value_or(otherwise)}, otherwise, name});
    if (at || !places_.count(name)) place(name, key.empty() ? name : key, at);
    return size() - 1;
}

Vec3Track TrackTable::add(const std::string& name, const std::optional<VectorSource>& source,
                          const std::array<double, 3>& otherwise, const toml::node* at,
                          const std::string& key) {
    Vec3Track tracks;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto component = [&](const std::string& of) {
            return fmt::format("{}.{}", of, "xyz"[k]);
        };
        tracks[k] = add(component(name), source ? std::optional((*source)[k]) : std::nullopt,
                        otherwise[k], at, component(key.empty() ? name : key));
        tracks_.back().of_value = name;
    }
    return tracks;
}

void TrackTable::place(const std::string& name, const std::string& key, const toml::node* at) {
    places_[name] = {key, at};
}

void TrackTable::set(TrackId track, double value) {
    tracks_[std::size_t(track)].track.source = value;
}

void TrackTable::add_to(TrackId track, double number) {
    assert(!has_statements(track));
    animation::TrackSource& source = tracks_[std::size_t(track)].track.source;
    if (double* value = std::get_if<double>(&source)) {
        *value += number;
    } else if (auto* keys = std::get_if<animation::Keys>(&source)) {
        for (animation::Key& key : keys->keys) key.value += number;
    } else {
        auto& text = std::get<animation::Expression>(source).text;
        text = fmt::format("({}) + ({})", text, number);
    }
}

bool TrackTable::has_statements(TrackId track) const {
    const auto* text =
        std::get_if<animation::Expression>(&tracks_[std::size_t(track)].track.source);
    return text && text->text.find(';') != text->text.npos;
}

bool TrackTable::is_number(TrackId track) const {
    return std::holds_alternative<double>(tracks_[std::size_t(track)].track.source);
}

// Replaces the whole value that the name is of: a track, or several, as the ends of a range.
bool TrackTable::replace(const std::string& name) {
    std::set<std::string> values;
    for (const Entry& entry : tracks_) {
        const std::string& track = entry.track.name;
        if (track == name || track.starts_with(name + ".")) values.insert(entry.of_value);
    }
    bool is_new = false;
    for (Entry& entry : tracks_) {
        if (!values.contains(entry.of_value) || entry.is_replaced) continue;
        entry.track.source = entry.otherwise;
        entry.is_replaced = is_new = true;
    }
    return is_new;
}

animation::Animation TrackTable::animate(std::vector<animation::Array>& arrays, std::uint64_t seed,
                                         MistakeList& mistakes) {
    std::vector<animation::Track> tracks;
    while (true) {
        tracks.clear();
        for (const Entry& entry : tracks_) tracks.push_back(entry.track);
        try {
            return animation::Animation(tracks, arrays, seed);
        } catch (const animation::ExpressionError& error) {
            mistakes.attempt([&] { fail_at(error.owner(), error.what()); });
            if (mistakes.is_full()) mistakes.throw_if_any();
            if (replace(error.owner())) continue;
            bool is_field = false;
            for (animation::Array& array : arrays) {
                for (animation::ArrayField& field : array.fields) {
                    if (array.name + "." + field.name != error.owner()) continue;
                    field.source = stand_in_number;
                    is_field = true;
                }
            }
            if (!is_field) mistakes.throw_if_any();
        }
    }
}

void TrackTable::fail_at(const std::string& name, const std::string& message) const {
    const auto it = places_.find(name);
    if (it == places_.end() || !it->second.node) throw SceneError(name + ": " + message);
    fail(*it->second.node, it->second.key, message);
}

void TrackTable::fail_at(const ValueError& error) const {
    const auto found = place_of_value(places_, error.name(),
                                      [](const Place& place) { return place.node != nullptr; });
    if (!found.place) throw error;
    const std::string& key = found.key.empty() ? found.place->key : found.key;
    fail(*found.place->node, fmt::format("{}{} at t = {}", key, found.rest, error.time()),
         error.why());
}

bool TrackTable::replace(const ValueError& error, MistakeList& mistakes) {
    const bool is_in_vain = std::ranges::any_of(tracks_, [&](const Entry& entry) {
        return entry.is_replaced && (entry.track.name == error.name() ||
                                     entry.track.name.starts_with(error.name() + "."));
    });
    if (is_in_vain) return false;
    try {
        mistakes.attempt([&] { fail_at(error); });
    } catch (const ValueError&) {
        if (mistakes.empty()) throw;
        return false;
    }
    return replace(error.name());
}

ValuePlaces TrackTable::stated() const {
    ValuePlaces stated;
    for (const auto& [name, place] : places_) {
        if (place.node) stated[name] = {position(*place.node), place.key};
    }
    return stated;
}

} // namespace isomotion::scene
