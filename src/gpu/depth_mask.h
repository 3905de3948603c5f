#pragma once

#include "gpu/target.h"

#include <functional>

namespace isomotion::gpu {

/// Which pixels of a target are drawn, in its depth buffer: early depth tests skip a fragment's
/// shader, which on software renderers no branch in it does.
class DepthMask {
public:
    /// For a target that outlives it. Throws ResourceError if the driver cannot test depth there.
    explicit DepthMask(const Target& target);

    /// Lets another target, as large, be drawn by it too.
    void serve(const Target& other) const;

    /// Sets the mask by what `draw` writes as depth, 1 to draw a pixel and 0 not to; no colour is
    /// written.
    void set(const std::function<void()>& draw) const { set(target_, draw); }
    void set(const Target& bound, const std::function<void()>& draw) const;
    /// Takes pixels away that `draw` does not discard. `draw` has no depth of its own: then it is
    /// not run where the mask has no pixel.
    void remove(const Target& bound, const std::function<void()>& draw) const;
    /// Does `draw`, whose depth is 0.5, as z = 0 gives it, on the mask's pixels.
    void apply(const std::function<void()>& draw) const { apply(target_, draw); }
    void apply(const Target& into, const std::function<void()>& draw) const;

private:
    void attach_to(const Target& target) const;

    const Target& target_;
    Texture depth_;
};

} // namespace isomotion::gpu
