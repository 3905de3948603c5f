#include "scene/reading/mistakes.h"

#include <algorithm>
#include <iterator>

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

// What all that follows is read by.
bool decides_all(const Path& path) {
    return !path.empty() && (path[0] == "surface" || path[0] == "arrays");
}

// What decides which keys its section may have: the section goes with it.
bool decides_section(const Path& path) {
    return path == Path{"material", "model"} || path == Path{"camera", "projection"};
}

// The whole value that a place of a mistake is in: "camera.target" of "camera.target.1".
Path value_of(const toml::table& root, const Path& path) {
    const toml::node* node = &root;
    Path value;
    for (const std::string& step : path) {
        const toml::table* table = node->as_table();
        const toml::array* array = node->as_array();
        const bool is_list_of_tables = array && array->is_array_of_tables();
        if (!table && !is_list_of_tables) break;
        value.push_back(step);
        node = table ? table->get(step) : array->get(std::stoul(step));
        if (node->is_table() && node->as_table()->contains("keys")) break;
    }
    return value;
}

// A right value in place of one that others are read by: parameters are named in other values,
// frames are counted, unless their seconds are, and a camera with a position has no orbit.
void put_stand_in(toml::table& table, const Path& path) {
    if (path.size() == 2 && path[0] == "parameters") table.insert(path[1], 1.0);
    if (path == Path{"time", "frames"} && !table.contains("seconds"))
        table.insert("frames", 1'000'000);
    if (path == Path{"camera", "position"}) table.insert("position", toml::array{3, 2, 1});
}

// A right one in place of a table of a list: the others keep their numbers.
toml::table listed_stand_in(const Path& path) {
    if (path[0] == "sections") return toml::table{{"sphere", 0}};
    return toml::table{{"direction", toml::array{0, 0, 1}}};
}

void take_out(toml::table& root, const Path& path, bool has_stand_in) {
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
    if (has_stand_in) put_stand_in(*parent->as_table(), path);
}

struct Told {
    unsigned line = 0;
    std::string message;
};

} // namespace

std::string all_mistakes(toml::table& root, const PlacedError& first,
                         const std::function<void(Rereading)>& read) {
    std::vector<Told> told;
    std::vector<Path> out;
    // Whether there may be more that this one doesn't cause.
    const auto take = [&](const PlacedError& mistake) {
        Path path;
        const bool is_here = find_path(root, mistake.at(), path);
        const auto is_below = [&](const Path& other) { return begins_with(other, path); };
        if (std::ranges::any_of(out, is_below) && !std::ranges::count(out, path)) {
            // What misses a key that was taken out goes as well, untold.
            if (!is_here || path.empty() || decides_all(path)) return false;
            take_out(root, path, false);
            out.push_back(path);
            return true;
        }
        Path value = is_here ? value_of(root, path) : path;
        const bool is_again = std::ranges::count(out, value) > 0;
        if (!is_again) told.push_back({mistake.line(), mistake.what()});
        if (!is_here || value.empty() || decides_all(value) || told.size() == most_told)
            return false;
        if (decides_section(value)) value.pop_back();
        take_out(root, value, !is_again);
        out.push_back(value);
        return true;
    };
    bool has_more = take(first);
    // Tables of elements may be large: they are not read again and again.
    has_more = has_more && !root.contains("arrays");
    while (has_more) {
        try {
            const bool is_value_out = std::ranges::any_of(
                out, [](const Path& path) { return begins_with(path, {"parameters"}); });
            read(is_value_out ? Rereading::without_unused : Rereading::all);
            break;
        } catch (const PlacedError& mistake) {
            has_more = take(mistake);
        } catch (const SceneError&) { // of no place, as values that leave their range at a time
            break;
        }
    }
    std::ranges::stable_sort(told, {}, &Told::line);
    std::vector<std::string> messages;
    std::ranges::transform(told, std::back_inserter(messages), &Told::message);
    return fmt::format("{}", fmt::join(messages, "\n"));
}

} // namespace isomotion::scene
