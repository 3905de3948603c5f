#include "gpu/rectangles.h"

#include <glad/gl.h>

#include <cstdint>
#include <vector>

namespace isomotion::gpu {

void Rectangles::set(std::span<const Rectangle> rectangles) {
    std::vector<std::uint32_t> words;
    words.reserve(2 * rectangles.size());
    const auto add = [&](int low, int high) {
        words.push_back(std::uint32_t(low) | std::uint32_t(high) << 16);
    };
    for (const Rectangle& rectangle : rectangles) {
        add(rectangle.x, rectangle.y);
        add(rectangle.width, rectangle.height);
    }
    words_.update(words);
    count_ = int(rectangles.size());
}

void Rectangles::draw() const {
    if (count_ == 0) return;
    glBindVertexArray(name_.get());
    glDrawArrays(GL_TRIANGLES, 0, 6 * count_);
}

} // namespace isomotion::gpu
