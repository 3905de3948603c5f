// Parses TOML texts of strangers.
#pragma once

#include <string>
#include <string_view>

#include <toml++/toml.h>

namespace isomotion::base {

// Nesting limit of tables and lists, since the parser and its tree recurse.
inline constexpr int toml_nesting = 32;

// Messages name `file`. Throws InputError: "file:line: what is wrong".
toml::table parse_toml(std::string_view text, const std::string& file);

// The first line in which brackets, or the dots of one key, nest more than `most` deep; 0 if there
// is none. One pass over the text finds what would exhaust the stack. The text may be malformed; up
// to its first mistake it is read as a parser reads it.
int first_line_nested_beyond(std::string_view text, int most);

} // namespace isomotion::base
