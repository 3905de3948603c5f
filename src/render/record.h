// The counts for a tile's rays, as shaders/shade/hit.glsl packs them: verdict and evaluations of
// the primary ray in one word per pixel; if surfaces are kept, those of further rays in three more.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "gpu/target.h"
#include "image/frame.h"
#include "render/ray_counts.h"

namespace isomotion::render {

enum class Verdict { miss, hit, step_limit, nan, zero_gradient };
inline constexpr std::array verdict_names{"miss", "hit", "step limit", "NaN", "zero gradient"};

// Totals over the rays of a tile, whose rows are counted from the bottom.
struct Tally {
    std::array<std::int64_t, 5> verdicts{}; // by Verdict
    RayCounts rays{};

    // Number of rays that ended.
    std::int64_t ended() const;
};

// The counts of a tile, with places in its picture, whose rows are counted from the top.
RayCounts in_picture(RayCounts of_tile, const gpu::Rectangle& tile, int picture_height);

class Record {
public:
    // For tiles of at most so many pixels.
    Record(int most_pixels, bool has_further_rays)
        : words_(has_further_rays ? 4 : 1)
        , packed_(std::size_t(most_pixels) * words_) {}

    gpu::Format format() const { return words_ == 4 ? gpu::Format::rgba32ui : gpu::Format::r32ui; }
    // Reads that area of an attachment.
    void read(const gpu::Target& from, int attachment, const gpu::Rectangle& area);
    // The same from words in memory.
    void take(std::span<const std::uint32_t> words, int width, int height);

    // The functions below refer to the tile that was read last; pixels row by row from the bottom.
    int verdict(std::size_t pixel) const { return int(packed_[pixel * words_] & 7); }
    int evaluations(std::size_t pixel) const { return int(packed_[pixel * words_] >> 3); }
    Tally tally() const;

private:
    void add_further(int row, RayCounts& to) const;
    void place_undecided(RayCount& eye) const;

    std::size_t words_;
    std::vector<std::uint32_t> packed_;
    int width_ = 0, height_ = 0;
};

} // namespace isomotion::render
