// The grammar of expressions in MathMod's scripts: that of the library fparser.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "scene/reading/mathmod_values.h"

namespace isomotion::scene::mathmod {

struct Scope {
    const Values* values = nullptr; // null: no names but the inputs and pi
    // Names of inputs in the script, and what stands for them.
    std::map<std::string, Part, std::less<>> inputs;
    bool has_functions = true;   // that scripts define
    bool names_constants = true; // rather than to write their numbers
};

Part parsed(std::string_view text, const Scope& scope, const JsonPlace& at);

} // namespace isomotion::scene::mathmod
