#include "scene/reading/mathmod_json.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/printable.h"
#include "scene/error.h"

namespace isomotion::scene::mathmod {
namespace {

using Kind = JsonValue::Kind;

constexpr std::size_t most_nested = 32;        // lists and objects in one another
constexpr std::size_t most_values = 1'000'000; // values of a file
constexpr std::size_t longest_token = 60;      // bytes of it in a message

// The text as JSON has it, and the line in which each of its texts and keys begins.
struct Prepared {
    std::string json;
    std::vector<std::size_t> lines;
};

Prepared prepare(std::string_view text) {
    Prepared prepared{std::string(text), {}};
    bool is_within = false;
    std::size_t line = 0;
    for (std::size_t k = 0; k < text.size(); ++k) {
        const char c = text[k];
        if (c == '"') {
            is_within = !is_within;
            if (is_within) prepared.lines.push_back(line);
        } else if (is_within && c == '\\') {
            ++k; // a quote after it is one of the text
            if (k < text.size() && text[k] == '\n') ++line;
        } else if (c == '\n' || c == '\t' || c == '\r') {
            line += c == '\n';
            if (is_within) prepared.json[k] = ' ';
        }
    }
    return prepared;
}

// What nlohmann's parser calls.
class Builder : public nlohmann::json_sax<nlohmann::json> {
public:
    explicit Builder(const std::vector<std::size_t>& lines)
        : lines_(lines) {}

    JsonValue take() { return std::move(root_); }
    std::size_t line() const { return line_; }

    std::string mistake; // why parsing was given up
    std::size_t position = 0;

    bool null() override { return add({}); }
    bool boolean(bool) override { return add({}); }
    bool number_integer(number_integer_t value) override {
        return add(of(Kind::number, fmt::format("{}", value)));
    }
    bool number_unsigned(number_unsigned_t value) override {
        return add(of(Kind::number, fmt::format("{}", value)));
    }
    bool number_float(number_float_t, const string_t& text) override {
        return add(of(Kind::number, text));
    }
    bool string(string_t& text) override {
        next_line();
        return add(of(Kind::text, text));
    }
    bool binary(binary_t&) override { return false; }
    bool key(string_t& name) override {
        next_line();
        open_.back()->keys.push_back(name);
        return true;
    }
    bool start_object(std::size_t) override { return open(Kind::object); }
    bool start_array(std::size_t) override { return open(Kind::list); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }
    bool parse_error(std::size_t at, const std::string& token,
                     const nlohmann::json::exception&) override {
        position = at;
        mistake = fmt::format("is no JSON from '{}' on: a quote, a comma or a brace is missing or "
                              "one too many",
                              base::printable_line(std::string_view(token).substr(
                                  0, std::min(token.size(), longest_token))));
        return false;
    }

private:
    static JsonValue of(Kind kind, const std::string& text) { return {kind, text, {}, {}, 0}; }

    void next_line() {
        if (texts_ < lines_.size()) line_ = lines_[texts_++];
    }
    bool add(JsonValue value) {
        if (++count_ > most_values) {
            mistake = fmt::format("has more than {} values", most_values);
            return false;
        }
        value.line = line_;
        if (open_.empty())
            root_ = std::move(value);
        else
            open_.back()->items.push_back(std::move(value));
        return true;
    }
    bool open(Kind kind) {
        if (open_.size() == most_nested) {
            mistake =
                fmt::format("has lists and objects more than {} deep in one another", most_nested);
            return false;
        }
        if (!add(of(kind, ""))) return false;
        open_.push_back(open_.empty() ? &root_ : &open_.back()->items.back());
        return true;
    }
    bool close() {
        open_.pop_back();
        return true;
    }

    const std::vector<std::size_t>& lines_;
    JsonValue root_;
    std::vector<JsonValue*> open_; // lists grow at their ends alone, so outer ones stay in place
    std::size_t texts_ = 0, line_ = 0, count_ = 0;
};

} // namespace

const JsonValue* JsonValue::find(std::string_view key) const {
    for (std::size_t k = std::min(keys.size(), items.size()); k-- > 0;) {
        if (keys[k] == key) return &items[k];
    }
    return nullptr;
}

void JsonPlace::fail(std::string_view message) const {
    throw SceneError(fmt::format("{}:{}: {}{}{}", file->string(), line + 1,
                                 base::printable_line(key), key.empty() ? "" : ": ",
                                 base::printable_line(message)));
}

JsonValue read_json(std::string_view text, const std::filesystem::path& file) {
    const Prepared prepared = prepare(text);
    Builder builder(prepared.lines);
    if (nlohmann::json::sax_parse(prepared.json, &builder)) return builder.take();
    const std::size_t end = std::min(builder.position, text.size());
    const std::size_t line =
        builder.position > 0
            ? std::size_t(std::ranges::count(text.substr(0, end > 0 ? end - 1 : 0), '\n'))
            : builder.line();
    JsonPlace{&file, line, ""}.fail(builder.mistake);
}

} // namespace isomotion::scene::mathmod
