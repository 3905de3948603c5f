// Converts boxes of a stratum's coordinates to boxes in space.
#pragma once

#include <array>

#include "formula/evaluate/evaluate.h"
#include "topology/field/moving_field.h"
#include "topology/field/space_box.h"

namespace isomotion::topology {

// Use one per thread.
class StratumPlaces {
public:
    StratumPlaces(const Motion& motion, const Stratum& stratum)
        : stratum_(stratum)
        , bindings_(formula::convert<formula::Interval>(motion.bindings)) {
        std::vector<formula::NodeId> walls(motion.low.begin(), motion.low.end());
        walls.insert(walls.end(), motion.high.begin(), motion.high.end());
        walls_ = formula::schedule(motion.graph, walls);
    }

    // Free coordinates come from the box, the others from the walls at its clock.
    SpaceBox at(const MovingField& field, const Box& box) const {
        std::array<formula::Interval, 6> walls;
        if (stratum_.dimension() < 3) {
            const std::array<formula::Interval, 4> inputs{0.0, 0.0, 0.0, box[field.clock()]};
            formula::Evaluator<formula::Interval>(walls_).point(bindings_, inputs, walls);
        }
        SpaceBox where;
        std::size_t next = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const Stratum::End end = stratum_.axes[k];
            where[k] = end == Stratum::End::free  ? field.x(box, next++)
                       : end == Stratum::End::low ? walls[k]
                                                  : walls[3 + k];
        }
        return where;
    }

private:
    Stratum stratum_;
    formula::Bindings<formula::Interval> bindings_;
    formula::Program walls_;
};

} // namespace isomotion::topology
