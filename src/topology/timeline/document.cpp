#include "topology/timeline/document.h"

#include <cmath>
#include <sstream>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "formula/graph/vocabulary.h"

namespace isomotion::topology {
namespace {

using nlohmann::json;

// "[json.exception.parse_error.101] parse error at line 1, column 2: ..." without its label.
std::string reason(const json::exception& error) {
    const std::string text = error.what();
    const std::size_t end = text.find("] ");
    return end == text.npos ? text : text.substr(end + 2);
}

std::string place(const std::string& file, std::size_t line, const std::string& key) {
    const std::string at = line == 0 ? file : fmt::format("{}:{}", file, line);
    return key.empty() ? at : fmt::format("{}: {}", at, key);
}

// From TOML; notes the lines of all nodes.
class Conversion {
public:
    Conversion(const std::string& file, std::map<std::string, std::size_t>& lines)
        : file_(file)
        , lines_(lines) {}

    json of(const toml::node& node, const std::string& key) {
        const std::size_t line = node.source().begin.line;
        if (!key.empty()) lines_[key] = line;
        if (const auto* table = node.as_table()) {
            json object = json::object();
            for (const auto& [name, value] : *table) {
                const std::string inner(name.str());
                object[inner] = of(value, key.empty() ? inner : key + "." + inner);
            }
            return object;
        }
        if (const auto* array = node.as_array()) {
            json list = json::array();
            for (std::size_t k = 0; k < array->size(); ++k)
                list.push_back(of(*array->get(k), fmt::format("{}[{}]", key, k)));
            return list;
        }
        if (const auto text = node.value_exact<std::string>()) return *text;
        if (const auto whole = node.value_exact<std::int64_t>()) return *whole;
        if (const auto number = node.value_exact<double>()) return *number;
        if (const auto boolean = node.value_exact<bool>()) return *boolean;
        throw DocumentError(fmt::format("{}: must be a number, a text, a list or a table, no date",
                                        place(file_, line, key)));
    }

private:
    const std::string& file_;
    std::map<std::string, std::size_t>& lines_;
};

} // namespace

json parse_json(std::string_view text, const std::string& file) {
    // The library keeps the last of equal keys, by which claims would be lost without a word.
    std::vector<std::set<std::string>> keys;
    const auto watch = [&](int, json::parse_event_t event, json& parsed) {
        if (event == json::parse_event_t::object_start) keys.emplace_back();
        if (event == json::parse_event_t::object_end) keys.pop_back();
        if (event == json::parse_event_t::key) {
            const auto& name = parsed.get_ref<const std::string&>();
            if (!keys.back().insert(name).second) {
                throw DocumentError(
                    fmt::format("{}: {}: is given twice; keep one of them", file, name));
            }
        }
        return true;
    };
    try {
        return json::parse(text.begin(), text.end(), watch);
    } catch (const json::exception& error) {
        throw DocumentError(fmt::format("{}: not valid JSON: {}", file, reason(error)));
    }
}

Document parse_toml(std::string_view text, const std::string& file) {
    try {
        Document document{json()};
        document.value = Conversion(file, document.lines).of(toml::parse(text), "");
        return document;
    } catch (const toml::parse_error& error) {
        throw DocumentError(fmt::format("{}:{}: not valid TOML: {}", file,
                                        error.source().begin.line, error.description()));
    }
}

void JsonValue::fail(const std::string& message) const {
    std::size_t line = 0; // not known
    if (lines_) {
        if (const auto at = lines_->find(key_); at != lines_->end()) line = at->second;
    }
    throw DocumentError(fmt::format("{}: {}", place(*file_, line, key_), message));
}

JsonValue JsonValue::inner(const json& value, std::string key) const {
    JsonValue node(value, *file_, std::move(key));
    node.lines_ = lines_;
    return node;
}

std::string JsonValue::text() const {
    if (!value_->is_string()) fail("must be a text");
    return value_->get<std::string>();
}

double JsonValue::number() const {
    if (!value_->is_number()) fail("must be a number");
    const double number = value_->get<double>();
    if (!std::isfinite(number)) fail("must be finite");
    return number;
}

int JsonValue::integer(int least, int most) const {
    const auto complain = [&] {
        fail(fmt::format("must be a whole number from {} to {}", least, most));
    };
    if (!value_->is_number_integer()) complain();
    if (value_->is_number_unsigned() && value_->get<std::uint64_t>() > std::uint64_t(INT32_MAX)) {
        complain();
    }
    const auto number = value_->get<std::int64_t>();
    if (number < least || number > most) complain();
    return int(number);
}

bool JsonValue::boolean() const {
    if (!value_->is_boolean()) fail("must be true or false");
    return value_->get<bool>();
}

std::vector<JsonValue> JsonValue::list() const {
    if (!value_->is_array()) fail("must be a list, in [ ]");
    std::vector<JsonValue> items;
    for (std::size_t k = 0; k < value_->size(); ++k) {
        items.push_back(inner((*value_)[k], fmt::format("{}[{}]", key_, k)));
    }
    return items;
}

std::vector<JsonValue> JsonValue::list(std::size_t size) const {
    if (!value_->is_array() || value_->size() != size) {
        fail(fmt::format("must be a list of {}", size));
    }
    return list();
}

JsonObject JsonValue::object() const { return JsonObject(*this); }

formula::Interval JsonValue::interval() const {
    if (value_->is_number()) return number();
    if (!value_->is_array() || value_->size() != 2) {
        fail("must be [lo, hi], null in place of an end that there is not");
    }
    const std::vector<JsonValue> ends = list();
    const formula::Interval interval{ends[0].is_null() ? -formula::infinity : ends[0].number(),
                                     ends[1].is_null() ? formula::infinity : ends[1].number()};
    if (is_empty(interval)) fail("must be [lo, hi] with lo not above hi");
    return interval;
}

JsonObject::JsonObject(const JsonValue& node)
    : node_(node) {
    if (!node.value_->is_object()) node.fail("must be an object, in { }");
}

std::optional<JsonValue> JsonObject::find(const std::string& name) {
    known_.insert(name);
    const auto found = node_.value_->find(name);
    if (found == node_.value_->end()) return std::nullopt;
    return node_.inner(*found, node_.key_.empty() ? name : node_.key_ + "." + name);
}

JsonValue JsonObject::at(const std::string& name) {
    const auto found = find(name);
    if (!found) node_.fail(fmt::format("has no key '{}', which it needs", name));
    return *found;
}

std::vector<JsonValue> JsonObject::all() {
    std::vector<JsonValue> values;
    for (const auto& item : node_.value_->items()) values.push_back(*find(item.key()));
    return values;
}

std::string JsonObject::key_of(const JsonValue& node) const {
    return node.key_.substr(node_.key_.empty() ? 0 : node_.key_.size() + 1);
}

void JsonObject::refuse_rest() const {
    for (const auto& item : node_.value_->items()) {
        if (known_.contains(item.key())) continue;
        const std::vector<std::string> candidates(known_.begin(), known_.end());
        const std::string nearest = formula::nearest_name(item.key(), candidates);
        const std::string hint = nearest.empty()
                                     ? fmt::format("known: {}", fmt::join(candidates, ", "))
                                     : fmt::format("did you mean '{}'?", nearest);
        node_.fail(fmt::format("unknown key '{}'; {}", item.key(), hint));
    }
}

} // namespace isomotion::topology
