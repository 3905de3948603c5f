// Assembled shaders compile: on every back end, without `precise`, and in the reference compiler.
#include <cstdio>

#include "gpu/compute.h"
#include "scene/method.h"
#include "scenes.h"
#include "thorough.h"
#include "unit/gpu/every_backend.h"

namespace isomotion::shader {
namespace {

constexpr const char* all_operations =
    "sum(blobs, cx*min(x, cy)) + sqrt(x)/y + exp(x)^y + log(abs(x)) + sin(x)*cos(y) + tan(z) + "
    "asin(x) - acos(y)*atan(z) + sinh(x) - max(cosh(y), tanh(z)) + sign(x)*floor(y) + "
    "chebyshev(30, x) - x^30 + atan2(y, x)*cos(2*atan2(y, z)) + asinh(x)*acosh(y) - erf(x)*cbrt(y)";

constexpr const char* two_arrays = "[arrays.blobs]\ncount = 5\ncx = 'i'\ncy = 1\n"
                                   "[arrays.links]\ncount = 3000\npx = 'i'\n";

struct Text {
    std::string name, text;
};

// Every text that methods, bounds and channels give rise to.
std::vector<Text> fragment_texts() {
    std::vector<Text> all;
    std::set<std::string> seen;
    const auto add = [&](const std::string& name, const Passes& passes) {
        for (const Role role : {Role::march, Role::active, Role::shade}) {
            const std::string& text = text_of(passes, role);
            if (seen.insert(text).second) all.push_back({name, text});
        }
    };
    const std::string formula = std::string(all_operations) + " - sum(links, px*z)";
    for (const auto& [method, bounds] : pairs_of(every_method, every_bounds)) {
        const auto scene = scene_of(surface_text(formula, bounds, method) + two_arrays);
        add(method + " in " + bounds, assemble(scene, every_channel));
    }
    constexpr const char* knife = "[[sections]]\nnormal = [1, 0, 't']\n[[sections]]\nsphere = 1\n";
    constexpr const char* lines = "[material]\ncap_color = [1, 0, 0]\n[material.contours]\n"
                                  "value = 'sum(links, px*z) + t'\nevery = 1\n";
    for (const auto& method : every_method) {
        const auto cut =
            scene_of(surface_text(formula, every_bounds[0], method) + two_arrays + knife + lines);
        add(method + ", cut", assemble(cut, {Channel::position, Channel::cap}));
    }
    const auto scene = scene_of(surface_text("x"));
    add("no channels", assemble(scene));
    for (const auto& paint : every_paint) {
        add(paint, assemble(scene_of(surface_text(formula) + two_arrays + paint)));
        add("long, " + paint, assemble(scene_of(surface_text(long_formula()) + paint)));
    }
    // Over the list of a cell, and over all elements.
    const std::string term = "exp(-20*((x-cx)^2 + (y-cy)^2 + (z-cz)^2))";
    for (const std::string& weight : {term, std::string("x*cx")}) {
        const std::string color =
            fmt::format("[material]\ncolor = ['sum(blobs, {}*cx)', 0, 0]\n", weight);
        add(color, assemble(scene_of(blobs_text(900, every_bounds[0], "hermite") + color)));
    }
    for (const Channel channel : every_channel) {
        add(fmt::format("channel {}", int(channel)), assemble(scene, {channel}));
    }
    for (const auto& glass : every_glass) {
        const Passes passes = assemble(scene_of(surface_text(formula) + two_arrays + glass));
        for (const Pass& pass : passes.list) {
            if (seen.insert(pass.text).second) all.push_back({glass + pass.name, pass.text});
        }
    }
    return all;
}

std::string vertex_text() { return assemble(scene_of(surface_text("x"))).at(Role::march).vertex; }

// The text for a driver without GLSL 4.00 and without GL_ARB_gpu_shader5.
std::string without_precise(std::string text) {
    for (const char* line :
         {"#extension GL_ARB_gpu_shader5 : enable\n", "#ifndef GL_ARB_gpu_shader5\n", "#endif\n"}) {
        const std::size_t at = text.find(line);
        if (at == text.npos) throw std::logic_error(std::string("the prelude has no ") + line);
        text.erase(at, std::string(line).size());
    }
    return text;
}

class Compile : public gpu::EveryBackend {
protected:
    static void SetUpTestSuite() { use_shaders_of_source_tree(); }
};
ISOMOTION_ON_EVERY_BACKEND(Compile);

TEST_P(Compile, EveryAssembly) {
    for (const auto& [name, text] : fragment_texts()) {
        EXPECT_NO_THROW(gpu::Program(vertex_text(), text, name)) << name;
    }
}

TEST_P(Compile, ComputeShadersOfRays) {
    if (!gpu::has_compute(context->info())) GTEST_SKIP() << context->info().version;
    const std::string formula = std::string(all_operations) + " - sum(links, px*z)";
    const std::string effects =
        "[material]\nreflection = 'self'\n[[lights]]\ndirection = [1, 2, 3]\nshadow = true\n";
    for (const auto& method : every_method) {
        for (const auto& bounds : every_bounds) {
            const auto scene =
                scene_of(surface_text(formula, bounds, method) + two_arrays + effects);
            const Passes passes = assemble(scene, {}, {Stage::compute});
            for (const Role role : {Role::march, Role::mirror, Role::shadow}) {
                EXPECT_NO_THROW(gpu::Program::compute(text_of(passes, role), method))
                    << method << " in " << bounds;
            }
        }
    }
    const auto scene = scene_of(surface_text(long_formula()));
    const Passes passes = assemble(scene, {}, {Stage::compute});
    EXPECT_TRUE(passes.march_takes_gradient);
    EXPECT_NO_THROW(gpu::Program::compute(text_of(passes, Role::march), "long"));
}

// By intervals, by models, and with lists of elements.
TEST_P(Compile, ComputeShadersOfBeams) {
    if (!gpu::has_compute(context->info())) GTEST_SKIP() << context->info().version;
    for (const auto& bounds : every_bounds) {
        const std::string polynomial = surface_text("x^3 + y^2*z - 1", bounds, "hermite");
        for (const std::string& text :
             {polynomial + "beam = true\n", polynomial + "beam = true\ncertify = true\n",
              blobs_text(75, bounds, "hermite")}) {
            const Passes passes = assemble(scene_of(text), {}, {Stage::compute});
            EXPECT_GE(passes.beams.size(), 2U);
            for (const Pass& pass : passes.list) {
                if (pass.role != Role::beams) continue;
                EXPECT_EQ(pass.stage, Stage::compute);
                EXPECT_NO_THROW(gpu::Program::compute(pass.text, pass.name)) << bounds;
            }
        }
    }
}

TEST_P(Compile, WithoutPrecise) {
    for (const auto& [name, text] : fragment_texts()) {
        EXPECT_NO_THROW(gpu::Program(vertex_text(), without_precise(text), name)) << name;
    }
}

// glslang is the compiler of the specification's authors: stricter than drivers.
class CompileWithGlslang : public testing::Test {
protected:
    void SetUp() override {
        if (std::system("command -v glslangValidator >/dev/null") != 0) {
            GTEST_SKIP() << "glslangValidator is not on PATH";
        }
        use_shaders_of_source_tree();
    }
    ~CompileWithGlslang() override { std::filesystem::remove_all(folder_); }

    void add(const std::string& text, const char* stage) {
        std::ofstream(folder_ / fmt::format("{}.{}", count_++, stage)) << text;
    }
    // One process reads all texts, since glslang takes longer to begin than to read one.
    void expect_valid() const {
        EXPECT_GT(count_, 0);
        const auto command = fmt::format("cd '{}' && glslangValidator *", folder_.string());
        if (std::system(command.c_str()) == 0) return;
        ADD_FAILURE() << "glslang refuses some of " << count_ << " shaders";
        for (const auto& file : std::filesystem::directory_iterator(folder_)) {
            const auto alone = fmt::format("glslangValidator '{}'", file.path().string());
            EXPECT_EQ(std::system(alone.c_str()), 0) << std::ifstream(file.path()).rdbuf();
        }
    }

private:
    static std::filesystem::path new_folder() {
        const auto folder =
            std::filesystem::temp_directory_path() / fmt::format("isomotion-glslang-{}", getpid());
        std::filesystem::create_directory(folder);
        return folder;
    }
    const std::filesystem::path folder_ = new_folder();
    int count_ = 0;
};

TEST_F(CompileWithGlslang, EveryAssembly) {
    // It knows `precise` from version 4.00 on only.
    const auto as_450 = [](const std::string& text) {
        constexpr std::string_view old_version = "#version 330 core";
        EXPECT_TRUE(text.starts_with(old_version));
        return "#version 450 core" + text.substr(old_version.size());
    };
    add(as_450(vertex_text()), "vert");
    for (const auto& [name, text] : fragment_texts()) add(as_450(text), "frag");
    expect_valid();
}

TEST_F(CompileWithGlslang, EveryPassOfSeveralSurfacesAndGlass) {
    std::set<std::string> seen;
    const auto add_passes = [&](const scene::Scene& scene, const std::vector<Channel>& channels) {
        for (std::size_t k = 0; k < scene.surfaces.size(); ++k) {
            for (const Pass& pass : assemble(scene::OneSurface(scene, k), channels, on_page).list) {
                if (seen.insert(pass.text).second) add(pass.text, "frag");
            }
        }
    };
    for (const auto& channels : {std::vector<Channel>{}, every_channel}) {
        add_passes(two_plain_surfaces("0.5"), channels);
        add_passes(scene_of(glass_among_others("0.5")), channels);
        for (const auto& glass : every_glass)
            add_passes(scene_of(surface_text("x^2 + y^2 - z", every_bounds[1], "hermite") + glass),
                       channels);
    }
    expect_valid();
}

TEST_F(CompileWithGlslang, EveryPassOfBrowsers) {
    std::set<std::string> seen;
    const auto add_passes = [&](const std::string& text) {
        Drawing drawing = on_page;
        for (const bool branches : {false, true}) { // where a processor draws, and on a card
            drawing.branches = branches;
            for (const Pass& pass : assemble(scene_of(text), {}, drawing).list) {
                if (seen.insert(pass.vertex).second) add(pass.vertex, "vert");
                if (!seen.insert(pass.text).second) continue;
                // WebGL has a choice of numbers and vectors alone.
                EXPECT_EQ(occurrences(pass.text, "? finish("), 0) << pass.name;
                EXPECT_EQ(occurrences(pass.text, "? Lists("), 0) << pass.name;
                add(pass.text, "frag");
            }
        }
    };
    const std::string formula = std::string(all_operations) + " - sum(links, px*z)";
    for (const auto& [method, bounds] : pairs_of(every_method, every_bounds))
        add_passes(surface_text(formula, bounds, method) + two_arrays);
    add_passes(surface_text("(x^2 + y^2 - z)^2", every_bounds[0], "hermite"));
    for (const int elements : {9, 32, 33, 128, 129})
        add_passes(blobs_text(elements, every_bounds[1], "hermite"));
    for (const auto& effect : every_effect) {
        add_passes(blobs_text(70, every_bounds[0], "hermite") + effect);
    }
    for (const auto& paint : every_paint) add_passes(surface_text(long_formula()) + paint);
    expect_valid();
}

} // namespace
} // namespace isomotion::shader
