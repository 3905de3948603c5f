// A frame's field over boxes, as the smooth formulas that it may equal there (kinks.h).
#pragma once

#include <map>
#include <memory>
#include <span>
#include <vector>

#include "topology/field/frame_field.h"
#include "topology/field/kinks.h"

namespace isomotion::topology {

// Use one per thread.
class Pieces {
public:
    explicit Pieces(const SpaceFormula& formula);

    enum class Sign { negative, positive, mixed };
    struct Over {
        Sign sign = Sign::mixed; // of G, as in frame_field.h
        // All slopes of each formula that may be 0 in the box. None if G may jump, or if there are
        // too many formulas to examine.
        std::vector<Box> gradients;
    };
    // `near` belongs to a box around this one.
    Over over(const SpaceBox& box, const Elements& near);
    formula::Interval value(const SpaceBox& box);

    const Elements& everything() const { return whole_.everything(); }
    // Elements of sums that matter in a box, for a formula without kinks; otherwise all of them.
    bool has_kinks() const { return tree_.has_kinks(); }
    Elements nearer(const Elements& near, const SpaceBox& box) { return whole_.nearer(near, box); }

private:
    FrameField& field(const KinkTree::Branch& piece);
    bool may_jump(const SpaceBox& box);

    Side solid_;
    KinkTree tree_;
    FrameField whole_;
    formula::Program jumps_;
    std::map<const KinkTree::Branch*, std::unique_ptr<FrameField>> fields_;
};

} // namespace isomotion::topology
