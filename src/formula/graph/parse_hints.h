// What to write instead of what a formula can't say.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace isomotion::formula {

// Behind "unknown name 'xy'": "; a product is written 'x*y'". `known`: the names that may be used.
std::string hint_for_unknown(std::string_view name, const std::vector<std::string>& known);

// Behind "there is no function 'sqr'": "; write a^2 ...". `known`: the functions' names.
std::string hint_for_call(std::string_view name, const std::vector<std::string>& known);

// What is wrong where nothing can be read at `at`.
std::string message_for_unexpected(std::string_view text, std::size_t at);

} // namespace isomotion::formula
