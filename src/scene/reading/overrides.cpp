#include "scene/reading/overrides.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "scene/error.h"
#include "scene/reading/surface_list.h"
#include "scene/renamed_keys.h"

namespace isomotion::scene {
namespace {

// The other name of the key `part` in the table called `section`, if the table has it under that.
std::optional<std::string> other_name(const toml::table& table, std::string_view section,
                                      const std::string& part) {
    const RenamedKey* key = renamed_key(section, part);
    if (!key || table.contains(part)) return std::nullopt;
    const std::string_view other = part == key->now ? key->before : key->now;
    return table.contains(other) ? std::optional(std::string(other)) : std::nullopt;
}

// Keys of a table of which a scene gives one or the other: what --set gives takes the place of
// what the file gave. Two that are both set are a mistake, told when the scene is read.
void take_out_others(toml::table& table, std::string_view section, std::string_view key) {
    using Keys = std::vector<std::string_view>;
    struct Choice {
        std::string_view section;
        Keys one, other;
    };
    static const std::vector<Choice> choices{
        {"time", {"frames"}, {"seconds"}},
        {"surface.bounds", {"sphere", "centre"}, {"box"}},
        {"camera", {"position"}, {"azimuth", "elevation", "distance"}}};
    for (const Choice& choice : choices) {
        if (choice.section != section) continue;
        for (const auto& [given, others] :
             {std::pair(choice.one, choice.other), std::pair(choice.other, choice.one)}) {
            if (std::ranges::count(given, key) == 0) continue;
            for (const std::string_view other : others) {
                const toml::node* node = table.get(other);
                if (node && node->source().path) table.erase(other);
            }
        }
    }
}

// The section of a scene of one surface that a path of the command line leads to: what a listed
// surface has beside its own sections is that scene's [surface].
std::string section_of(std::string_view path) {
    constexpr std::string_view list = "surfaces.";
    if (!path.starts_with(list)) return std::string(path);
    path.remove_prefix(std::min(path.find('.', list.size()), path.size()));
    if (path.empty()) return "surface";
    path.remove_prefix(1);
    const std::string_view section = path.substr(0, path.find('.'));
    const bool is_own = std::ranges::find(own_sections, section) != std::end(own_sections);
    return is_own ? std::string(path) : fmt::format("surface.{}", path);
}

// "lights[0]": a table of a list, as messages call it.
toml::table* listed_table(toml::table& table, const std::string& part) {
    const std::size_t open = part.find('[');
    if (open == part.npos || !part.ends_with(']')) return nullptr;
    std::size_t index = 0;
    const char* end = part.data() + part.size() - 1;
    const auto [parsed, error] = std::from_chars(part.data() + open + 1, end, index);
    toml::array* list = table[part.substr(0, open)].as_array();
    if (error != std::errc{} || parsed != end || !list || index >= list->size()) return nullptr;
    return list->get(index)->as_table();
}

// What is set whole although only its keys can be: a list of tables, or a section.
void refuse_whole(const toml::table& document, const std::string& setting, const std::string& path,
                  const toml::node& value) {
    if (path.find('.') != path.npos || document.at_path("parameters." + path)) return;
    const bool is_list = path == "lights" || path == "sections" || path == "surfaces";
    if (is_list) {
        throw SceneError(fmt::format("--set {}: '{}' is a list of the scene file; set keys of its "
                                     "tables: {}.key=value",
                                     setting, path,
                                     path == "surfaces" ? "surfaces.NAME" : path + "[0]"));
    }
    const toml::node* section = document.get(path);
    if (section && section->is_table() && value.is_table()) {
        throw SceneError(
            fmt::format("--set {0}: '{1}' is a table; set its keys: {1}.key=value", setting, path));
    }
}

} // namespace

void override_key(toml::table& document, const std::string& setting) {
    const std::size_t equals = setting.find('=');
    if (equals == setting.npos || equals == 0 || equals + 1 == setting.size()) {
        throw SceneError(fmt::format("--set {}: write name=value", setting));
    }
    std::string path = setting.substr(0, equals);
    const std::string value = setting.substr(equals + 1);
    toml::table parsed;
    try { // as TOML, else as an expression or a name: m=2.5, m="2+t", m=2+t, camera.up=[0,1,0]
        parsed = toml::parse("value = " + value);
        if (parsed.size() > 1) throw SceneError(fmt::format("--set {}: write one value", setting));
    } catch (const toml::parse_error&) {
        parsed.insert("value", value);
    }
    // A value may be a whole camera instead of the scene's, or another look.
    const bool is_camera = path == "camera" && parsed.get("value")->is_table();
    const bool is_parameter = path.find('.') == path.npos;
    if (!is_camera && is_parameter && put_own_parameter(document, path, *parsed.get("value")))
        return;
    const bool is_look =
        path == "look" && parsed.get("value")->is_string() && !document.at_path("parameters.look");
    if (!is_camera && !is_look) refuse_whole(document, setting, path, *parsed.get("value"));
    if (!is_camera && !is_look && path.find('.') == path.npos) path = "parameters." + path;
    // parse() without a path leaves lines but no file; documents tell by that it was the command
    // line.
    toml::table* table = &document;
    const auto section_above = [&](std::size_t begin) {
        return section_of(std::string_view(path).substr(0, begin == 0 ? 0 : begin - 1));
    };
    std::size_t begin = 0;
    for (std::size_t dot = path.find('.'); dot != path.npos; dot = path.find('.', begin)) {
        std::string part = path.substr(begin, dot - begin);
        if (const auto other = other_name(*table, section_above(begin), part)) part = *other;
        toml::node* next = listed_table(*table, part);
        if (!next) next = table->get(part);
        if (!next && part.find('[') != part.npos)
            throw SceneError(fmt::format("--set {}: the scene lists no {}", setting, part));
        if (!next) {
            table->insert(part, toml::table{});
            next = table->get(part);
        }
        if (begin == 0 && part == "surfaces") { // surfaces.NAME.transform.scale=2
            begin = dot + 1;
            dot = path.find('.', begin);
            const std::string name = path.substr(begin, dot - begin);
            next = dot == path.npos ? nullptr : listed_surface(document, name);
            if (!next) {
                throw SceneError(
                    fmt::format("--set {}: write surfaces.NAME.key=value, with the name "
                                "or the number of a surface of the list",
                                setting));
            }
        }
        if (!next->is_table()) {
            const bool is_list = next->is_array_of_tables();
            throw SceneError(fmt::format(
                "--set {}: '{}' is {}", setting, part,
                is_list ? fmt::format("a list: write {}[0] for its first", part) : "not a table"));
        }
        table = next->as_table();
        begin = dot + 1;
    }
    const std::string last = path.substr(begin);
    take_out_others(*table, section_above(begin), last);
    if (const auto other = other_name(*table, section_above(begin), last)) table->erase(*other);
    table->insert_or_assign(last, *parsed.get("value"));
}

} // namespace isomotion::scene
