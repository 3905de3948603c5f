// Turns whatever isomotion throws into Error.
#pragma once

#include <utility>

#include "isomotion/isomotion.h"

namespace isomotion::api {

[[noreturn]] void throw_any_error();

template<class Work> decltype(auto) with_all_errors(Work&& work) {
    try {
        return std::forward<Work>(work)();
    } catch (...) {
        throw_any_error();
    }
}

} // namespace isomotion::api
