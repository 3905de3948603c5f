#include "formula/graph/vocabulary.h"

#include <algorithm>
#include <cctype>

namespace isomotion::formula {

bool is_identifier(std::string_view name) {
    if (name.empty() || std::isdigit(static_cast<unsigned char>(name[0]))) return false;
    return std::all_of(name.begin(), name.end(),
                       [](unsigned char c) { return std::isalnum(c) || c == '_'; });
}

} // namespace isomotion::formula
