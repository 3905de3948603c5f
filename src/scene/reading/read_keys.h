// Reads the keys of a section by their rows.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "scene/key.h"
#include "scene/reading/document.h"
#include "scene/reading/track_table.h"

namespace isomotion::scene {

// The index of the word that the key has; none if it is not one of them, which is told with the
// nearest word.
std::optional<std::size_t> read_word(Section& section, const char* key,
                                     const std::vector<std::string_view>& words);

template<class Of, class Track, class At, class Value>
void read_key(const keys::Animated<Of, Track, At, Value>& row, Section& section, Of& into,
              TrackTable& tracks) {
    using Row = keys::Animated<Of, Track, At, Value>;
    const toml::node* at = section.find(row.name);
    if (!at && row.kind.needed) section.tell_missing(row.name, row.kind.needed);
    const std::string name = section.full_name(row.name);
    if constexpr (Row::is_vector) {
        const auto source = section.vector(row.name);
        if (!source && !row.kind.standard && Row::may_be_unset) return;
        if (!at && !row.kind.standard && !row.kind.needed) return;
        const auto otherwise = row.kind.standard.value_or(stand_in_vector);
        into.*row.track = tracks.add(name, source, otherwise, at, section.dotted(row.name));
    } else {
        const auto source = section.track(row.name);
        if (!source && !row.kind.standard && Row::may_be_unset) return;
        if (!at && !row.kind.standard && !row.kind.needed) return;
        const double otherwise = row.kind.standard ? row.kind.standard->front() : stand_in_number;
        into.*row.track = tracks.add(name, source, otherwise, at, section.dotted(row.name));
    }
}

template<class Of, class Value>
void read_key(const keys::Still<Of, Value>& row, Section& section, Of& into) {
    const auto read = [&] {
        if constexpr (std::is_same_v<Value, int>) {
            return section.integer(row.name, int(row.allowed.least), int(row.allowed.most));
        } else if constexpr (std::is_same_v<Value, double>) {
            return section.number(row.name, row.allowed.least, row.allowed.most);
        } else {
            return section.boolean(row.name);
        }
    };
    if (const auto value = read()) into.*row.member = *value;
}

template<class Of, class E>
void read_key(const keys::Choice<Of, E>& row, Section& section, Of& into) {
    std::vector<std::string_view> names;
    for (const auto& word : row.words) names.push_back(word.name);
    if (const auto word = read_word(section, row.name, names))
        into.*row.member = row.words[*word].value;
}

template<class Of> void read_key(const keys::ReadByHand&, Section&, Of&) {}

// Reads the keys of the table that stand in the section, and gives the others their defaults.
template<class Table, class Of, class... Tracks>
void read_keys(const Table& table, Section& section, Of& into, Tracks&... tracks) {
    keys::for_each_row(table, [&]<class Row>(const Row& row) {
        if constexpr (keys::is_animated<Row>) {
            read_key(row, section, into, tracks...);
        } else {
            read_key(row, section, into);
        }
    });
}

// Tells keys that stand in the section, but are of another kind of thing.
template<class Table>
void refuse_keys(const Table& table, Section& section, const std::string& why) {
    keys::for_each_row(table, [&](const auto& row) {
        if (section.find(row.name)) section.tell(row.name, why);
    });
}

// Marks the keys as known, for what is not read since it follows from another mistake.
template<class Table> void pass_over(const Table& table, Section& section) {
    keys::for_each_row(table, [&](const auto& row) { section.find(row.name); });
}

} // namespace isomotion::scene
