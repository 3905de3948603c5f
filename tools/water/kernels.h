#pragma once

#include <numbers>

namespace water {

/// The kernels of support h, of which the lengths below are fractions q of h.
class Kernels {
public:
    explicit Kernels(float h)
        : h_(h)
        , scale_(8 / (std::numbers::pi_v<float> * h * h * h)) {}

    float support() const { return h_; }

    /// The cubic spline of Monaghan 1992, whose integral is 1.
    float value(float q) const {
        if (q >= 1) return 0;
        if (q > 0.5F) return scale_ * 2 * (1 - q) * (1 - q) * (1 - q);
        return scale_ * (1 - 6 * q * q * (1 - q));
    }

    /// Its derivative along the distance, divided by the distance.
    float slope_by_distance(float q) const {
        if (q >= 1) return 0;
        const float scale = 6 * scale_ / (h_ * h_);
        if (q > 0.5F) return -scale * (1 - q) * (1 - q) / q;
        return -scale * (2 - 3 * q);
    }

    /// The cohesion of Akinci, Akinci & Teschner 2013, Eq. 2: pulls from h to h/2, then less and
    /// less, and pushes where particles nearly meet.
    float cohesion(float q) const {
        if (q >= 1) return 0;
        const float p = (1 - q) * (1 - q) * (1 - q) * q * q * q;
        return 4 * scale_ * (q > 0.5F ? p : 2 * p - 1.0F / 64);
    }

private:
    float h_, scale_;
};

} // namespace water
