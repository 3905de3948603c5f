#pragma once

#include "gpu/target.h"

#include <functional>

namespace isomotion::gpu {

/// Masks the pixels of a target by its depth buffer. Early depth tests skip a fragment's shader; on
/// software renderers no branch in the shader saves its cost.
class DepthMask {
public:
    /// The target must outlive it. Throws ResourceError if the driver cannot test depth there.
    explicit DepthMask(const Target& target);

    /// Applies the mask to another target of the same size, too.
    void serve(const Target& other) const;

    /// Sets the mask to the depth that `draw` writes: 1 to draw a pixel, 0 not to. No colour is
    /// written.
    void set(const std::function<void()>& draw) const { set(target_, draw); }
    void set(const Target& bound, const std::function<void()>& draw) const;
    /// The same, and `draw` writes colours, too.
    void set_and_paint(const Target& bound, const std::function<void()>& draw) const;
    /// Runs `draw` on the mask's pixels. Its depth must be 0.5, which z = 0 gives.
    void apply(const std::function<void()>& draw) const { apply(target_, draw); }
    void apply(const Target& into, const std::function<void()>& draw) const;

private:
    void attach_to(const Target& target) const;

    const Target& target_;
    Texture depth_;
};

} // namespace isomotion::gpu
