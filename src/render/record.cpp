#include "render/record.h"

#include <algorithm>
#include <numeric>

namespace isomotion::render {

std::int64_t Tally::ended() const {
    return std::accumulate(verdicts.begin(), verdicts.end(), std::int64_t(0));
}

RayCounts in_picture(RayCounts of_tile, const gpu::Rectangle& tile, int picture_height) {
    for (RayCount& count : of_tile) {
        count.column += tile.x;
        count.row = picture_height - 1 - (tile.y + count.row);
    }
    return of_tile;
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
        std::uint64_t eye = 0, most_of_eye = 0;
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
                eye += packed >> 3;
                most_of_eye = std::max<std::uint64_t>(most_of_eye, packed >> 3);
            }
        };
        if (words_ == 1) {
            add(1);
        } else {
            add(4);
            add_further(y, tally.rays);
        }
        const std::int64_t ended = std::int64_t(width_) - all;
        const std::array<std::int64_t, 4> numbers{first - both, second - both, both - all,
                                                  third - all};
        tally.verdicts[0] += ended - numbers[0] - numbers[1] - numbers[2] - numbers[3];
        for (std::size_t k = 0; k < 4; ++k) tally.verdicts[k + 1] += numbers[k];
        RayCount& of_eye = tally.rays[std::size_t(RayKind::eye)];
        of_eye.evaluations += std::int64_t(eye);
        of_eye.most = std::max(of_eye.most, std::int64_t(most_of_eye));
    }
    RayCount& eye = tally.rays[std::size_t(RayKind::eye)];
    eye.undecided = tally.verdicts[std::size_t(Verdict::step_limit)] +
                    tally.verdicts[std::size_t(Verdict::nan)];
    if (eye.undecided > 0) place_undecided(eye);
    return tally;
}

void Record::place_undecided(RayCount& eye) const {
    for (int pixel = 0; pixel < width_ * height_; ++pixel) {
        const auto ended = Verdict(verdict(std::size_t(pixel)));
        if (ended != Verdict::step_limit && ended != Verdict::nan) continue;
        eye.column = pixel % width_;
        eye.row = pixel / width_;
        return;
    }
}

void Record::add_further(int row, RayCounts& to) const {
    for (int x = 0; x < width_; ++x) {
        const auto add = [&](RayCount& count, std::uint32_t evaluations, std::uint32_t undecided) {
            if (count.undecided == 0 && undecided > 0) {
                count.column = x;
                count.row = row;
            }
            count.evaluations += evaluations;
            count.most = std::max<std::int64_t>(count.most, evaluations);
            count.undecided += undecided;
        };
        const std::uint32_t* word =
            packed_.data() + (std::size_t(row) * std::size_t(width_) + std::size_t(x)) * words_;
        add(to[std::size_t(RayKind::shadow)], word[1], word[3] & 255);
        add(to[std::size_t(RayKind::path)], word[2], word[3] >> 8 & 255);
        add(to[std::size_t(RayKind::occlusion)], word[3] >> 16, 0);
    }
}

} // namespace isomotion::render
