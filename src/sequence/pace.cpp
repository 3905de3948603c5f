#include "sequence/pace.h"

#include <algorithm>

namespace isomotion::sequence {

void Pace::note(double part, Seconds passed) {
    if (part <= part_) return;
    if (compiling_ > 0) {
        --compiling_;
        begin_ = part;
        at_begin_ = passed;
    }
    part_ = part;
    at_part_ = passed;
}

std::optional<Pace::Seconds> Pace::left(Seconds passed) const {
    if (part_ <= begin_) return std::nullopt;
    const Seconds at_part = (1 - part_) / (part_ - begin_) * (at_part_ - at_begin_);
    return std::max(at_part - (passed - at_part_), Seconds(0));
}

} // namespace isomotion::sequence
