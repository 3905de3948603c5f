// Functions that every formula can call and none need define: solids, surfaces that repeat
// themselves, and motions of space. They are text, as a formula would define them (library.txt).
#pragma once

#include <string_view>

#include "formula/graph/own_functions.h"

namespace isomotion::formula {

const OwnFunctions& library();
std::string_view library_text(); // without comments

} // namespace isomotion::formula
