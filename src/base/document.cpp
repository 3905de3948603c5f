#include "base/document.h"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "base/input_error.h"
#include "base/nearest_name.h"
#include "base/toml.h"

namespace isomotion::base {
namespace {

using Json = nlohmann::ordered_json; // keys as they are written

// "[json.exception.parse_error.101] parse error at line 1, column 2: ..." without its label.
std::string reason(const Json::exception& error) {
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

    Json of(const toml::node& node, const std::string& key) {
        const std::size_t line = node.source().begin.line;
        if (!key.empty()) lines_[key] = line;
        if (const auto* table = node.as_table()) {
            Json object = Json::object();
            for (const auto& [name, value] : *table) {
                const std::string inner(name.str());
                object[inner] = of(value, key.empty() ? inner : key + "." + inner);
            }
            return object;
        }
        if (const auto* array = node.as_array()) {
            Json list = Json::array();
            for (std::size_t k = 0; k < array->size(); ++k)
                list.push_back(of(*array->get(k), fmt::format("{}[{}]", key, k)));
            return list;
        }
        if (const auto text = node.value_exact<std::string>()) return *text;
        if (const auto whole = node.value_exact<std::int64_t>()) return *whole;
        if (const auto number = node.value_exact<double>()) return *number;
        if (const auto boolean = node.value_exact<bool>()) return *boolean;
        throw InputError(fmt::format("{}: must be a number, a text, a list or a table, no date",
                                     place(file_, line, key)));
    }

private:
    const std::string& file_;
    std::map<std::string, std::size_t>& lines_;
};

// The library keeps the last of equal keys, by which claims would be lost without a word.
Json parse_json(std::string_view text, const std::string& file) {
    std::vector<std::set<std::string>> keys;
    const auto watch = [&](int, Json::parse_event_t event, Json& parsed) {
        if (event == Json::parse_event_t::object_start) keys.emplace_back();
        if (event == Json::parse_event_t::object_end) keys.pop_back();
        if (event == Json::parse_event_t::key) {
            const auto& name = parsed.get_ref<const std::string&>();
            if (!keys.back().insert(name).second) {
                throw InputError(
                    fmt::format("{}: {}: is given twice; keep one of them", file, name));
            }
        }
        return true;
    };
    try {
        return Json::parse(text.begin(), text.end(), watch);
    } catch (const Json::exception& error) {
        throw InputError(fmt::format("{}: not valid JSON: {}", file, reason(error)));
    }
}

} // namespace

Document::Document(std::string file)
    : file_(std::move(file))
    , value_(std::make_unique<Json>()) {}
Document::Document(Document&&) noexcept = default;
Document::~Document() = default;

Document Document::from_json(std::string_view text, std::string file) {
    Document document(std::move(file));
    *document.value_ = parse_json(text, document.file_);
    return document;
}

Document Document::from_toml(std::string_view text, std::string file) {
    Document document(std::move(file));
    const toml::table table = parse_toml(text, document.file_);
    *document.value_ = Conversion(document.file_, document.lines_).of(table, "");
    return document;
}

DocumentTable Document::table() const { return DocumentTable(DocumentNode(*this, *value_, "")); }

void DocumentNode::fail(const std::string& message) const {
    const auto at = document_->lines_.find(key_);
    const std::size_t line = at == document_->lines_.end() ? 0 : at->second;
    throw InputError(fmt::format("{}: {}", place(document_->file_, line, key_), message));
}

std::string DocumentNode::text() const {
    if (!value_->is_string()) fail("must be a text");
    return value_->get<std::string>();
}

double DocumentNode::number() const {
    if (!value_->is_number()) fail("must be a number");
    const double number = value_->get<double>();
    if (!std::isfinite(number)) fail("must be finite");
    return number;
}

std::int64_t DocumentNode::whole() const {
    const bool fits =
        value_->is_number_integer() &&
        (!value_->is_number_unsigned() || value_->get<std::uint64_t>() <= std::uint64_t(INT64_MAX));
    if (!fits) fail("must be a whole number");
    return value_->get<std::int64_t>();
}

int DocumentNode::integer(int least, int most) const {
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

bool DocumentNode::boolean() const {
    if (!value_->is_boolean()) fail("must be true or false");
    return value_->get<bool>();
}

std::vector<DocumentNode> DocumentNode::list() const {
    if (!value_->is_array()) fail("must be a list, in [ ]");
    std::vector<DocumentNode> items;
    for (std::size_t k = 0; k < value_->size(); ++k) {
        items.push_back({*document_, (*value_)[k], fmt::format("{}[{}]", key_, k)});
    }
    return items;
}

std::vector<DocumentNode> DocumentNode::list(std::size_t size) const {
    if (!value_->is_array() || value_->size() != size) {
        fail(fmt::format("must be a list of {}", size));
    }
    return list();
}

DocumentTable DocumentNode::table() const { return DocumentTable(*this); }

bool DocumentNode::is_null() const { return value_->is_null(); }
bool DocumentNode::is_number() const { return value_->is_number(); }
bool DocumentNode::is_table() const { return value_->is_object(); }

DocumentTable::DocumentTable(const DocumentNode& node)
    : node_(node) {
    if (!node.value_->is_object()) node.fail("must be an object, in { }");
}

std::optional<DocumentNode> DocumentTable::find(const std::string& name) {
    known_.insert(name);
    const auto found = node_.value_->find(name);
    if (found == node_.value_->end()) return std::nullopt;
    return DocumentNode(*node_.document_, *found,
                        node_.key_.empty() ? name : node_.key_ + "." + name);
}

DocumentNode DocumentTable::at(const std::string& name) {
    const auto found = find(name);
    if (!found) node_.fail(fmt::format("has no key '{}', which it needs", name));
    return *found;
}

std::vector<DocumentNode> DocumentTable::all() {
    std::vector<DocumentNode> values;
    for (const auto& item : node_.value_->items()) values.push_back(*find(item.key()));
    return values;
}

std::string DocumentTable::key_of(const DocumentNode& node) const {
    return node.key_.substr(node_.key_.empty() ? 0 : node_.key_.size() + 1);
}

void DocumentTable::refuse_rest() const {
    for (const auto& item : node_.value_->items()) {
        if (known_.contains(item.key())) continue;
        const std::vector<std::string> candidates(known_.begin(), known_.end());
        const std::string nearest = nearest_name(item.key(), candidates);
        const std::string hint = nearest.empty()
                                     ? fmt::format("known: {}", fmt::join(candidates, ", "))
                                     : fmt::format("did you mean '{}'?", nearest);
        node_.fail(fmt::format("unknown key '{}'; {}", item.key(), hint));
    }
}

} // namespace isomotion::base
