// How long a scene's shaders take to their first picture: printed, to be compared by eye.
#include <chrono>
#include <cstdio>
#include <optional>
#include <random>

#include "gpu/buffer.h"
#include "scenes.h"
#include "unit/gpu/every_backend.h"

namespace isomotion::shader {
namespace {

// Runs on whichever back end comes first: they share their compiler.
class CompileTime : public testing::Test {
protected:
    void SetUp() override {
        use_shaders_of_source_tree();
        context = gpu::open_if_available(gpu::Backend::automatic);
        if (!context) GTEST_SKIP() << "no back end is available here";
    }
    std::unique_ptr<gpu::Context> context;
};

double milliseconds(const auto& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin)
        .count();
}

// Software drivers translate to machine code at the first draw, whatever is drawn: here, rays of
// uniform blocks full of zeros.
void time_shader(const Pass& pass, const std::string& name) {
    std::optional<gpu::Program> program;
    const double compile = milliseconds([&] { program.emplace(pass.vertex, pass.text, name); });
    gpu::UniformBuffer zeros(16384);
    zeros.update(std::vector<std::byte>(16384));
    zeros.bind(0);
    for (const char* block : {"Frame", "Parameters", "Shading", "array0_block"}) {
        program->bind_block(block, 0);
    }
    program->set("evaluations_per_pass", 1);
    const gpu::Texture state(gpu::Format::rgba32f, 1, 1, std::vector<float>(4));
    state.bind(0);
    const gpu::Target target(8, 8, 2);
    target.bind();
    program->use();
    const auto draw = [&] {
        gpu::Fullscreen().draw();
        gpu::finish();
    };
    const double first = milliseconds(draw), second = milliseconds(draw);
    std::printf("%-22s %6zu lines, compile and link %7.1f ms, first draw %7.1f ms, second %5.1f "
                "ms\n",
                name.c_str(), lines_of(pass.text).size(), compile, first, second);
}

void time_scene(const scene::Scene& scene, const std::string& name) {
    Passes passes;
    const double assembling = milliseconds([&] { passes = assemble(scene); });
    std::printf("%-22s assembled in %.1f ms, %zu instructions along a ray\n", name.c_str(),
                assembling, scene.surfaces[0].field->directional.instructions.size());
    time_shader(passes.at(Role::march), name + ": march");
    time_shader(passes.at(Role::shade), name + ": shade");
}

// A formula of about `operations` operations, one in six a sine or cosine, in definitions that use
// one another.
std::string random_formula(int operations, unsigned seed) {
    std::mt19937 engine(seed);
    std::vector<std::string> terms{"x", "y", "z"};
    std::string text;
    const auto any = [&] { return terms[engine() % terms.size()]; };
    for (int made = 0; made < operations;) {
        const std::string name = fmt::format("v{}", terms.size());
        const double factor = double(engine() % 1000) / 500 - 1;
        if (engine() % 3 == 0) {
            text += fmt::format("{} = {}({}*{} - {});\n", name, engine() % 2 ? "sin" : "cos", any(),
                                factor, any());
            made += 3;
        } else { // one half of the squares, so that values stay within [-1, 1]
            text += fmt::format("{} = 0.5*({}*{} + {}*{});\n", name, any(), any(), factor, any());
            made += 4;
        }
        terms.push_back(name);
    }
    std::string sum = "x";
    for (const auto& term : terms) sum += " + " + term;
    return text + sum;
}

TEST_F(CompileTime, OfTheBlobbySurface) { time_scene(scene_of(blobs_text(75)), "75 blobs"); }

TEST_F(CompileTime, OfALongFormula) {
    constexpr unsigned seed = 2000;
    std::printf("seed %u\n", seed);
    time_scene(scene_of(surface_text(random_formula(2000, seed))), "2000 operations");
}

} // namespace
} // namespace isomotion::shader
