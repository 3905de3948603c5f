#pragma once

#include "gpu/target.h"

#include <functional>

namespace isomotion::gpu {

/// Where a target's pixels are drawn, by its depth buffer: early depth tests skip a fragment's
/// shader, which on software renderers no branch in it does.
class Gate {
public:
    /// Of a target that outlives it. Throws ResourceError if the driver cannot test depth there.
    explicit Gate(const Target& target);

    /// Draws into another target, as large, can go through it too.
    void serve(const Target& other) const;

    /// `draw` writes depth and no colour: 1 opens a pixel, 0 closes it.
    void set(const std::function<void()>& draw) const { set(target_, draw); }
    void set(const Target& bound, const std::function<void()>& draw) const;
    /// Closes pixels, of those that are open, which `draw` does not discard. It has no depth of its
    /// own: then it is not run where the gate is closed.
    void close(const Target& bound, const std::function<void()>& draw) const;
    /// `draw`, whose depth is 0.5, as z = 0 gives it, is done where the gate is open.
    void through(const std::function<void()>& draw) const { through(target_, draw); }
    void through(const Target& into, const std::function<void()>& draw) const;

private:
    void attach_to(const Target& target) const;

    const Target& target_;
    Texture depth_;
};

} // namespace isomotion::gpu
