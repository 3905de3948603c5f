// Collects every animated value of a scene as a named track, with its place in the file for errors.
#pragma once

#include <optional>

#include "scene/reading/document.h"
#include "scene/scene.h"
#include "scene/value_error.h"
#include "scene/value_places.h"

namespace isomotion::scene {

// What stands in for a value that is wrong, so that reading goes on.
inline constexpr double stand_in_number = 1;
inline constexpr std::array<double, 3> stand_in_vector{3, 2, 1};

using VectorSource = std::array<animation::TrackSource, 3>;

class TrackTable {
public:
    // `otherwise`: the value without a source, and in place of one that turns out to be wrong. `at`
    // may be null for a default, which keeps a place remembered before. `key`: as the document
    // calls it, if that is not the name.
    TrackId add(const std::string& name, const std::optional<animation::TrackSource>& source,
                double otherwise, const toml::node* at, const std::string& key = {});
    Vec3Track add(const std::string& name, const std::optional<VectorSource>& source,
                  const std::array<double, 3>& otherwise, const toml::node* at,
                  const std::string& key = {});
    Vec3Track add(const std::string& name, double x, double y, double z) {
        return add(name, std::nullopt, {x, y, z}, nullptr);
    }
    // Remembers where `name` ("blobs.cx") is defined.
    void place(const std::string& name, const std::string& key, const toml::node* at);

    bool has(const std::string& name) const;
    int size() const { return int(tracks_.size()); }
    // Lets a track have this value at all times.
    void set(TrackId track, double value);
    // Adds a number to the values of a track whose expression has no statements before it.
    void add_to(TrackId track, double number);
    bool has_statements(TrackId track) const;
    // Whether a track has one value at all times.
    bool is_number(TrackId track) const;

    // Builds the animation. Expressions that are wrong are told, each at its place in the file, and
    // replaced.
    animation::Animation animate(std::vector<animation::Array>& arrays, std::uint64_t seed,
                                 MistakeList& mistakes);
    // Tells the error at its place, and replaces the value. Returns false where nothing can stand
    // in for it, or has done so in vain. Throws the error as it is if its place is not known,
    // unless it may follow from a mistake that was told.
    bool replace(const ValueError& error, MistakeList& mistakes);

    // Throws PlacedError at the value's place if that is known, otherwise SceneError.
    [[noreturn]] void fail_at(const std::string& name, const std::string& message) const;
    // The places of all values that the file states.
    ValuePlaces stated() const;

private:
    struct Place {
        std::string key;
        const toml::node* node = nullptr;
    };
    struct Entry {
        animation::Track track;
        double otherwise;
        std::string of_value; // the name of the vector that it is a component of, or its own
        bool is_replaced = false;
    };
    bool replace(const std::string& name);
    [[noreturn]] void fail_at(const ValueError& error) const;

    std::vector<Entry> tracks_;
    PlacesByName<Place> places_;
};

} // namespace isomotion::scene
