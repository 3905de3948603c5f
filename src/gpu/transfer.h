#pragma once

#include "gpu/name.h"
#include "gpu/target.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <span>

namespace isomotion::gpu {

/// An asynchronous transfer of pixels from targets to the program through a pixel buffer: requested
/// at once, awaited later, while the driver draws something else.
class Transfer {
public:
    /// Throws ResourceError if out of memory.
    explicit Transfer(std::size_t bytes);
    ~Transfer();
    Transfer(Transfer&&) noexcept;
    Transfer& operator=(Transfer&&) noexcept;

    /// Copies an area of an attachment, after the draws so far and in the attachment's own format,
    /// to the bytes from `offset` on. Returns the end of these bytes. Throws std::length_error
    /// beyond the capacity.
    std::size_t ask(const Target& from, int attachment, Rectangle area, std::size_t offset) const;
    /// Starts the transfer, after the last ask().
    void send();
    /// Waits for the transfer and passes the bytes to `use`; they are valid only during that call.
    /// Throws ResourceError if the driver lost them.
    void read(const std::function<void(std::span<const std::byte>)>& use);

private:
    struct Fence;

    Name name_{Kind::buffer};
    std::size_t capacity_;
    std::unique_ptr<Fence> sent_;
};

} // namespace isomotion::gpu
