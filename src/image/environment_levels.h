#pragma once

#include "image/environment.h"

namespace isomotion::image {

/// Reduces a map while it is read: whole blocks of texels become their mean.
class EnvironmentReduction {
public:
    /// The reduced map is at most `widest` texels wide.
    explicit EnvironmentReduction(int widest)
        : widest_(widest) {}

    /// As in EnvironmentSink.
    void begin(int width, int height);
    void rows(int first, std::span<const float> texels);

    EnvironmentMap map() const;

private:
    int widest_, read_width_ = 0, block_ = 1, width_ = 0, height_ = 0;
    std::vector<double> sums_; // R, G and B
};

/// The width of the map from which level 1 is drawn, here and in pages: its lobe is about a texel
/// wide.
inline constexpr int widest_level = 256;
/// The width that a map needs for that.
inline constexpr int widest_reduction = 1024;

/// A map as rough mirrors show it: eight blurred maps one below the other, for GGX's alpha = 1/128,
/// 1/64 ... 1. The first is `widest` texels wide, each later one half as wide as the one above it
/// and at least 32. `width` of the result is `widest`; narrower levels leave the right of their
/// rows 0. Each texel is the mean over the lobe of a mirror seen at normal incidence, as in Karis
/// (Real Shading in Unreal Engine 4, 2013), by filtered importance sampling (Krivanek & Colbert
/// 2008).
EnvironmentMap environment_levels(const EnvironmentMap& map, int widest);

} // namespace isomotion::image
