// Lets nothing leave the library but Error and std::bad_alloc: what the standard library throws
// gets a code here.
#pragma once

#include <utility>

#include "isomotion/isomotion.h"

namespace isomotion::api {

// To be called where an exception is handled: throws it, or the Error that stands for it.
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
