#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "image/frame.h"

namespace isomotion::image {

/// How far two channels of one name are apart. Two NaNs are equal, and so are two infinities of one
/// sign; NaN or infinity against anything else is an infinite difference.
struct ChannelDifference {
    std::string name;
    double largest = 0;
    double mean = 0;                ///< over the samples whose difference is finite
    std::size_t not_finite = 0;     ///< samples whose difference is infinite
    std::size_t over_tolerance = 0; ///< samples further apart than the tolerance
};

struct Comparison {
    bool same_size = false;
    std::vector<std::string> only_in_first;  ///< names of channels
    std::vector<std::string> only_in_second; ///< names of channels
    std::vector<ChannelDifference> channels; ///< those in both; empty if the sizes differ

    /// Same size, same channels and no sample over the tolerance.
    bool within_tolerance() const;
};

Comparison compare(const Frame& first, const Frame& second, double tolerance = 0);

} // namespace isomotion::image
