#pragma once

#include <string>

#include <isomotion/error.h>

#include "base/printable.h"

namespace isomotion::base {

// A mistake in the input of a user or a stranger. what() is "file:line: key: what is wrong, and
// what would be right". Names and texts from the file are printable in it.
class InputError : public Error {
public:
    explicit InputError(const std::string& message)
        : Error(Code::input, printable(message)) {}
};

} // namespace isomotion::base
