#include "farm/chunks.h"

#include <algorithm>

namespace isomotion::farm {

std::vector<Chunk> chunks(std::span<const int> frames, const Cut& cut) {
    const auto parts = [](std::size_t whole, std::size_t size) {
        return (whole + size - 1) / size;
    };
    const std::size_t workers = std::max<std::size_t>(cut.workers, 1);
    const std::size_t enough =
        workers * parts(parts(frames.size(), std::max<std::size_t>(cut.size, 1)), workers);
    const std::size_t number = std::min({enough, frames.size(), cut.most});
    std::vector<Chunk> all;
    all.reserve(number);
    for (std::size_t k = 0, begin = 0; k < number; ++k) {
        const std::size_t end = begin + (frames.size() - begin) / (number - k);
        all.emplace_back(frames.begin() + std::ptrdiff_t(begin),
                         frames.begin() + std::ptrdiff_t(end));
        begin = end;
    }
    return all;
}

} // namespace isomotion::farm
