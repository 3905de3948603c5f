// Keyframes: values at given times and a rule between them.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace isomotion::animation {

enum class Ease {
    linear,
    smooth, // velocity 0 at every key: smoothstep
    hold,   // the previous key's value
    cubic,  // through the keys with continuous velocity: Catmull-Rom on uneven times
};

inline constexpr std::string_view ease_names[] = {"linear", "smooth", "hold", "cubic"};

struct Key {
    double time = 0;
    double value = 0;
};

// Keys in strictly ascending time (at least one). Constant before the first and after the last.
struct Keys {
    std::vector<Key> keys;
    Ease ease = Ease::linear;

    double at(double time) const;
    // The cubic's derivative at key k: the slope between its neighbours (Catmull-Rom), or at the
    // ends that of the only segment.
    double velocity(std::size_t k) const;
};

} // namespace isomotion::animation
