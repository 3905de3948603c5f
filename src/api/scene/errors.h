// Turns what the library throws into Error, the one class that leaves it.
#pragma once

#include <utility>

#include "isomotion/isomotion.h"

namespace isomotion::api {

// To be called where an exception is handled: throws the Error for it, or std::bad_alloc.
[[noreturn]] void throw_error();

template<class Work> decltype(auto) with_errors(Work&& work) {
    try {
        return std::forward<Work>(work)();
    } catch (...) {
        throw_error();
    }
}

// A call that was stopped where there is nothing to return.
[[noreturn]] inline void throw_stopped() { throw Error(Error::Code::stopped, "stopped"); }

} // namespace isomotion::api
