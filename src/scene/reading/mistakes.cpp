#include "scene/reading/mistakes.h"

#include <algorithm>
#include <iterator>
#include <string_view>

#include <fmt/format.h>

namespace isomotion::scene {
namespace {

constexpr std::size_t most_told = 20;

// Keys and indices from the document down to a node: "camera", "fov"; "lights", "0", "color".
using Path = std::vector<std::string>;

bool find_path(const toml::node& from, const toml::node* wanted, Path& path) {
    if (&from == wanted) return true;
    const auto goes_by = [&](const std::string& step, const toml::node& next) {
        path.push_back(step);
        if (find_path(next, wanted, path)) return true;
        path.pop_back();
        return false;
    };
    if (const toml::table* table = from.as_table()) {
        for (const auto& [key, next] : *table) {
            if (goes_by(std::string(key.str()), next)) return true;
        }
    }
    if (const toml::array* array = from.as_array()) {
        for (std::size_t k = 0; k < array->size(); ++k) {
            if (goes_by(std::to_string(k), *array->get(k))) return true;
        }
    }
    return false;
}

bool begins_with(const Path& path, const Path& start) {
    return path.size() >= start.size() && std::equal(start.begin(), start.end(), path.begin());
}

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
    return std::ranges::count(words, word) > 0;
}

// Whether the mistake is in the formula itself, or is that there is none.
bool is_of_formula(const Path& path) {
    return !path.empty() && path[0] == "surface" &&
           (path.size() == 1 || is_one_of(path[1], {"formula", "use"}));
}

// A field of an array that stands in the document.
bool is_field(const Path& path) {
    return path.size() == 3 && path[0] == "arrays" &&
           !is_one_of(path[2], {"count", "file", "columns", "first_file"});
}

// Whether all that follows is read by it and nothing can stand in for it: an array, and a formula
// that colours of elements depend on.
bool decides_all(const toml::table& root, const Path& path) {
    if (path.empty()) return true;
    if (is_of_formula(path)) return root.contains("arrays");
    return path[0] == "arrays" && !is_field(path);
}

// Tables of elements may be large: they are not read again and again.
bool has_large_arrays(const toml::table& root) {
    constexpr std::int64_t large = 10'000; // elements
    const toml::table* arrays = root["arrays"].as_table();
    if (!arrays) return root.contains("arrays");
    for (const auto& [name, node] : *arrays) {
        const toml::table* array = node.as_table();
        if (!array || array->contains("file") || (*array)["count"].value_or(large) >= large)
            return true;
    }
    return false;
}

// The whole value that a place of a mistake is in: "camera.target" of "camera.target.1".
Path value_of(const toml::table& root, const Path& path) {
    const toml::node* node = &root;
    Path value;
    for (const std::string& step : path) {
        const toml::table* table = node->as_table();
        const toml::array* array = node->as_array();
        // No others have stand-ins: a vector of three tables of keys is one value.
        const bool is_list_of_tables = array && array->is_array_of_tables() && value.size() == 1 &&
                                       is_one_of(value[0], {"lights", "sections"});
        if (!table && !is_list_of_tables) break;
        value.push_back(step);
        node = table ? table->get(step) : array->get(std::stoul(step));
        if (node->is_table() && node->as_table()->contains("keys")) break;
    }
    return value;
}

// Puts a right value in place of one that others are read by: parameters and fields are named in
// other values, frames are counted, unless their seconds are, a camera with a position has no
// orbit, and a light comes from somewhere.
void put_stand_in(toml::table& table, const Path& path) {
    const std::string& key = path.back();
    const auto put = [&](auto value) { table.insert_or_assign(key, std::move(value)); };
    if (path.size() == 2 && path[0] == "parameters") put(1.0);
    if (is_field(path)) put(1.0);
    if (path == Path{"time", "frames"} && !table.contains("seconds")) put(1'000'000);
    if (path == Path{"camera", "position"}) put(toml::array{3, 2, 1});
    if (path == Path{"surface", "bounds"}) put(toml::table{{"sphere", 1}});
    if (begins_with(path, {"surface", "bounds"}) && is_one_of(key, {"sphere", "box"})) {
        table.erase("box");
        table.insert_or_assign("sphere", 1);
    }
    if (path.size() != 3) return;
    if (path[0] == "lights" && is_one_of(key, {"direction", "position"}))
        put(toml::array{0, 0, 1e3});
    if (path[0] == "sections" && key == "normal") put(toml::array{0, 0, 1});
    if (path[0] == "sections" && key == "sphere") put(0);
}

// A right table in place of one of a list, whose others keep their numbers.
toml::table listed_stand_in(const Path& path) {
    if (path[0] == "sections") return toml::table{{"sphere", 0}};
    return toml::table{{"direction", toml::array{0, 0, 1}}};
}

// Takes out the keys that only some values at this path know.
void take_out_with(toml::table& parent, const Path& path) {
    if (path == Path{"material", "model"}) {
        for (const char* key : {"shininess", "roughness", "metallic", "specular"})
            parent.erase(key);
    }
    if (path == Path{"camera", "projection"}) parent.erase("height");
}

void take_out(toml::table& root, const Path& path, bool has_stand_in) {
    if (is_of_formula(path)) {
        toml::table surface;
        if (toml::table* given = root["surface"].as_table()) surface = std::move(*given);
        surface.erase("use");
        surface.insert_or_assign("formula", "x");
        if (!surface.contains("bounds")) surface.insert("bounds", toml::table{{"sphere", 1}});
        root.insert_or_assign("surface", std::move(surface));
        return;
    }
    toml::node* parent = &root;
    for (std::size_t k = 0; k + 1 < path.size(); ++k) {
        parent = parent->is_table() ? parent->as_table()->get(path[k])
                                    : parent->as_array()->get(std::stoul(path[k]));
    }
    if (toml::array* list = parent->as_array()) {
        const auto at = list->begin() + std::ptrdiff_t(std::stoul(path.back()));
        list->replace(at, listed_stand_in(path));
        return;
    }
    parent->as_table()->erase(path.back());
    take_out_with(*parent->as_table(), path);
    if (has_stand_in) put_stand_in(*parent->as_table(), path);
}

std::string text_of(const std::vector<ToldMistake>& told) {
    std::vector<std::string> messages;
    std::ranges::transform(told, std::back_inserter(messages), &ToldMistake::message);
    return fmt::format("{}", fmt::join(messages, "\n"));
}

std::vector<ToldMistake> by_line(std::vector<ToldMistake> told) {
    std::ranges::stable_sort(told, {}, &ToldMistake::line);
    return told;
}

// Whether names that a value uses seem to be used by nothing once it is taken out.
bool may_use_names(const toml::node& node) {
    if (const toml::table* table = node.as_table())
        return std::any_of(table->begin(), table->end(),
                           [](const auto& entry) { return may_use_names(entry.second); });
    if (const toml::array* array = node.as_array())
        return std::any_of(array->begin(), array->end(), may_use_names);
    return node.is_string();
}

const toml::node& node_at(const toml::table& root, const Path& path) {
    const toml::node* node = &root;
    for (const std::string& step : path)
        node = node->is_table() ? node->as_table()->get(step)
                                : node->as_array()->get(std::stoul(step));
    return *node;
}

} // namespace

Mistakes::Mistakes(std::vector<ToldMistake> told)
    : SceneError(text_of(by_line(told)))
    , told_(by_line(std::move(told))) {}

Mistakes joined(const Mistakes& a, const Mistakes& b) {
    std::vector<ToldMistake> told = a.told();
    std::ranges::copy_if(b.told(), std::back_inserter(told), [&](const ToldMistake& mistake) {
        return std::ranges::count(a.told(), mistake) == 0;
    });
    if (told.size() > most_told) told.resize(most_told);
    return Mistakes(std::move(told));
}

Mistakes all_mistakes(toml::table& root, const PlacedError& first,
                      const std::function<void(Rereading)>& read) {
    std::vector<ToldMistake> told;
    std::vector<Path> out;
    bool may_leave_unused = false;
    const auto put_out = [&](const Path& path, bool has_stand_in) {
        may_leave_unused |= is_of_formula(path) || may_use_names(node_at(root, path));
        take_out(root, path, has_stand_in);
        out.push_back(path);
    };
    // Whether there may be more that this one doesn't cause.
    const auto take = [&](const PlacedError& mistake) {
        Path path;
        const bool is_here = find_path(root, mistake.at(), path);
        // The surface is missing: one that stands in lets the rest be read.
        const bool lacks_surface = is_here && path.empty() && !root.contains("surface");
        if (lacks_surface) path = {"surface"};
        const auto is_below = [&](const Path& other) { return begins_with(other, path); };
        if (std::ranges::any_of(out, is_below) && !std::ranges::count(out, path)) {
            // A value that lacks a key that was taken out is taken out as well, and its mistake is
            // not told.
            if (!is_here || path.empty() || decides_all(root, path)) return false;
            put_out(path, false);
            return true;
        }
        Path value = is_here && !lacks_surface ? value_of(root, path) : path;
        const bool is_again = std::ranges::count(out, value) > 0;
        if (!is_again) told.push_back({mistake.line(), mistake.what()});
        if (!is_here || decides_all(root, value) || told.size() == most_told) return false;
        if (is_again && is_of_formula(value)) return false; // the one that stands in is not right
        put_out(value, !is_again);
        return true;
    };
    bool has_more = take(first);
    has_more = has_more && !has_large_arrays(root);
    // Mistakes that are taken out untold are few to one that is told.
    for (std::size_t reading = 0; has_more && reading < 4 * most_told; ++reading) {
        try {
            read(may_leave_unused ? Rereading::without_unused : Rereading::all);
            has_more = false;
        } catch (const PlacedError& mistake) {
            has_more = take(mistake);
        } catch (const SceneError&) { // of no place in the document
            has_more = false;
        }
    }
    return Mistakes(std::move(told));
}

} // namespace isomotion::scene
