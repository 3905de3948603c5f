// What is counted of a tile's rays, as shaders/shade/record.glsl packs it: verdict and evaluations
// of the eye's ray in a word a pixel, and in another, where surfaces are kept, the evaluations of
// its shadow rays.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "gpu/target.h"
#include "image/frame.h"

namespace isomotion::render {

enum class Verdict { miss, hit, step_limit, nan, zero_gradient };
inline constexpr std::array verdict_names{"miss", "hit", "step limit", "NaN", "zero gradient"};

// What the rays of a tile went through.
struct Tally {
    std::array<std::int64_t, 5> verdicts{}; // by Verdict
    std::int64_t evaluations = 0;

    // Those that ended.
    std::int64_t rays() const;
};

class Record {
public:
    // For tiles of up to so many pixels.
    Record(int most_pixels, bool has_further_rays)
        : words_(has_further_rays ? 2 : 1)
        , packed_(std::size_t(most_pixels) * words_) {}

    gpu::Format format() const { return words_ == 2 ? gpu::Format::rg32ui : gpu::Format::r32ui; }
    void read(const gpu::Target& from, int attachment, int width, int height);
    // The same of words that were read.
    void take(std::span<const std::uint32_t> words, int width, int height);

    // These are of the tile that was read last; pixels row by row from the bottom.
    int verdict(std::size_t pixel) const { return int(packed_[pixel * words_] & 7); }
    int evaluations(std::size_t pixel) const { return int(packed_[pixel * words_] >> 3); }
    Tally tally() const;

private:
    std::size_t words_;
    std::vector<std::uint32_t> packed_;
    int width_ = 0, height_ = 0;
};

} // namespace isomotion::render
