// How deeply the tables and lists of a TOML text lie in one another.
#pragma once

#include <string_view>

namespace isomotion::base {

// The first line in which brackets, or the dots of one key, nest more than `most` deep; 0 if there
// is none. A parser and the tree that it makes recurse for each: this finds by one pass over the
// text those that would end in the stack. The text may be malformed; up to its first mistake it is
// read as a parser reads it.
int first_line_nested_beyond(std::string_view text, int most);

} // namespace isomotion::base
