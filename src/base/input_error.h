#pragma once

#include <stdexcept>
#include <string>

#include "base/printable.h"

namespace isomotion::base {

// A mistake in what a user or a stranger wrote: what() is "file:line: key: what is wrong, and what
// would be right". Names and texts of the file in it are printable.
class InputError : public std::runtime_error {
public:
    explicit InputError(const std::string& message)
        : std::runtime_error(printable(message)) {}
};

} // namespace isomotion::base
