// Typed access to a JSON or TOML document that says where a mistake is: "file: key: what is wrong,
// and what would be right", of TOML "file:line: key: ...". What nobody asked for is a mistake too.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "formula/interval/interval.h"

namespace isomotion::topology {

// A mistake in a file of this folder's; what() is the message above.
class DocumentError : public std::invalid_argument {
public:
    using std::invalid_argument::invalid_argument;
};

// A document with the lines of what can be named in it: "components.12", "events[3]".
struct Document {
    Document(nlohmann::json json) // without lines
        : value(std::move(json)) {}

    nlohmann::json value;
    std::map<std::string, std::size_t> lines;
};

// Throw DocumentError, also for a key that is given twice.
nlohmann::json parse_json(std::string_view text, const std::string& file);
Document parse_toml(std::string_view text, const std::string& file);

class JsonObject;

class JsonValue {
public:
    JsonValue(const nlohmann::json& value, const std::string& file, std::string key)
        : value_(&value)
        , file_(&file)
        , key_(std::move(key)) {}
    // All of a document.
    JsonValue(const Document& document, const std::string& file)
        : value_(&document.value)
        , lines_(&document.lines)
        , file_(&file) {}

    [[noreturn]] void fail(const std::string& message) const;
    const std::string& key() const { return key_; }

    std::string text() const;
    double number() const; // finite
    int integer(int least, int most) const;
    bool boolean() const;
    std::vector<JsonValue> list() const;
    std::vector<JsonValue> list(std::size_t size) const;
    JsonObject object() const;
    // [lo, hi], null in place of an end for none on that side; a number for a point.
    formula::Interval interval() const;
    bool is_null() const { return value_->is_null(); }
    bool is_object() const { return value_->is_object(); }

private:
    friend class JsonObject;
    JsonValue inner(const nlohmann::json& value, std::string key) const;

    const nlohmann::json* value_;
    const std::map<std::string, std::size_t>* lines_ = nullptr;
    const std::string* file_;
    std::string key_;
};

class JsonObject {
public:
    explicit JsonObject(const JsonValue& node);

    JsonValue at(const std::string& name); // fails if there is none
    std::optional<JsonValue> find(const std::string& name);
    std::vector<JsonValue> all();                    // every value in it
    std::string key_of(const JsonValue& node) const; // without the object's own
    void refuse_rest() const;

private:
    JsonValue node_;
    std::set<std::string> known_;
};

} // namespace isomotion::topology
