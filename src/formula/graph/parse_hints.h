// What to write instead of what a formula can't say.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace isomotion::formula {

// Behind "unknown name 'xy'": "; a product is written 'x*y'". `known`: the names that may be used.
std::string hint_for_unknown(std::string_view name, const std::vector<std::string>& known);

// Behind "unexpected '%'"; mostly empty.
std::string_view hint_for_sign(std::string_view sign);

} // namespace isomotion::formula
