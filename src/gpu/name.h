#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace isomotion::gpu {

enum class Kind : std::uint8_t { buffer, framebuffer, program, query, texture, vertex_array };

/// Names given up while their context was not current; removed when it is again.
struct Discarded {
    std::vector<std::pair<Kind, unsigned>> names;
    void remove();
};

/// Owns one GL object of the context that is current when it is made.
///
/// It may die at any time: a number deleted while another context is current would delete that
/// context's object of the same number, so it waits for its own context, or is gone with it.
class Name {
public:
    explicit Name(Kind kind);
    Name(Name&& other) noexcept;
    Name& operator=(Name&& other) noexcept;
    ~Name();

    unsigned get() const noexcept { return number_; }

private:
    std::weak_ptr<Discarded> context_;
    unsigned number_ = 0;
    Kind kind_;
};

} // namespace isomotion::gpu
