// The functions of POV-Ray's expressions, and those of functions.inc, as formulas.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/reading/pov_values.h"

namespace isomotion::scene {

bool is_pov_function(std::string_view name);
// Why a function is not read; empty if it is.
std::string pov_function_refusal(const std::string& name);
// "2 numbers".
std::string pov_function_arguments(const std::string& name);
// The call of a function that is read; none if it takes another number of arguments.
std::optional<PovNumber> called_pov_function(const std::string& name,
                                             const std::vector<PovNumber>& arguments);
// Names that formulas made of functions and solids call: no parameter may hide them.
bool is_pov_word_of_formulas(std::string_view name);

} // namespace isomotion::scene
