#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace isomotion::gpu {

enum class Kind : std::uint8_t { buffer, framebuffer, program, query, texture, vertex_array };

/// Names released while their context was not current; deleted when it is current again.
struct Discarded {
    std::vector<std::pair<Kind, unsigned>> names;
    void remove();
};

/// Owns one GL object of the context that is current at construction.
///
/// It may be destroyed at any time. Deleting a number while another context is current would delete
/// that context's object of the same number. So the deletion waits until the object's own context
/// is current, or is dropped with that context.
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
