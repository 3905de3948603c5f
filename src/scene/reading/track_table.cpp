#include "scene/reading/track_table.h"

#include <fmt/format.h>

namespace isomotion::scene {

TrackId TrackTable::add(const std::string& name, animation::TrackSource source,
                        const toml::node* at) {
    tracks_.push_back({name, std::move(source)});
    if (at || !places_.count(name)) place(name, name, at);
    return int(tracks_.size()) - 1;
}

Vec3Track TrackTable::add(const std::string& name,
                          const std::array<animation::TrackSource, 3>& source,
                          const toml::node* at) {
    return {add(name + ".x", source[0], at), add(name + ".y", source[1], at),
            add(name + ".z", source[2], at)};
}

void TrackTable::place(const std::string& name, const std::string& key, const toml::node* at) {
    places_[name] = {key, at};
}

animation::Animation TrackTable::animate(std::vector<animation::Array> arrays,
                                         std::uint64_t seed) const {
    try {
        return animation::Animation(tracks_, std::move(arrays), seed);
    } catch (const animation::ExpressionError& error) {
        fail_at(error.owner(), error.what());
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

ValuePlaces TrackTable::stated() const {
    ValuePlaces stated;
    for (const auto& [name, place] : places_) {
        if (place.node) stated[name] = {position(*place.node), place.key};
    }
    return stated;
}

} // namespace isomotion::scene
