#include "probe/measured.h"

#include "probe/cubic_steps.h"
#include "probe/elements_at_a_place.h"
#include "probe/regions.h"

namespace isomotion::probe {

scene::Measured measured(const scene::OneSurface& one, const scene::SurfaceAt& first) {
    scene::Measured found;
    found.smoothness = formula::smoothness(*one.surface.field, regions(one, first));
    found.cubic_steps = cubic_steps(one, found.smoothness, first);
    const scene::Isolation& isolation = one.surface.isolation;
    if (isolation.method == scene::Method::hermite && !isolation.certify)
        found.elements_at_a_place = elements_at_a_place(one);
    return found;
}

} // namespace isomotion::probe
