#include "formula/graph/vocabulary.h"

#include <algorithm>
#include <cctype>

#include "formula/graph/functions.h"

namespace isomotion::formula {

bool is_reserved(std::string_view name) {
    const Function* function = find_function(name);
    return name == "pi" || std::ranges::count(coordinate_names, name) > 0 ||
           (function && function->naming == Naming::reserved);
}

bool is_identifier(std::string_view name) {
    if (name.empty() || std::isdigit(static_cast<unsigned char>(name[0]))) return false;
    return std::all_of(name.begin(), name.end(),
                       [](unsigned char c) { return std::isalnum(c) || c == '_'; });
}

} // namespace isomotion::formula
