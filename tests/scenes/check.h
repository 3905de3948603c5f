// Checks that the pictures of a scene are as its file expects.
#pragma once

#include "gpu/context.h"
#include "scenes/expectation.h"

namespace isomotion::scenes {

// Draws and checks all that the test expects; what is not so fails the running test.
void check(const SceneFile& file, const std::string& test, gpu::Context& context);

} // namespace isomotion::scenes
