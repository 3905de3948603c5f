// A sequence cut into chunks, what a worker renders at a time.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace isomotion::farm {

using Chunk = std::vector<int>; // frames, never none

struct Cut {
    std::size_t size = 20;   // frames of a chunk, at most
    std::size_t workers = 0; // 0: nobody knows how many there will be
    // Chunks, at most; they grow beyond `size` where it takes that.
    std::size_t most = std::numeric_limits<std::size_t>::max();
};

// All frames in their order. Sizes differ by one at most, and the chunks' number is a multiple of
// the workers' where there are frames enough: nobody waits while others render a last chunk.
std::vector<Chunk> chunks(std::span<const int> frames, const Cut& cut);

} // namespace isomotion::farm
