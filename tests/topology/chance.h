// Random numbers that are the same on every machine: distributions of the standard library differ.
#pragma once

#include <random>

namespace isomotion::topology {

class Chance {
public:
    explicit Chance(unsigned seed)
        : random_(seed) {}

    double number(double low, double high) {
        return low + (high - low) * double(random_()) / 0x1p32;
    }
    int below(int count) { return int(random_() % unsigned(count)); }
    bool is_one_in(int count) { return below(count) == 0; }

private:
    std::mt19937 random_;
};

} // namespace isomotion::topology
