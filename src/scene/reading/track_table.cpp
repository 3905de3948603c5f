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
    const auto is_placed = [&](auto it) { return it != places_.end() && it->second.node; };
    const std::string& name = error.name();
    // One element's value is where its field is; a range or a vector where its first number is.
    const auto known = places_.find(name.substr(0, name.find_last_of('[')));
    const auto whole = places_.find(name);
    const auto part = places_.lower_bound(name + ".");
    const std::string time = fmt::format(" at t = {}", error.time());
    if (is_placed(whole)) fail(*whole->second.node, whole->second.key + time, error.why());
    if (is_placed(part) && part->first.starts_with(name + "."))
        fail(*part->second.node, name + time, error.why());
    if (is_placed(known))
        fail(*known->second.node, known->second.key + name.substr(known->first.size()) + time,
             error.why());
    throw error;
}

} // namespace isomotion::scene
