// Reads the keys of a section by their rows.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "scene/key.h"
#include "scene/reading/document.h"
#include "scene/reading/track_table.h"

namespace isomotion::scene {

// The index of the word that the key has. Throws PlacedError, with the nearest word if there is
// one.
std::size_t read_word(Section& section, const char* key, const std::string& text,
                      const std::vector<std::string_view>& words);

template<class Of, class Track, class At, class Value>
void read_key(const keys::Animated<Of, Track, At, Value>& row, Section& section, Of& into,
              TrackTable& tracks) {
    const toml::node* at = section.find(row.name);
    const std::string key = section.dotted(row.name);
    if (!at && row.kind.needed)
        fail(section.table(), key, fmt::format("is missing; give {}", row.kind.needed));
    if (!at && !row.kind.standard) return;
    if constexpr (row.is_vector) {
        into.*row.track = at ? tracks.add(key, *section.vector(row.name), at)
                             : tracks.add(key, (*row.kind.standard)[0], (*row.kind.standard)[1],
                                          (*row.kind.standard)[2]);
    } else {
        into.*row.track =
            tracks.add(key, at ? *section.track(row.name) : row.kind.standard->front(), at);
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
    const auto text = section.text(row.name);
    if (!text) return;
    std::vector<std::string_view> names;
    for (const auto& word : row.words) names.push_back(word.name);
    into.*row.member = row.words[read_word(section, row.name, *text, names)].value;
}

template<class Of> void read_key(const keys::ReadByHand&, Section&, Of&) {}

// Reads the keys of the table that stand in the section, and gives the others their defaults.
// Throws PlacedError.
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

// Refuses keys that stand in the section, but are of another kind of thing.
template<class Table>
void refuse_keys(const Table& table, Section& section, const std::string& why) {
    keys::for_each_row(table, [&](const auto& row) {
        if (const toml::node* node = section.find(row.name))
            fail(*node, section.dotted(row.name), why);
    });
}

} // namespace isomotion::scene
