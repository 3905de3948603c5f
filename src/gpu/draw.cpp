#include "gpu/draw.h"

#include <glad/gl.h>

namespace isomotion::gpu {

void set_viewport(Rectangle area) { glViewport(area.x, area.y, area.width, area.height); }

Scissor::Scissor(Rectangle area) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(area.x, area.y, area.width, area.height);
}

Scissor::~Scissor() { glDisable(GL_SCISSOR_TEST); }

void Fullscreen::draw() const {
    glBindVertexArray(name_.get());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void finish() { glFinish(); }

} // namespace isomotion::gpu
