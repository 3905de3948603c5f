#include "api/errors.h"

#include "api/drawing/errors.h"
#include "api/topology/errors.h"
#include "sequence/manifest_json.h"
#include "sequence/manifest_writer.h"
#include "topology/classify/recount.h"

namespace isomotion::api {

void throw_any_error() {
    try {
        throw;
    } catch (const sequence::ManifestError& error) {
        throw Error(Error::Code::file, error.what());
    } catch (const topology::Contradiction&) {
        throw_topology_error();
    } catch (...) {
        throw_drawing_error();
    }
}

} // namespace isomotion::api
