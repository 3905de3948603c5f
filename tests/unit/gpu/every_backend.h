#pragma once

#include "gpu/context.h"
#include "gpu/draw.h"
#include "gpu/program.h"
#include "gpu/target.h"

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>

#include "on_display.h"

namespace isomotion::gpu {

/// A context of one back end, or null if this machine has none.
inline std::unique_ptr<Context> open_if_available(Backend backend) {
    try {
        return Context::create(backend);
    } catch (const Unavailable&) {
        return nullptr;
    }
}

/// A test that runs once on every back end, with a context of it current.
class EveryBackend : public testing::TestWithParam<Backend> {
protected:
    void SetUp() override {
        if (GetParam() == Backend::glfw) display_.emplace();
        context = open_if_available(GetParam());
        if (!context) GTEST_SKIP() << name(GetParam()) << " is not available here";
    }

private:
    std::optional<display::OnDisplay> display_; // for longer than the context

protected:
    std::unique_ptr<Context> context;
};

inline std::string backend_name(const testing::TestParamInfo<Backend>& info) {
    return std::string(name(info.param));
}

#define ISOMOTION_ON_EVERY_BACKEND(suite)                                                          \
    INSTANTIATE_TEST_SUITE_P(Backends, suite,                                                      \
                             testing::Values(isomotion::gpu::Backend::egl,                         \
                                             isomotion::gpu::Backend::osmesa,                      \
                                             isomotion::gpu::Backend::glfw),                       \
                             isomotion::gpu::backend_name)

inline constexpr const char* fullscreen_vertex = R"(#version 330 core
void main() {
    gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0);
}
)";

/// A program of the given declarations and statements over the whole viewport.
inline Program fullscreen_program(const std::string& declarations, const std::string& body) {
    return Program(fullscreen_vertex,
                   "#version 330 core\n" + declarations + "\nvoid main() {\n" + body + "\n}\n",
                   "test");
}

/// Draws into a fresh 1 x 1 target of the current context and returns its red value.
inline float draw_one(const Program& program) {
    const Target target(1, 1);
    target.bind();
    program.use();
    Fullscreen().draw();
    return target.read(0, 0, 0, 1, 1).front();
}

} // namespace isomotion::gpu
