#include "render/record.h"

#include <algorithm>
#include <numeric>

namespace isomotion::render {

std::int64_t Tally::rays() const {
    return std::accumulate(verdicts.begin(), verdicts.end(), std::int64_t(0));
}

void Record::read(const gpu::Target& from, int attachment, int width, int height) {
    width_ = width;
    height_ = height;
    const auto words = std::size_t(width) * std::size_t(height) * words_;
    from.read(attachment, 0, 0, width, height, std::span(packed_).first(words));
}

void Record::take(std::span<const std::uint32_t> words, int width, int height) {
    width_ = width;
    height_ = height;
    std::copy(words.begin(), words.end(), packed_.begin());
}

// Lanes of ints, which loops vectorise.
Tally Record::tally() const {
    Tally tally;
    for (int y = 0; y < height_; ++y) {
        const std::size_t row = std::size_t(y) * std::size_t(width_);
        std::array<int, 5> verdicts{};
        std::uint64_t evaluations = 0;
        const auto add = [&](std::size_t words) {
            const std::uint32_t* word = packed_.data() + row * words;
            for (std::size_t x = 0; x < std::size_t(width_); ++x) {
                const int verdict = int(word[x * words] & 7);
                for (int k = 0; k < 5; ++k) verdicts[std::size_t(k)] += verdict == k;
                evaluations += word[x * words] >> 3;
                if (words == 2) evaluations += word[x * words + 1];
            }
        };
        if (words_ == 1) {
            add(1);
        } else {
            add(2);
        }
        for (std::size_t k = 0; k < 5; ++k) tally.verdicts[k] += verdicts[k];
        tally.evaluations += std::int64_t(evaluations);
    }
    return tally;
}

} // namespace isomotion::render
