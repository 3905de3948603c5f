#include "scene/reading/document.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/file_text.h"
#include "base/nearest_name.h"
#include "base/printable_message.h"
#include "base/toml.h"
#include "formula/graph/vocabulary.h"
#include "scene/limits.h"
#include "scene/renamed_keys.h"

namespace isomotion::scene {
namespace {

animation::Ease read_ease(const toml::table& table, const std::string& key) {
    const toml::node* node = table.get("ease");
    if (!node) return animation::Ease::linear;
    const auto text = node->value<std::string>();
    for (std::size_t k = 0; text && k < std::size(animation::ease_names); ++k) {
        if (*text == animation::ease_names[k]) return animation::Ease(k);
    }
    fail(*node, key + ".ease",
         fmt::format("must be one of {}", fmt::join(animation::ease_names, ", ")));
}

// The list of `keys`, each [time, value]; `add` reads one value.
template<class Add>
animation::Ease read_keys(const toml::table& table, const std::string& key, Add&& add) {
    for (const auto& [name, node] : table) {
        if (name != "keys" && name != "ease") {
            fail(node, key + "." + std::string(name.str()),
                 "unknown key; keyframes are { keys = [[t, value], ...], ease = \"linear\" }");
        }
    }
    const toml::node* node = table.get("keys");
    const toml::array* list = node ? node->as_array() : nullptr;
    if (!list || list->empty()) {
        fail(table, key, "needs keys = [[t, value], ...], at least one");
    }
    if (list->size() > std::size_t(limits::keys)) {
        fail(*list, key,
             fmt::format("has {} keys; at most {} are possible", list->size(), limits::keys));
    }
    double before = 0;
    for (std::size_t k = 0; k < list->size(); ++k) {
        const toml::array* pair = list->get(k)->as_array();
        const std::string name = fmt::format("{}.keys[{}]", key, k);
        if (!pair || pair->size() != 2) fail(*list->get(k), name, "must be [time, value]");
        const double time = read_finite(*pair->get(0), name);
        if (k > 0 && time <= before) {
            fail(*pair, name, fmt::format("times must ascend: {} comes after {}", time, before));
        }
        before = time;
        add(time, *pair->get(1), name);
    }
    return read_ease(table, key);
}

} // namespace

toml::table read_document(const std::filesystem::path& file) {
    return parse_document(base::file_text(file, limits::scene_bytes), file);
}

toml::table parse_document(std::string_view text, const std::filesystem::path& file) {
    return base::parse_toml(text, file.string());
}

std::string position(const toml::node& node) {
    const toml::source_region& region = node.source();
    if (!region.path || region.begin.line == 0) return "--set";
    return fmt::format("{}:{}", *region.path, region.begin.line);
}

void fail(const toml::node& at, const std::string& key, const std::string& message) {
    throw PlacedError(at, fmt::format("{}: {}: {}", position(at), base::shortened(key), message));
}

double read_finite(const toml::node& node, const std::string& key) {
    const auto value = node.is_number() ? node.value<double>() : std::nullopt;
    if (!value) fail(node, key, "must be a number");
    if (!std::isfinite(*value)) fail(node, key, "must be finite");
    return *value;
}

animation::TrackSource read_track(const toml::node& node, const std::string& key) {
    if (node.is_number()) return read_finite(node, key);
    if (const auto text = node.value<std::string>()) return animation::Expression{*text};
    if (const toml::table* table = node.as_table()) {
        animation::Keys keys;
        keys.ease = read_keys(*table, key, [&](double t, const toml::node& v, const auto& name) {
            keys.keys.push_back({t, read_finite(v, name)});
        });
        return keys;
    }
    fail(node, key,
         "must be a number, an expression in t (\"2 + sin(t)\"), or "
         "{ keys = [[t, value], ...], ease = \"smooth\" }");
}

std::array<animation::TrackSource, 3> read_vector(const toml::node& node, const std::string& key) {
    if (const toml::array* array = node.as_array()) {
        if (array->size() != 3) fail(node, key, "must have three components: [x, y, z]");
        std::array<animation::TrackSource, 3> tracks;
        for (std::size_t k = 0; k < 3; ++k) {
            tracks[k] = read_track(*array->get(k), fmt::format("{}.{}", key, "xyz"[k]));
        }
        return tracks;
    }
    if (const toml::table* table = node.as_table()) {
        std::array<animation::Keys, 3> keys;
        const auto ease =
            read_keys(*table, key, [&](double t, const toml::node& v, const auto& at) {
                const toml::array* triple = v.as_array();
                if (!triple || triple->size() != 3) fail(v, at, "must be [time, [x, y, z]]");
                for (std::size_t k = 0; k < 3; ++k) {
                    keys[k].keys.push_back({t, read_finite(*triple->get(k), at)});
                }
            });
        for (auto& track : keys) track.ease = ease;
        return std::array<animation::TrackSource, 3>{keys[0], keys[1], keys[2]};
    }
    const bool is_color = key.ends_with("color");
    fail(node, key,
         is_color ? "must be [r, g, b], linear ([1, 0, 0] is red), or "
                    "{ keys = [[t, [r, g, b]], ...] }"
                  : "must be [x, y, z] or { keys = [[t, [x, y, z]], ...] }");
}

// The name under which a table has the key: the former one, where it has it under that alone.
std::string Section::written(const Layer& layer, const std::string& name) const {
    const RenamedKey* key = renamed_key(name_, name);
    const bool is_former = key && name == key->now && !layer.table->contains(name);
    return is_former && layer.table->contains(key->before) ? std::string(key->before) : name;
}

const Section::Layer* Section::layer_with(const std::string& name) const {
    const auto found = std::ranges::find_if(
        layers_, [&](const Layer& layer) { return layer.table->contains(written(layer, name)); });
    return found == layers_.end() ? nullptr : &*found;
}

std::vector<std::string> Section::names() const {
    std::set<std::string> names;
    for (const Layer& layer : layers_) {
        for (const auto& [name, node] : *layer.table) names.emplace(name.str());
    }
    return {names.begin(), names.end()};
}

std::string Section::dotted(const std::string& given) const {
    const Layer* found = layer_with(given);
    const Layer& layer = found ? *found : layers_.front();
    const std::string name = written(layer, given);
    const bool bare = std::ranges::all_of(name, [](unsigned char c) {
        return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') ||
               c == '_' || c == '-' || c >= 0x80;
    });
    // Written as in TOML, so that a line end in a key does not break the message.
    const std::string key = bare ? name : fmt::format("{:?}", name);
    return layer.key.empty() ? key : layer.key + "." + key;
}

std::string Section::full_name(const std::string& name) const {
    return name_.empty() ? name : name_ + "." + name;
}

const toml::node* Section::find(const std::string& name) {
    known_.insert(name);
    const Layer* layer = layer_with(name);
    if (!layer) return nullptr;
    const RenamedKey* key = renamed_key(name_, name);
    const toml::node* former = key && name == key->now ? layer->table->get(key->before) : nullptr;
    if (former && layer->table->contains(name) && !is_wrong(name)) {
        attempt(name, [&] {
            fail(*former, fmt::format("{}.{}", layer->key, key->before),
                 fmt::format("is the former name of {}.{}, which is given too; keep one",
                             layer->key, name));
        });
    }
    return layer->table->get(written(*layer, name));
}

void Section::tell(const std::string& message) {
    mistakes_->attempt([&] { fail(table(), key(), message); });
}

void Section::tell(const std::string& name, const std::string& message) {
    attempt(name, [&] {
        const Layer& layer = *layer_with(name);
        fail(*layer.table->get(written(layer, name)), dotted(name), message);
    });
}

void Section::tell_missing(const std::string& name, const std::string& what) {
    attempt(name, [&] { fail(table(), dotted(name), fmt::format("is missing; give {}", what)); });
}

template<class Read>
auto Section::value(const std::string& name, Read&& read)
    -> std::optional<decltype(read(std::declval<const toml::node&>()))> {
    std::optional<decltype(read(std::declval<const toml::node&>()))> value;
    if (const toml::node* node = find(name)) attempt(name, [&] { value = read(*node); });
    return value;
}

std::optional<Section> Section::section_of(const std::string& name, bool merges) {
    if (!find(name)) return std::nullopt;
    std::vector<Layer> layers;
    for (const Layer& layer : layers_) {
        const std::string key = written(layer, name);
        const toml::node* node = layer.table->get(key);
        if (!node || (!merges && !layers.empty())) continue;
        const std::string its_name = layer.key.empty() ? key : layer.key + "." + key;
        if (node->is_table()) {
            layers.push_back({node->as_table(), its_name});
        } else if (!is_wrong(name)) {
            attempt(name, [&] {
                fail(*node, its_name,
                     fmt::format("must be a table: [{}]", its_name.starts_with("surfaces.")
                                                              ? "surfaces." + name
                                                              : its_name));
            });
        }
    }
    if (layers.empty()) return std::nullopt;
    return Section(std::move(layers), full_name(name), *mistakes_);
}

std::optional<Section> Section::section(const std::string& name) {
    return section_of(name, name_.empty());
}

std::optional<Section> Section::merged_section(const std::string& name) {
    return section_of(name, true);
}

std::vector<Section> Section::list(const std::string& name, const char* one, int most) {
    std::vector<Section> sections;
    const toml::node* node = find(name);
    if (!node) return sections;
    const toml::array* list = node->as_array();
    if (!list || list->empty() || !list->is_array_of_tables()) {
        tell(name, fmt::format("must be written as [[{}]], one such table a {}", name, one));
    } else if (list->size() > std::size_t(most)) {
        tell(name, fmt::format("at most {}", most));
    } else {
        for (const toml::node& table : *list) {
            sections.emplace_back(*table.as_table(),
                                  fmt::format("{}[{}]", dotted(name), sections.size()), *mistakes_);
        }
    }
    return sections;
}

std::optional<std::string> Section::text(const std::string& name) {
    return value(name, [&](const toml::node& node) {
        auto text = node.value_exact<std::string>();
        if (!text) fail(node, dotted(name), "must be a text in quotes");
        return *std::move(text);
    });
}

std::optional<double> Section::number(const std::string& name, double least, double most) {
    return value(name, [&](const toml::node& node) {
        const double number = read_finite(node, dotted(name));
        if (number < least || number > most) {
            fail(node, dotted(name),
                 fmt::format("must be from {} to {}, not {}", least, most, number));
        }
        return number;
    });
}

std::optional<int> Section::integer(const std::string& name, int least, int most) {
    return value(name, [&](const toml::node& node) {
        const auto number = node.value_exact<std::int64_t>();
        if (!number) fail(node, dotted(name), "must be an integer");
        if (*number < least || *number > most) {
            fail(node, dotted(name),
                 fmt::format("must be from {} to {}, not {}", least, most, *number));
        }
        return int(*number);
    });
}

std::optional<bool> Section::boolean(const std::string& name) {
    return value(name, [&](const toml::node& node) {
        const auto truth = node.value_exact<bool>();
        if (!truth) fail(node, dotted(name), "must be true or false");
        return *truth;
    });
}

std::optional<animation::TrackSource> Section::track(const std::string& name) {
    return value(name, [&](const toml::node& node) { return read_track(node, dotted(name)); });
}

std::optional<std::array<animation::TrackSource, 3>> Section::vector(const std::string& name) {
    return value(name, [&](const toml::node& node) { return read_vector(node, dotted(name)); });
}

bool Section::refuse_rest() {
    // The present name of a key, for what somebody may have meant.
    const auto present = [&](const std::string& name) {
        const RenamedKey* key = renamed_key(name_, name);
        return key ? std::string(key->now) : name;
    };
    const std::vector<std::string> known(known_.begin(), known_.end());
    std::vector<std::string> meant = known;
    for (const std::string& name : known) {
        if (const RenamedKey* key = renamed_key(name_, name)) meant.emplace_back(key->before);
    }
    bool is_all_known = true;
    for (const std::string& key : names()) {
        if (known_.count(present(key))) continue;
        is_all_known = false;
        if (mistakes_->is_full()) break;
        const std::string near = base::nearest_name(key, meant);
        tell(key, near.empty() ? fmt::format("unknown key; known here: {}", fmt::join(known, ", "))
                               : fmt::format("unknown key; did you mean '{}'?", present(near)));
    }
    return is_all_known;
}

} // namespace isomotion::scene
