#pragma once

#include "image/environment.h"

namespace isomotion::image {

/// Makes a map smaller while it is read: whole blocks of texels become their mean.
class EnvironmentReduction {
public:
    /// The reduced map is at most `widest` texels wide.
    explicit EnvironmentReduction(int widest)
        : widest_(widest) {}

    /// As an EnvironmentSink has them.
    void begin(int width, int height);
    void rows(int first, std::span<const float> texels);

    EnvironmentMap map() const;

private:
    int widest_, read_width_ = 0, block_ = 1, width_ = 0, height_ = 0;
    std::vector<double> sums_; // R, G and B
};

/// How wide level 1 is drawn from, here and in pages: its lobe is about a texel wide.
inline constexpr int widest_level = 256;
/// How wide a map need be for that.
inline constexpr int widest_reduction = 1024;

/// What rough mirrors show of a map: eight blurred maps one below the other, for GGX's alpha =
/// 1/128, 1/64 ... 1. The first is `widest` texels wide, each further one half as wide as the one
/// above it and at least 32; `width` of the result is `widest`, and narrower levels leave the right
/// of their rows at 0. Each is the mean over the lobe of a mirror that is seen straight on, as
/// Karis has it (Real Shading in Unreal Engine 4, 2013), by filtered importance sampling (Krivanek
/// & Colbert 2008).
EnvironmentMap environment_levels(const EnvironmentMap& map, int widest);

} // namespace isomotion::image
