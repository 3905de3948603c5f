// Places in a scene file of the tests that a test gives its own values.
#pragma once

#include <map>
#include <string>

namespace isomotion::scenes {

using Values = std::map<std::string, std::string>; // by name, as they are written in TOML

// Puts the value of NAME for each {NAME}, also within values; what else is in braces stays. An
// expression of values that are numbers is computed: {= 1.8*r}. Long formulas repeat their terms:
// {60 times k: + sin(<k>*x)/400} has them for k = 1 to 60.
std::string with_values(std::string text, const Values& values);

// The value of an expression of these values. Throws formula::ParseError.
double number_of(const std::string& expression, const Values& values = {});

} // namespace isomotion::scenes
