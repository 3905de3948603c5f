#include "scene/reading/names.h"

#include <fmt/format.h>

#include "formula/graph/vocabulary.h"
#include "scene/limits.h"

namespace isomotion::scene {

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
    if (name == "t" || name == "i" || name == "n") {
        fail(at, key,
             fmt::format("'{}' means the {} in expressions; choose another name", name,
                         name == "t"   ? "time"
                         : name == "i" ? "element's index"
                                       : "number of elements"));
    }
}

} // namespace isomotion::scene
