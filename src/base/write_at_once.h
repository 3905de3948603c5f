// Writes words where nothing may be waited for: in a handler of a signal.
#pragma once

#include <string_view>

namespace isomotion::base {

// Drops the words if nobody makes room for them, as in a full pipe. May be called in handlers of
// signals.
void write_at_once(int descriptor, std::string_view words);

} // namespace isomotion::base
