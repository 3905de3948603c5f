// Where a file states the values of its scene, to tell of one that cannot be used, or leaves its
// range at some time.
#pragma once

#include <map>
#include <string>

namespace isomotion::scene {

// Places by the names of tracks ("camera.fov"), of arrays' fields and counts ("blobs.cx"), and of
// "surface.formula".
template<class Place> using PlacesByName = std::map<std::string, Place>;

// The place of a value, and the part of its name beyond the key there. For one element
// ("blobs.cx[2]") it is the field's place, for a vector or a range its first number's. Null if the
// file states none.
template<class Place> struct PlaceOfValue {
    const Place* place = nullptr;
    std::string key; // of the file, as far as the value's name tells more than the place
    std::string rest;
};

template<class Place, class IsStated>
PlaceOfValue<Place> place_of_value(const PlacesByName<Place>& places, const std::string& name,
                                   IsStated is_stated) {
    const auto is_found = [&](auto it) { return it != places.end() && is_stated(it->second); };
    const auto whole = places.find(name);
    if (is_found(whole)) return {&whole->second, {}, {}};
    const auto part = places.lower_bound(name + ".");
    if (is_found(part) && part->first.starts_with(name + ".")) {
        const std::string& key = part->second.key;
        return {&part->second, key.substr(0, key.size() - (part->first.size() - name.size())), {}};
    }
    const auto field = places.find(name.substr(0, name.find_last_of('[')));
    if (is_found(field)) return {&field->second, {}, name.substr(field->first.size())};
    return {};
}

// A place as errors tell it: "ring.toml:9" and "camera.fov".
struct StatedAt {
    std::string position, key;
};
using ValuePlaces = PlacesByName<StatedAt>;

// Where a scene's file states a value; the file's name and the value's if it states none.
inline StatedAt stated_at(const ValuePlaces* places, const std::string& file,
                          const std::string& name) {
    PlaceOfValue<StatedAt> found;
    if (places) found = place_of_value(*places, name, [](const StatedAt&) { return true; });
    if (!found.place) return {file, name};
    return {found.place->position, (found.key.empty() ? found.place->key : found.key) + found.rest};
}

} // namespace isomotion::scene
