#include "topology/timeline/plot_axis.h"

#include <cmath>

namespace isomotion::topology {

double nice_step(double span, double most) {
    const double rough = span / most, power = std::pow(10, std::floor(std::log10(rough)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= rough) return factor * power;
    }
    return 10 * power;
}

} // namespace isomotion::topology
