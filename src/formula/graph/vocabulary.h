// The names that a formula may use, and the node that each becomes.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isomotion::formula {

struct FieldName {
    std::string name;
    // Set for a field with one value for all elements: it is a parameter, read once instead of once
    // per element.
    std::optional<int> parameter;
};

struct ArrayName {
    std::string name;
    std::vector<FieldName> fields;
};

// Input and parameter indices are positions in these lists.
struct Vocabulary {
    std::vector<std::string> inputs;
    std::vector<std::string> parameters;
    std::vector<ArrayName> arrays;
    bool allows_random =
        false;                // random(i, k): in animation only, where the CPU evaluates in double
    bool allows_picks = true; // least(array, a, b), which jumps
    bool allows_equation = false; // left = right, which is left - right
};

// The inputs of a surface's field: position, and for derivatives the ray's direction.
inline const std::vector<std::string> coordinate_names{"x", "y", "z"};

// Names no parameter, array or field may take: reserved functions, constants and coordinates.
bool is_reserved(std::string_view name);
bool is_identifier(std::string_view name);

} // namespace isomotion::formula
