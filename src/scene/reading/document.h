// Typed access to a TOML table that remembers which keys were read.
#pragma once

#include <array>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <toml++/toml.h>

#include "animation/animation.h"
#include "scene/error.h"
#include "scene/reading/mistakes.h"

namespace isomotion::scene {

// Reads and parses a file. Throws SceneError if it is missing or malformed.
toml::table read_document(const std::filesystem::path& file);
// Messages name `file`, and files that the document names are looked for beside it.
toml::table parse_document(std::string_view text, const std::filesystem::path& file);

// "file:line", or "--set" for a value that was set on the command line.
std::string position(const toml::node& node);
// Throws PlacedError: "file:line: key: message".
[[noreturn]] void fail(const toml::node& at, const std::string& key, const std::string& message);

// A part of a scene that is read key by key: a table of the document, or several of which the first
// that has a key counts, such as a surface's own material and the one that all surfaces share.
//
// A value of the wrong kind is told in the list of mistakes, and counts as absent. refuse_rest
// tells of keys that were not read, each with the nearest known name.
class Section {
public:
    // A table, and its dotted name as messages call it.
    struct Layer {
        const toml::table* table;
        std::string key;
    };

    // `name`: dotted, as a scene of one surface has it: "material.contours".
    Section(std::vector<Layer> layers, std::string name, MistakeList& mistakes)
        : layers_(std::move(layers))
        , name_(std::move(name))
        , mistakes_(&mistakes) {}
    Section(const toml::table& table, const std::string& name, MistakeList& mistakes)
        : Section(std::vector<Layer>{{&table, name}}, name, mistakes) {}

    // Also finds a key under its former name (renamed_keys.h).
    const toml::node* find(const std::string& name);
    bool has(const std::string& name) const { return layer_with(name) != nullptr; }
    // Its keys, sorted.
    std::vector<std::string> names() const;
    // The table that messages about all of it are about.
    const toml::table& table() const { return *layers_.front().table; }
    const std::vector<Layer>& layers() const { return layers_; }
    const std::string& key() const { return layers_.front().key; }
    MistakeList& mistakes() const { return *mistakes_; }
    // The key as the document writes it, for messages.
    std::string dotted(const std::string& name) const;
    // Its name whichever table has it, for tracks.
    std::string full_name(const std::string& name) const;

    // Tells a mistake of the table, or of one of its keys, which must be there.
    void tell(const std::string& message);
    void tell(const std::string& name, const std::string& message);
    // Tells that a key is missing; `what` is to be given.
    void tell_missing(const std::string& name, const std::string& what);
    // Whether the key's value was told to be wrong.
    bool is_wrong(const std::string& name) const { return wrong_.contains(name); }
    // Calls read(), which throws PlacedError where the key is wrong.
    template<class Read> void attempt(const std::string& name, Read&& read) {
        if (!mistakes_->attempt(std::forward<Read>(read))) wrong_.insert(name);
    }

    // A section of the first table that has it; of the document, of all tables.
    std::optional<Section> section(const std::string& name);
    // The sections of that name of all tables.
    std::optional<Section> merged_section(const std::string& name);
    // The tables of [[name]], each a section "name[k]"; empty if there is none. `one`: what a table
    // is.
    std::vector<Section> list(const std::string& name, const char* one, int most);
    std::optional<std::string> text(const std::string& name);
    std::optional<double> number(const std::string& name, double least, double most);
    std::optional<int> integer(const std::string& name, int least, int most);
    std::optional<bool> boolean(const std::string& name);
    std::optional<animation::TrackSource> track(const std::string& name);
    std::optional<std::array<animation::TrackSource, 3>> vector(const std::string& name);

    // Returns whether there are none.
    bool refuse_rest();

private:
    std::string written(const Layer& layer, const std::string& name) const;
    const Layer* layer_with(const std::string& name) const;
    std::optional<Section> section_of(const std::string& name, bool merges);
    // What read(node) gives for the key, if it is there and right.
    template<class Read>
    auto value(const std::string& name, Read&& read)
        -> std::optional<decltype(read(std::declval<const toml::node&>()))>;

    std::vector<Layer> layers_; // at least one
    std::string name_;
    MistakeList* mistakes_;
    std::set<std::string> known_, wrong_;
};

// A number, an expression, or { keys = [[t, v], ...], ease = "linear" }.
animation::TrackSource read_track(const toml::node& node, const std::string& key);
// [x, y, z] of values as above, or { keys = [[t, [x, y, z]], ...], ease = "linear" }.
std::array<animation::TrackSource, 3> read_vector(const toml::node& node, const std::string& key);
double read_finite(const toml::node& node, const std::string& key);

} // namespace isomotion::scene
