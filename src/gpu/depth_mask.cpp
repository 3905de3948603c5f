#include "gpu/depth_mask.h"

#include "gpu/error.h"

#include <fmt/format.h>
#include <glad/gl.h>

namespace isomotion::gpu {
namespace {

/// Tests depth for as long as it lives.
class Testing {
public:
    Testing(GLenum passes, bool writes) {
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(passes);
        glDepthMask(GLboolean(writes));
    }
    ~Testing() { glDisable(GL_DEPTH_TEST); }
    Testing(const Testing&) = delete;
    Testing& operator=(const Testing&) = delete;
};

class Colorless {
public:
    Colorless() { glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE); }
    ~Colorless() { glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE); }
    Colorless(const Colorless&) = delete;
    Colorless& operator=(const Colorless&) = delete;
};

} // namespace

DepthMask::DepthMask(const Target& target)
    : target_(target)
    , depth_(Format::depth16, target.width(), target.height()) {
    attach_to(target);
}

void DepthMask::serve(const Target& other) const { attach_to(other); }

void DepthMask::attach_to(const Target& target) const {
    forget_errors();
    glBindFramebuffer(GL_FRAMEBUFFER, target.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_.id(), 0);
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    const auto what =
        fmt::format("the depth of a target of {} x {} pixels", target.width(), target.height());
    expect_success(what);
    if (status != GL_FRAMEBUFFER_COMPLETE)
        throw ResourceError(fmt::format("{}: incomplete ({:#06x})", what, status));
}

void DepthMask::set(const Target& bound, const std::function<void()>& draw) const {
    bound.bind();
    const Testing always(GL_ALWAYS, true);
    const Colorless depth_alone;
    draw();
}

void DepthMask::set_and_paint(const Target& bound, const std::function<void()>& draw) const {
    bound.bind();
    const Testing always(GL_ALWAYS, true);
    draw();
}

void DepthMask::apply(const Target& into, const std::function<void()>& draw) const {
    into.bind();
    const Testing masked(GL_LESS, false);
    draw();
}

} // namespace isomotion::gpu
