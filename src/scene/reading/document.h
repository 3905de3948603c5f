// Typed access to a TOML table that remembers which keys were read.
#pragma once

#include <array>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <toml++/toml.h>

#include "animation/animation.h"
#include "scene/error.h"

namespace isomotion::scene {

// Reads and parses a file. Throws SceneError if it is missing or malformed.
toml::table read_document(const std::filesystem::path& file);
// Messages name `file`, and files that the document names are looked for beside it.
toml::table parse_document(std::string_view text, const std::filesystem::path& file);

// A mistake with its place in the document.
class PlacedError : public SceneError {
public:
    PlacedError(const toml::node& at, const std::string& message)
        : SceneError(message)
        , at_(&at)
        , line_(at.source().begin.line) {}
    // May dangle, since a document that was read for this scene alone is destroyed: compare it
    // only.
    const toml::node* at() const { return at_; }
    unsigned line() const { return line_; }

private:
    const toml::node* at_;
    unsigned line_;
};

// "file:line", or "--set" for a value that was set on the command line.
std::string position(const toml::node& node);
// Throws PlacedError: "file:line: key: message".
[[noreturn]] void fail(const toml::node& at, const std::string& key, const std::string& message);

// One table of a document; `key` is its dotted name. Sections are read key by key. refuse_rest then
// reports the first key that was not read, with the nearest known name.
class Section {
public:
    Section(const toml::table& table, std::string key)
        : table_(&table)
        , key_(std::move(key)) {}

    // Also finds a key under its former name (renamed_keys.h).
    const toml::node* find(const std::string& name);
    bool has(const std::string& name) const { return table_->contains(written(name)); }
    const toml::table& table() const { return *table_; }
    const std::string& key() const { return key_; }
    // The key as the document writes it, for messages.
    std::string dotted(const std::string& name) const;
    std::optional<Section> section(const std::string& name);

    // The tables of [[name]], each a section "name[k]"; empty if there is none. `one`: what a table
    // is.
    std::vector<Section> list(const std::string& name, const char* one, int most);

    std::optional<std::string> text(const std::string& name);
    std::optional<double> number(const std::string& name, double least, double most);
    std::optional<int> integer(const std::string& name, int least, int most);
    std::optional<bool> boolean(const std::string& name);
    std::optional<animation::TrackSource> track(const std::string& name);
    std::optional<std::array<animation::TrackSource, 3>> vector(const std::string& name);

    void refuse_rest();

private:
    std::string written(const std::string& name) const;

    const toml::table* table_;
    std::string key_;
    std::set<std::string> known_;
};

// A number, an expression, or { keys = [[t, v], ...], ease = "linear" }.
animation::TrackSource read_track(const toml::node& node, const std::string& key);
// [x, y, z] of values as above, or { keys = [[t, [x, y, z]], ...], ease = "linear" }.
std::array<animation::TrackSource, 3> read_vector(const toml::node& node, const std::string& key);
double read_finite(const toml::node& node, const std::string& key);

} // namespace isomotion::scene
