// Errors of topology, beside those of api/scene.
#pragma once

#include <utility>

#include "isomotion/isomotion.h"

namespace isomotion::api {

[[noreturn]] void throw_topology_error();

template<class Work> decltype(auto) with_topology_errors(Work&& work) {
    try {
        return std::forward<Work>(work)();
    } catch (...) {
        throw_topology_error();
    }
}

} // namespace isomotion::api
