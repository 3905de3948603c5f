#include "base/document.h"

#include <cmath>
#include <iterator>

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

// A text's characters, with the line of the last one that was read: parsers read one beyond a
// number.
struct LineCount {
    std::size_t line = 1;
    bool has_ended = false;
};
class CountedCharacter {
public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    CountedCharacter(const char* at, LineCount& count)
        : at_(at)
        , count_(&count) {}
    reference operator*() const { return *at_; }
    CountedCharacter& operator++() {
        count_->line += count_->has_ended;
        count_->has_ended = *at_ == '\n';
        ++at_;
        return *this;
    }
    bool operator==(const CountedCharacter& other) const { return at_ == other.at_; }

private:
    const char* at_;
    LineCount* count_;
};

// What a parser of JSON has come to: the names of all that it is in, and of the last value that it
// came to. Whole keys are put together when they are asked for, as text may be nested deeply.
class JsonPlace {
public:
    // Whether a value begins here.
    bool follow(Json::parse_event_t event, const Json& parsed) {
        switch (event) {
        case Json::parse_event_t::key:
            name_ = parsed.get<std::string>();
            is_given_twice_ = !levels_.back().names.insert(name_).second;
            if (levels_.back().length > 0) name_.insert(0, 1, '.');
            return true;
        case Json::parse_event_t::object_start:
        case Json::parse_event_t::array_start: {
            const bool is_new = begin_item();
            const bool is_list = event == Json::parse_event_t::array_start;
            levels_.push_back({name_, length(), is_list, 0, {}});
            name_.clear();
            return is_new;
        }
        case Json::parse_event_t::object_end:
        case Json::parse_event_t::array_end:
            levels_.pop_back();
            return false;
        case Json::parse_event_t::value:
            return begin_item();
        }
        return false;
    }
    bool is_given_twice() const { return is_given_twice_; }
    std::size_t length() const { // of the key
        return (levels_.empty() ? 0 : levels_.back().length) + name_.size();
    }
    std::string key() const {
        std::string key;
        for (const Level& level : levels_) key += level.name;
        return key + name_;
    }

private:
    struct Level {
        std::string name; // in the level around: "radius", ".radius", "[3]"
        std::size_t length = 0;
        bool is_list = false;
        std::size_t items = 0;
        std::set<std::string> names;
    };

    bool begin_item() {
        if (levels_.empty() || !levels_.back().is_list) return false;
        name_ = fmt::format("[{}]", levels_.back().items++);
        return true;
    }

    std::vector<Level> levels_;
    std::string name_;
    bool is_given_twice_ = false;
};

// The library keeps the last of equal keys, by which claims would be lost without a word.
Json parse_json(std::string_view text, const std::string& file) {
    LineCount count;
    JsonPlace here;
    const auto watch = [&](int, Json::parse_event_t event, Json& parsed) {
        here.follow(event, parsed);
        if (here.is_given_twice()) {
            throw InputError(fmt::format("{}: is given twice; keep one of them",
                                         place(file, count.line, here.key())));
        }
        return true;
    };
    try {
        return Json::parse(CountedCharacter(text.data(), count),
                           CountedCharacter(text.data() + text.size(), count), watch);
    } catch (const Json::exception& error) {
        throw InputError(fmt::format("{}: not valid JSON: {}", file, reason(error)));
    }
}

// Of valid JSON.
std::size_t json_line(std::string_view text, const std::string& key) {
    LineCount count;
    JsonPlace here;
    std::size_t line = 0;
    const auto watch = [&](int, Json::parse_event_t event, Json& parsed) {
        const bool begins = here.follow(event, parsed);
        const bool may_be = line == 0 && begins && here.length() == key.size();
        if (may_be && here.key() == key) line = count.line;
        return true;
    };
    [[maybe_unused]] const Json whole =
        Json::parse(CountedCharacter(text.data(), count),
                    CountedCharacter(text.data() + text.size(), count), watch);
    return line;
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
    document.json_ = text;
    return document;
}

Document Document::from_toml(std::string_view text, std::string file) {
    Document document(std::move(file));
    const toml::table table = parse_toml(text, document.file_);
    *document.value_ = Conversion(document.file_, document.lines_).of(table, "");
    return document;
}

DocumentTable Document::table() const { return DocumentTable(DocumentNode(*this, *value_, "")); }

std::size_t Document::line_of(const std::string& key) const {
    if (key.empty()) return 0;
    if (!json_.empty()) return json_line(json_, key);
    const auto at = lines_.find(key);
    return at == lines_.end() ? 0 : at->second;
}

void DocumentNode::fail(const std::string& message) const {
    throw InputError(printable_line(
        fmt::format("{}: {}", place(document_->file_, document_->line_of(key_), key_), message)));
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
bool DocumentNode::is_list() const { return value_->is_array(); }
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
