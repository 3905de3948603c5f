// Divides a sequence into chunks, which workers render one at a time.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace isomotion::farm {

using Chunk = std::vector<int>; // frames, never none

struct Cut {
    std::size_t size = 20;   // largest number of frames in a chunk
    std::size_t workers = 0; // 0: unknown
    // Largest number of chunks; chunks exceed `size` if that requires it.
    std::size_t most = std::numeric_limits<std::size_t>::max();
};

// All frames in their order. Sizes differ by at most one. If there are enough frames, the number of
// chunks is a multiple of the number of workers, so that nobody waits while others render a last
// chunk.
std::vector<Chunk> chunks(std::span<const int> frames, const Cut& cut);

} // namespace isomotion::farm
