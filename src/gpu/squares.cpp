#include "gpu/squares.h"

#include <glad/gl.h>

#include <cstdint>
#include <vector>

namespace isomotion::gpu {

void Squares::set(std::span<const Square> squares) {
    std::vector<std::uint32_t> words;
    words.reserve(squares.size());
    for (const auto& [x, y, side] : squares)
        words.push_back(std::uint32_t(x / 8) | std::uint32_t(y / 8) << 14 |
                        std::uint32_t(side / 8) << 28);
    words_.update(words);
    count_ = int(squares.size());
}

void Squares::draw() const {
    if (count_ == 0) return;
    glBindVertexArray(name_.get());
    glEnable(GL_PROGRAM_POINT_SIZE);
    glDrawArrays(GL_POINTS, 0, count_);
    glDisable(GL_PROGRAM_POINT_SIZE);
}

} // namespace isomotion::gpu
