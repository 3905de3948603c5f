// Two pictures, channel by channel.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "image/frame.h"

namespace isomotion::image {

// How far two channels of one name are apart. Two NaNs are equal, and so are two infinities of one
// sign; NaN or infinity against anything else is an infinite difference.
struct ChannelDifference {
    std::string name;
    double largest = 0;
    double mean = 0;                // over the samples whose difference is finite
    std::size_t not_finite = 0;     // samples whose difference is infinite
    std::size_t over_tolerance = 0; // samples further apart than the tolerance
};

struct Comparison {
    bool same_size = false;
    std::vector<std::string> only_in_first;  // names of channels
    std::vector<std::string> only_in_second; // names of channels
    std::vector<ChannelDifference> channels; // those in both; empty if the sizes differ

    // Same size, same channels and no sample over the tolerance.
    bool within_tolerance() const;
};

inline double distance(float a, float b) {
    if (a == b || (std::isnan(a) && std::isnan(b)))
        return 0; // the first holds for equal infinities
    if (!std::isfinite(a) || !std::isfinite(b)) return std::numeric_limits<double>::infinity();
    return std::abs(double(a) - double(b));
}

inline ChannelDifference difference(const Channel& first, const Channel& second, double tolerance) {
    ChannelDifference result{first.name};
    double sum = 0;
    for (std::size_t i = 0; i < first.samples.size(); ++i) {
        const double apart = distance(first.samples[i], second.samples[i]);
        result.largest = std::max(result.largest, apart);
        if (apart > tolerance) ++result.over_tolerance;
        if (std::isinf(apart))
            ++result.not_finite;
        else
            sum += apart;
    }
    if (const std::size_t finite = first.samples.size() - result.not_finite)
        result.mean = sum / double(finite);
    return result;
}

inline std::vector<std::string> names_missing(const Frame& of, const Frame& in) {
    std::vector<std::string> names;
    for (const Channel& channel : of.channels)
        if (!in.find(channel.name)) names.push_back(channel.name);
    return names;
}

inline bool Comparison::within_tolerance() const {
    return same_size && only_in_first.empty() && only_in_second.empty() &&
           std::ranges::all_of(channels, [](const auto& c) { return c.over_tolerance == 0; });
}

inline Comparison compare(const Frame& first, const Frame& second, double tolerance = 0) {
    check(first);
    check(second);
    Comparison result;
    result.same_size = first.width == second.width && first.height == second.height;
    result.only_in_first = names_missing(first, second);
    result.only_in_second = names_missing(second, first);
    if (!result.same_size) return result;
    for (const Channel& channel : first.channels)
        if (const Channel* other = second.find(channel.name))
            result.channels.push_back(difference(channel, *other, tolerance));
    return result;
}

} // namespace isomotion::image
