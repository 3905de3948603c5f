// Collects every animated value of a scene as a named track, with its place in the file for errors.
#pragma once

#include "scene/reading/document.h"
#include "scene/scene.h"
#include "scene/value_error.h"
#include "scene/value_places.h"

namespace isomotion::scene {

class TrackTable {
public:
    // `at` may be null for a default, which keeps a place remembered before.
    TrackId add(const std::string& name, animation::TrackSource source, const toml::node* at);
    Vec3Track add(const std::string& name, const std::array<animation::TrackSource, 3>& source,
                  const toml::node* at);
    Vec3Track add(const std::string& name, double x, double y, double z) {
        return add(name, std::array<animation::TrackSource, 3>{x, y, z}, nullptr);
    }
    // Remembers where `name` ("blobs.cx") is defined.
    void place(const std::string& name, const std::string& key, const toml::node* at);

    int size() const { return int(tracks_.size()); }
    const std::vector<animation::Track>& tracks() const { return tracks_; }

    // Builds the animation. Reports an error in an expression at its place in the file.
    animation::Animation animate(std::vector<animation::Array> arrays, std::uint64_t seed) const;
    [[noreturn]] void fail_at(const std::string& name, const std::string& message) const;
    // Throws the error with its place if that is known, otherwise as it is.
    [[noreturn]] void fail_at(const ValueError& error) const;
    // The places of all values that the file states.
    ValuePlaces stated() const;

private:
    struct Place {
        std::string key;
        const toml::node* node = nullptr;
    };
    std::vector<animation::Track> tracks_;
    PlacesByName<Place> places_;
};

} // namespace isomotion::scene
