#include "roots/field_at_frame.h"

#include <algorithm>
#include <vector>

#include "scene/near_elements.h"

namespace isomotion::roots {

EnclosedField::Frame EnclosedField::at(const scene::SurfaceAt& now, int threads,
                                       std::shared_ptr<const elements::ElementGrid> made) {
    const std::vector<int> counts = now.bindings.counts();
    const bool are_many = !counts.empty() && std::ranges::max(counts) > elements::FieldByPlace::few;
    if (are_many && !was_looked_for_) {
        by_place_ = elements::FieldByPlace::of(field_, counts);
        was_looked_for_ = true;
    }
    Frame frame(formula::enclosure_programs(field_), now);
    if (are_many && by_place_) {
        frame.by_place_ = by_place_->at(now.bindings, scene::region_of_elements(now.bounds),
                                        threads, std::move(made));
    }
    return frame;
}

RootFinder EnclosedField::Frame::finder(Budget budget) const {
    return by_place_ ? RootFinder(*by_place_, budget) : RootFinder(programs_, now_, budget);
}

} // namespace isomotion::roots
