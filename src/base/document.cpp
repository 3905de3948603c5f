#include "base/document.h"

#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "base/input_error.h"
#include "base/nearest_name.h"
#include "base/printable.h"
#include "base/printable_message.h"
#include "base/toml.h"

namespace isomotion::base {
namespace {

using Json = nlohmann::ordered_json; // keys as they are written

// "[json.exception.parse_error.101] parse error at line 1, column 2: ..." without its label.
std::string reason(const nlohmann::detail::exception& error) {
    const std::string text = error.what();
    const std::size_t end = text.find("] ");
    return end == text.npos ? text : text.substr(end + 2);
}

// No name of a file or a key begins a line.
std::string place(const std::string& file, std::size_t line, const std::string& key) {
    const std::string at = line == 0 ? file : fmt::format("{}:{}", file, line);
    return printable_line(key.empty() ? at : fmt::format("{}: {}", at, shortened(key)));
}

// Converts TOML, and notes the lines of all nodes.
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
            auto& members = object.get_ref<Json::object_t&>(); // their names are distinct
            members.reserve(table->size());
            for (const auto& [name, value] : *table) {
                const std::string inner(name.str());
                members.emplace_back(inner, of(value, key.empty() ? inner : key + "." + inner));
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

// How deep objects and lists of JSON may lie in one another.
constexpr std::size_t json_nesting = 64;

// Makes the document of what a parser of JSON comes to, in a time that grows as the text does, and
// looks for the line of a key in it. Whole keys are put together when they are asked for.
//
// The library's own readers go over the keys of an object for each that is added, and keep the last
// of equal keys, by which claims would be lost without a word.
class JsonReading : public Json::json_sax_t {
public:
    // A document in which the line of the key `wanted` is looked up is known to be valid.
    explicit JsonReading(std::string_view text, const std::string& file, std::string wanted = {})
        : file_(file)
        , wanted_(std::move(wanted)) {
        Json::sax_parse(CountedCharacter(text.data(), count_),
                        CountedCharacter(text.data() + text.size(), count_), this);
    }
    Json take() && { return std::move(whole_); }
    std::size_t wanted_line() const { return line_; }

    bool null() override { return scalar(nullptr); }
    bool boolean(bool value) override { return scalar(value); }
    bool number_integer(std::int64_t value) override { return scalar(value); }
    bool number_unsigned(std::uint64_t value) override { return scalar(value); }
    bool number_float(double value, const std::string&) override { return scalar(value); }
    bool string(std::string& value) override { return scalar(std::move(value)); }
    bool binary(Json::binary_t&) override { return false; } // there is none in texts
    bool start_object(std::size_t) override { return open(false); }
    bool start_array(std::size_t) override { return open(true); }
    bool key(std::string& name) override {
        name_ = name;
        const bool is_new = levels_.back().names.insert(name).second;
        if (levels_.back().length > 0) name_.insert(0, 1, '.');
        if (!is_new) fail("is given twice; keep one of them");
        compare_key();
        levels_.back().members.emplace_back(std::move(name), nullptr);
        return true;
    }
    bool end_object() override {
        Json object = Json::object();
        auto& members = object.get_ref<Json::object_t&>();
        members.reserve(levels_.back().members.size());
        for (auto& [name, value] : levels_.back().members)
            members.emplace_back(std::move(name), std::move(value));
        return close(std::move(object));
    }
    bool end_array() override { return close(std::move(levels_.back().items)); }
    bool parse_error(std::size_t, const std::string&,
                     const nlohmann::detail::exception& error) override {
        throw InputError(
            fmt::format("{}: not valid JSON: {}", printable_line(file_), reason(error)));
    }

private:
    struct Level {
        std::string name; // in the level around: "radius", ".radius", "[3]"
        std::size_t length = 0;
        bool is_list = false;
        Json::array_t items; // of a list
        std::vector<std::pair<std::string, Json>> members;
        std::set<std::string> names;
    };

    std::size_t length() const { // of the key
        return (levels_.empty() ? 0 : levels_.back().length) + name_.size();
    }
    std::string whole_key() const {
        std::string key;
        for (const Level& level : levels_) key += level.name;
        return key + name_;
    }
    [[noreturn]] void fail(const std::string& message) const {
        throw InputError(fmt::format("{}: {}", place(file_, count_.line, whole_key()), message));
    }

    // An object's value is at the line of its key, which was compared already.
    void begin_value() {
        if (levels_.empty() || !levels_.back().is_list) return;
        name_ = fmt::format("[{}]", levels_.back().items.size());
        compare_key();
    }
    void compare_key() {
        const bool may_be = line_ == 0 && length() == wanted_.size();
        if (may_be && whole_key() == wanted_) line_ = count_.line;
    }
    template<class Value> bool scalar(Value&& value) {
        begin_value();
        add(std::forward<Value>(value));
        return true;
    }
    void add(Json value) {
        if (levels_.empty()) {
            whole_ = std::move(value);
        } else if (levels_.back().is_list) {
            levels_.back().items.push_back(std::move(value));
        } else {
            levels_.back().members.back().second = std::move(value);
        }
    }
    bool open(bool is_list) {
        begin_value();
        if (levels_.size() == json_nesting) {
            fail(fmt::format("objects and lists are nested too deeply; {} deep are read",
                             json_nesting));
        }
        const std::size_t length = this->length();
        levels_.push_back({std::move(name_), length, is_list, {}, {}, {}});
        name_.clear();
        return true;
    }
    bool close(Json value) {
        levels_.pop_back();
        add(std::move(value));
        return true;
    }

    const std::string& file_;
    std::string wanted_;
    LineCount count_;
    std::vector<Level> levels_;
    std::string name_; // of the last value in the innermost level
    Json whole_;
    std::size_t line_ = 0; // of the value that is wanted
};

} // namespace

Document::Document(std::string file)
    : file_(std::move(file))
    , value_(std::make_unique<Json>()) {}
Document::Document(Document&&) noexcept = default;
Document::~Document() = default;

Document Document::from_json(std::string_view text, std::string file) {
    Document document(std::move(file));
    *document.value_ = JsonReading(text, document.file_).take();
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
    if (!json_.empty()) return JsonReading(json_, file_, key).wanted_line();
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
    for (const auto& [name, value] : node_.value_->get_ref<const Json::object_t&>()) {
        known_.insert(name);
        values.push_back(
            {*node_.document_, value, node_.key_.empty() ? name : node_.key_ + "." + name});
    }
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
                                     ? fmt::format("known here: {}", fmt::join(candidates, ", "))
                                     : fmt::format("did you mean '{}'?", nearest);
        const std::string key =
            node_.key_.empty() ? item.key() : fmt::format("{}.{}", node_.key_, item.key());
        DocumentNode(*node_.document_, item.value(), key).fail("unknown key; " + hint);
    }
}

} // namespace isomotion::base
