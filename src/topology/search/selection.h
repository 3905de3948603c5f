// A smooth formula of a KinkTree as a moving field, with its multipliers as variables.
#pragma once

#include "topology/field/kinks.h"
#include "topology/field/moving_field.h"

namespace isomotion::topology {

// Keeps no reference to the tree.
class Selection {
public:
    // `motion` is the motion whose field the tree splits.
    Selection(const Motion& motion, const Stratum& stratum, const KinkTree& tree,
              const KinkTree::Branch& branch);

    const MovingField& field() const { return field_; }
    std::span<const Kink> kinks() const { return kinks_; }
    std::size_t multipliers() const { return multipliers_; }

    // The multipliers among the variables of a box of the field.
    std::span<const formula::Interval> multipliers(const Box& box) const {
        return std::span(box).subspan(std::size_t(field_.dimension()), multipliers_);
    }
    // dL/d|h| for each kink. `place` is the place of the box.
    std::vector<formula::Interval> heights(const Box& box, const SpaceBox& place) const;

private:
    std::vector<Kink> kinks_;
    std::size_t multipliers_;
    MovingField field_;
    formula::Bindings<formula::Interval> bindings_;
    formula::Program heights_;
};

// The motion with a formula of the tree as its field: L of a branch, or F.
Motion with_field(const Motion& motion, const BoundFormula& formula, formula::NodeId root);

} // namespace isomotion::topology
