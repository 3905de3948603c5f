// Counts pixels that pop: hit or missed for one frame only, while truth stays the same.
#pragma once

#include <cstdint>
#include <vector>

#include "image/frame.h"
#include "roots/certify.h"

namespace isomotion::accuracy {

class Popping {
public:
    // Call it for successive frames, in order.
    void add(const image::Frame& drawn, const roots::Truth& truth);
    std::int64_t count() const { return count_; }

private:
    struct Seen {
        std::vector<bool> hit;
        std::vector<int> certain; // 1 hit, 0 miss, -1 unknown
    };
    std::vector<Seen> last_; // at most two
    std::int64_t count_ = 0;
};

} // namespace isomotion::accuracy
