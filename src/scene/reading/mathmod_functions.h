// The functions that expressions of MathMod's scripts call, and those here that they become.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isomotion::scene::mathmod {

// Functions that the formulas of isomotion lack. They are the first definitions of all values.
enum class Helper : std::size_t { signed_power, remainder, arcosh };

struct Function {
    const char* name;
    const char* ours; // the function that it is here
    double (*of_one)(double);
    double (*of_two)(double, double) = nullptr;
    bool is_never_negative = false, may_jump = false;
    std::optional<Helper> helper = std::nullopt;

    std::size_t arguments() const { return of_two ? 2 : 1; }
};

// Null if fparser has none of the name, or it is no function of numbers.
const Function* find_function(std::string_view name);
std::vector<std::string> function_names();
// Noise and shapes that MathMod adds to those of fparser.
bool is_mathmods_own(std::string_view name);

} // namespace isomotion::scene::mathmod
