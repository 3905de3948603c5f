#include "render/record.h"

#include <algorithm>
#include <numeric>

namespace isomotion::render {

std::int64_t Tally::rays() const {
    return std::accumulate(verdicts.begin(), verdicts.end(), std::int64_t(0));
}

void Record::read(const gpu::Target& from, int attachment, const gpu::Rectangle& area) {
    width_ = area.width;
    height_ = area.height;
    const auto words = std::size_t(area.width) * std::size_t(area.height) * words_;
    from.read(attachment, area.x, area.y, area.width, area.height, std::span(packed_).first(words));
}

void Record::take(std::span<const std::uint32_t> words, int width, int height) {
    width_ = width;
    height_ = height;
    std::copy(words.begin(), words.end(), packed_.begin());
}

// Counts the bits of verdicts, by few operations that loops vectorise. A ray that has not ended has
// all three bits, and is none of the five.
Tally Record::tally() const {
    Tally tally;
    for (int y = 0; y < height_; ++y) {
        const std::size_t row = std::size_t(y) * std::size_t(width_);
        std::uint32_t first = 0, second = 0, third = 0, both = 0, all = 0;
        std::uint64_t evaluations = 0;
        const auto add = [&](std::size_t words) {
            const std::uint32_t* word = packed_.data() + row * words;
            for (std::size_t x = 0; x < std::size_t(width_); ++x) {
                const std::uint32_t packed = word[x * words];
                const std::uint32_t of_both = packed & packed >> 1;
                first += packed & 1;
                second += packed >> 1 & 1;
                third += packed >> 2 & 1;
                both += of_both & 1;
                all += of_both & packed >> 2 & 1;
                evaluations += packed >> 3;
                if (words == 2) evaluations += word[x * words + 1];
            }
        };
        if (words_ == 1) {
            add(1);
        } else {
            add(2);
        }
        const std::int64_t ended = std::int64_t(width_) - all;
        const std::array<std::int64_t, 4> numbers{first - both, second - both, both - all,
                                                  third - all};
        tally.verdicts[0] += ended - numbers[0] - numbers[1] - numbers[2] - numbers[3];
        for (std::size_t k = 0; k < 4; ++k) tally.verdicts[k + 1] += numbers[k];
        tally.evaluations += std::int64_t(evaluations);
    }
    return tally;
}

} // namespace isomotion::render
