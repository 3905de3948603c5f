// Errors of what draws, beside those of api/scene.
#pragma once

#include <utility>

#include "isomotion/isomotion.h"

namespace isomotion::api {

[[noreturn]] void throw_drawing_error();

template<class Work> decltype(auto) with_drawing_errors(Work&& work) {
    try {
        return std::forward<Work>(work)();
    } catch (...) {
        throw_drawing_error();
    }
}

} // namespace isomotion::api
