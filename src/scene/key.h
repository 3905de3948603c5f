// A key of a scene file, as one row of a table (key_tables.h): its name, the member that holds it,
// the values that it may have, its unit, its default, and what documents and editors say of it.
//
// From the rows come the reader (reading/read_keys.h), the values at a time and their change of
// coordinates (key_values.h), the JSON schema and the tables of docs/scene-file.md
// (reading/key_documents.h).
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "scene/scene.h"

namespace isomotion::scene::keys {

inline constexpr double unbounded = std::numeric_limits<double>::infinity();

// The numbers that a key may have.
struct Allowed {
    double least = -unbounded, most = unbounded;
    bool without_least = false, without_most = false; // the ends themselves don't belong to it

    constexpr bool contains(double value) const {
        return (without_least ? value > least : value >= least) &&
               (without_most ? value < most : value <= most);
    }
    // "from 0 to 1", "0 or above", "above 0 and below 180"; empty if any number is.
    std::string words() const;
};

constexpr Allowed from_to(double least, double most) { return {least, most}; }
constexpr Allowed at_least(double least) { return {least}; }
constexpr Allowed above(double least) { return {least, unbounded, true}; }
constexpr Allowed between(double least, double most) { return {least, most, true, true}; }

// How a value changes with the coordinates that it is given in.
enum class Unit { none, length, per_length, position, direction, color };

struct Kind {
    Allowed allowed = {};
    Unit unit = Unit::none;
    // Where the file doesn't say it; of a number the first. Without it the member stays unset.
    std::optional<std::array<double, 3>> standard = {};
    const char* needed = nullptr; // for a key that must be there: completes "is missing; give "
};

// For values that scene_at.cpp finds from several keys.
struct FoundByHand {};

// A number or a vector that may move: `track` is a TrackId, a Vec3Track or an optional one.
template<class Of, class Track, class At, class Value> struct Animated {
    const char* name;
    Track Of::*track;
    Value At::*value;
    Kind kind;
    const char* what;
    const char* otherwise; // its default in words, if `kind` has none

    static constexpr bool is_vector =
        std::is_same_v<Track, Vec3Track> || std::is_same_v<Track, std::optional<Vec3Track>>;
    static constexpr bool may_be_unset = std::is_same_v<Track, std::optional<TrackId>> ||
                                         std::is_same_v<Track, std::optional<Vec3Track>>;
};

template<class Of, class Track, class At, class Value>
constexpr auto animated(const char* name, Track Of::*track, Value At::*value, Kind kind,
                        const char* what, const char* otherwise = "") {
    return Animated<Of, Track, At, Value>{name, track, value, kind, what, otherwise};
}
template<class Of, class Track>
constexpr auto animated(const char* name, Track Of::*track, Kind kind, const char* what,
                        const char* otherwise = "") {
    return Animated<Of, Track, FoundByHand, double>{name, track, nullptr, kind, what, otherwise};
}

// A number, an integer or a truth value that doesn't move. Its default is the member's.
template<class Of, class Value> struct Still {
    const char* name;
    Value Of::*member;
    Allowed allowed;
    const char* what;
    const char* otherwise;
};

template<class Of, class Value>
constexpr auto still(const char* name, Value Of::*member, Allowed allowed, const char* what,
                     const char* otherwise = "") {
    return Still<Of, Value>{name, member, allowed, what, otherwise};
}

template<class E> struct Word {
    E value;
    std::string_view name;
};

// One of some words.
template<class Of, class E> struct Choice {
    const char* name;
    E Of::*member;
    std::span<const Word<E>> words;
    const char* what;
    const char* otherwise;
};

template<class Of, class E, std::size_t n>
constexpr auto choice(const char* name, E Of::*member, const std::array<Word<E>, n>& words,
                      const char* what, const char* otherwise = "") {
    return Choice<Of, E>{name, member, words, what, otherwise};
}

// The words of a table whose rows have a name.
template<class Row, std::size_t n, class E>
constexpr std::array<Word<E>, n> words_of(const Row (&rows)[n], E Row::*value) {
    std::array<Word<E>, n> words{};
    for (std::size_t k = 0; k < n; ++k) words[k] = {rows[k].*value, rows[k].name};
    return words;
}

template<class E, std::size_t n>
constexpr std::string_view name(const std::array<Word<E>, n>& words, E value) {
    for (const Word<E>& word : words) {
        if (word.value == value) return word.name;
    }
    return "?";
}

// A key that has a reader of its own; `schema` is its JSON schema.
struct ReadByHand {
    const char* name;
    const char* schema;
    const char* what;
    const char* otherwise = "";
};

template<class Table, class Visit> constexpr void for_each_row(const Table& table, Visit&& visit) {
    std::apply([&](const auto&... rows) { (visit(rows), ...); }, table);
}

template<class Row> inline constexpr bool is_animated = false;
template<class Of, class Track, class At, class Value>
inline constexpr bool is_animated<Animated<Of, Track, At, Value>> = true;

// The track of a key, or null if the scene leaves it unset.
template<class Row, class Of> auto* set_track(const Row& row, Of& of) {
    auto& member = of.*row.track;
    if constexpr (Row::may_be_unset) {
        return member ? &*member : nullptr;
    } else {
        return &member;
    }
}

// Calls visit() with each track that is set, once for each component of a vector.
template<class Table, class Of, class Visit>
void for_each_track(const Table& table, Of& of, const Visit& visit) {
    for_each_row(table, [&]<class Row>(const Row& row) {
        if constexpr (is_animated<Row>) {
            auto* track = set_track(row, of);
            if (!track) return;
            if constexpr (Row::is_vector) {
                for (auto& component : *track) visit(component);
            } else {
                visit(*track);
            }
        }
    });
}

} // namespace isomotion::scene::keys
