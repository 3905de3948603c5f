#pragma once

#include "gpu/name.h"
#include "gpu/target.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <span>

namespace isomotion::gpu {

/// Pixels on their way from targets to the program, through a pixel buffer of the driver's: asked
/// for at once, waited for later, while the driver draws something else.
class Transfer {
public:
    /// Throws ResourceError out of memory.
    explicit Transfer(std::size_t bytes);
    ~Transfer();
    Transfer(Transfer&&) noexcept;
    Transfer& operator=(Transfer&&) noexcept;

    /// Copies an area of an attachment, as it is after the draws so far and in the attachment's own
    /// format, to the bytes from `offset` on; returns the first byte behind them. Throws
    /// std::length_error beyond the capacity.
    std::size_t ask(const Target& from, int attachment, Rectangle area, std::size_t offset) const;
    /// Behind the last ask(): sends all of it on its way.
    void send();
    /// Waits for what was sent and shows it for as long as `use` runs. Throws ResourceError where
    /// the driver lost it.
    void read(const std::function<void(std::span<const std::byte>)>& use);

private:
    struct Fence;

    Name name_{Kind::buffer};
    std::size_t capacity_;
    std::unique_ptr<Fence> sent_;
};

} // namespace isomotion::gpu
