#include "api/topology/errors.h"

#include <fmt/format.h>

#include "api/scene/errors.h"
#include "topology/classify/recount.h"

namespace isomotion::api {

void throw_topology_error() {
    try {
        throw;
    } catch (const topology::Contradiction& error) {
        throw Error(Error::Code::internal,
                    fmt::format("isomotion contradicts itself: {}", error.what()));
    } catch (...) {
        throw_error();
    }
}

} // namespace isomotion::api
