#include "scene/reading/names.h"

#include <fmt/format.h>

#include "formula/graph/vocabulary.h"
#include "scene/limits.h"

namespace isomotion::scene {

namespace {

// What the name means in expressions, so that nothing else can have it; empty for other names.
std::string_view meaning_in_expressions(std::string_view name) {
    return name == "t"   ? "time"
           : name == "i" ? "element's index"
           : name == "n" ? "number of elements"
                         : "";
}

} // namespace

void check_parameter_name(const std::string& name, const toml::node& at, const std::string& key,
                          bool has_arrays) {
    const bool is_of_elements = name == "i" || name == "n";
    if (has_arrays || !is_of_elements) check_name(name, at, key);
}

void check_name(const std::string& name, const toml::node& at, const std::string& key) {
    if (!formula::is_identifier(name)) {
        fail(at, key, "a name is letters, digits and _, and starts with a letter");
    }
    if (name.size() > limits::name_bytes) {
        fail(at, key,
             fmt::format("a name of {} characters; at most {} are read", name.size(),
                         limits::name_bytes));
    }
    if (formula::is_reserved(name)) {
        fail(at, key,
             fmt::format("'{}' already has a meaning in formulas; choose another name", name));
    }
    if (const std::string_view meaning = meaning_in_expressions(name); !meaning.empty()) {
        fail(at, key,
             fmt::format("'{}' means the {} in expressions; choose another name", name, meaning));
    }
}

} // namespace isomotion::scene
