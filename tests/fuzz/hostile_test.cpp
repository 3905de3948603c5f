// Shaders of scenes by people who mean harm: names and texts of a scene don't get into the GLSL,
// and no number of a scene makes a loop run on.
#include <algorithm>
#include <cctype>
#include <random>
#include <regex>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>

#include "fuzz/generated_glsl.h"
#include "scene/reading/load.h"
#include "shader/assemble.h"

namespace isomotion::shader {
namespace {

using Random = std::mt19937;

// Names that the scene's grammar allows, of things that GLSL, a preprocessor, or our own text know.
const std::vector<std::string> hostile_names{"main",
                                             "gl_FragColor",
                                             "gl_Position",
                                             "discard",
                                             "float",
                                             "vec3",
                                             "void",
                                             "if",
                                             "for",
                                             "while",
                                             "return",
                                             "uniform",
                                             "layout",
                                             "struct",
                                             "true",
                                             "sampler2D",
                                             "precise",
                                             "highp",
                                             "defined",
                                             "__LINE__",
                                             "__VERSION__",
                                             "GL_ES",
                                             "define",
                                             "include",
                                             "im_sin",
                                             "IM_INFINITY",
                                             "field",
                                             "field_directional",
                                             "parameters",
                                             "array0",
                                             "array0_count",
                                             "array0_texel",
                                             "parameter_block",
                                             "v1",
                                             "w2",
                                             "a0_0",
                                             "e0",
                                             "p",
                                             "d",
                                             "texel",
                                             "element",
                                             "march",
                                             "Ray",
                                             "evaluations_per_pass",
                                             "active",
                                             "half",
                                             "_",
                                             "__",
                                             "LIGHTS",
                                             "texture",
                                             "shared",
                                             "buffer",
                                             "a",
                                             "B",
                                             "clamp",
                                             "dFdx",
                                             "inverse",
                                             "double"};

const std::vector<std::string> hostile_numbers{"0",    "-0.0",         "1e-320", "5e-324", "1e-40",
                                               "1e30", "3.4028234e38", "-1e308", "1e39",   "0.1",
                                               "1e-7", "3.4028235e38", "-1",     "0.5",    "7"};

// Values go to the shader as floats.
const std::vector<std::string> hostile_values{
    "0", "-0.0", "1e-320", "5e-324", "1e-40", "1e30", "3e36", "0.1", "123456789", "-1e36", "0.5"};

struct Names {
    std::vector<std::string> parameters, fields, arrays, definitions;
};

template<class T> const T& any_of(Random& random, const std::vector<T>& all) {
    return all[random() % all.size()];
}

Names hostile(Random& random) {
    std::vector<std::string> all = hostile_names;
    std::shuffle(all.begin(), all.end(), random);
    auto at = all.begin();
    const auto take = [&](std::size_t count) {
        std::vector<std::string> taken(at, at + std::ptrdiff_t(count));
        at += std::ptrdiff_t(count);
        std::sort(taken.begin(), taken.end()); // as toml++ reads them
        return taken;
    };
    return {take(5), take(3), take(1), take(4)};
}

// The same names in kind and order, and of no meaning to anyone.
Names harmless(const Names& of) {
    const auto named = [](const char* kind, std::size_t count) {
        std::vector<std::string> names;
        for (std::size_t k = 0; k < count; ++k) names.push_back(fmt::format("{}{}", kind, k));
        return names;
    };
    return {named("quiet", of.parameters.size()), named("calm", of.fields.size()),
            named("row", of.arrays.size()), named("part", of.definitions.size())};
}

// Two scenes of one seed differ in their names only.
std::string scene_text(Random random, const Names& names) {
    const std::vector<std::string>& p = names.parameters;
    const std::vector<std::string>& f = names.fields;
    const std::vector<std::string>& d = names.definitions;
    std::string formula;
    for (std::size_t k = 0; k < d.size(); ++k) {
        formula += fmt::format("{} = {}*x^{} {} y*{};\\r\\n\\t", d[k], p[k], random() % 30,
                               random() % 2 ? "+" : "/ 7 -", any_of(random, hostile_numbers));
    }
    formula += fmt::format("sum({}, {}*exp(-((x-{})^2 + (y-{})^2 + z^2)*{}))", names.arrays[0],
                           f[0], f[1], f[2], any_of(random, hostile_numbers));
    const std::vector<std::string> functions{"sin", "exp", "sqrt", "atan", "tanh", "floor", "abs"};
    for (const std::string& definition : d) {
        formula += fmt::format(" - {}({}*{} + {})", any_of(random, functions), definition, p[4],
                               any_of(random, hostile_numbers));
    }
    std::string text =
        fmt::format("title = \"*/ #version 100 // \\\\\"\n[surface]\nformula = \"{}\"\n"
                    "bounds = {{ sphere = 2 }}\n[parameters]\n",
                    formula);
    for (const std::string& name : p) {
        text += fmt::format("{} = {}\n", name, any_of(random, hostile_values));
    }
    text += fmt::format("[arrays.{}]\ncount = {}\n", names.arrays[0], 1 + random() % 40);
    for (const std::string& name : f) {
        text += fmt::format("{} = \"i*{}\"\n", name, any_of(random, hostile_values));
    }
    const std::vector<std::string> methods{"hermite",  "amp-sign", "amp-taylor", "marching",
                                           "interval", "affine",   "sphere"};
    text += fmt::format("[isolation]\nmethod = \"{}\"\nstep = 1e-30\nlimit = 10000000\n"
                        "bisections = 64\nsafety = 1e6\nnear = 1e30\nfar = 0\nhorizon = 1e30\n"
                        "certify = {}\nbeam = {}\n",
                        any_of(random, methods), random() % 2 == 0, random() % 2 == 0);
    text += "[camera]\nposition = [5, 1, 2]\n";
    if (random() % 2) text += "[[lights]]\ndirection = [1, 1, 1]\nshadow = true\n";
    if (random() % 2) text += "[material]\nmodel = \"ggx\"\nreflection = \"self\"\n";
    if (random() % 2) {
        text += fmt::format(
            "[material.colormap]\nvalue = \"mean_curvature + {}\"\nrange = [-1, 1]\n", p[1]);
    }
    if (random() % 2) text += "[ground]\nheight = -3\n[occlusion]\nradius = 1\n";
    return text;
}

std::vector<std::string> texts(const Passes& passes) {
    std::vector<std::string> all;
    for (const Pass& pass : passes.list) {
        all.push_back(pass.vertex);
        all.push_back(pass.text);
    }
    return all;
}

std::vector<std::string> shaders_of(const std::string& text, Stage stage) {
    const scene::Scene scene = scene::load_text(text, "scene.toml");
    const std::vector<Channel> channels{Channel::depth, Channel::normal, Channel::velocity};
    return texts(assemble(scene, channels, {stage}));
}

// Random powers may leave what the GPU's numbers hold, which is a mistake of its own.
bool fits_floats(const std::string& text) {
    try {
        scene::load_text(text, "scene.toml");
        return true;
    } catch (const scene::SceneError& error) {
        if (std::string(error.what()).find("the GPU's numbers hold") == std::string::npos) throw;
        return false;
    }
}

class Hostile : public testing::TestWithParam<unsigned> {};

TEST_P(Hostile, NamesAreNotInTheShaders) {
    Random random(GetParam());
    const Names names = hostile(random);
    SCOPED_TRACE(fmt::format("seed {}\n{}", GetParam(), scene_text(random, names)));
    if (!fits_floats(scene_text(random, names))) GTEST_SKIP() << "F is beyond float32";
    for (const Stage stage : {Stage::fragment, Stage::compute}) {
        const auto evil = shaders_of(scene_text(random, names), stage);
        const auto good = shaders_of(scene_text(random, harmless(names)), stage);
        ASSERT_EQ(evil.size(), good.size());
        for (std::size_t k = 0; k < evil.size(); ++k) {
            // Names stand in comments: code is the same whatever they are.
            EXPECT_EQ(fuzz::without_comments(evil[k]), fuzz::without_comments(good[k]));
            for (const std::string& comment : fuzz::comments(evil[k])) {
                if (!comment.starts_with(" generated from:")) continue;
                // No backslash carries it over its line's end.
                EXPECT_TRUE(std::all_of(comment.begin(), comment.end(), [](char c) {
                    return ' ' <= c && c <= '~' && c != '\\';
                })) << comment;
            }
        }
    }
}

// What loops may go by: numbers written in the text, its constants, uniforms that the renderer sets
// to what it has bounded (march_plan.h, beam_pass.h), and elements, whose number plan_march()
// bounds.
const std::set<std::string> bounds{"LIGHTS",           "RAYS",        "block_pieces", "TEXELS",
                                   "MASK_WORDS",       "level",       "pieces",       "samples",
                                   "beam_evaluations", "evaluations", "array0_count"};

// A counter that goes one way to a bound.
bool is_counted(const std::string& head) {
    static const std::regex counted(
        R"(for \(int (\w+) = ([\w. +-]+); \1 (<=|<|>=) ([\w -]+?)( && \w+)?; (\+\+|--)\1\))");
    std::smatch match;
    if (!std::regex_match(head, match, counted)) return false;
    if ((match[3] == ">=") != (match[6] == "--")) return false;
    static const std::regex word(R"([A-Za-z_]\w*)");
    const std::string bound = match[4];
    return std::all_of(std::sregex_iterator(bound.begin(), bound.end(), word),
                       std::sregex_iterator(),
                       [](const auto& at) { return bounds.count(at.str()); });
}

// Those that end for a reason of their own. `turns` begins at evaluations_per_pass,
// pieces_per_pass and loses one a round; shadow.glsl's outer loop takes the next
// light each round, or breaks; `searches` ends when its turns do; `k` and `pieces` of blocks gain
// one a round; a word of a mask has 32 bits, of which each round takes one.
const std::set<std::string> other_loops{
    "while (turns > 0 && s.phase != PHASE_DONE)",
    "while (turns > 0 && s.phase < PHASE_DONE)",
    "while (turns > 0 && s.outcome == PROOF_UNFINISHED)",
    "while (turns > 0 && s.outcome == PROOF_UNFINISHED && s.at_root)",
    "while (turns > 0 && outcome == RAY_GOES_ON)",
    "while (open && k < beam_evaluations)",
    "while (open && k < block_pieces)",
    "while (open && pieces < block_pieces)",
    "while (true)",
    "while (searches)",
    "for (uint bits = listed_bits(word)"};

std::vector<std::string> loop_heads(const std::string& code) {
    static const std::regex head(R"(\b(for|while) *\([^)]*\))");
    std::vector<std::string> heads;
    for (std::sregex_iterator at(code.begin(), code.end(), head), end; at != end; ++at) {
        heads.push_back(at->str());
    }
    return heads;
}

TEST_P(Hostile, LoopsAreBounded) {
    Random random(GetParam());
    const Names names = hostile(random);
    std::string text = scene_text(random, names);
    if (GetParam() % 4 == 0) { // a polynomial, whose blocks models settle
        text = "[surface]\nformula = \"x^10 + y^7*z - 1\"\nbounds = { sphere = 2 }\n[isolation]\n"
               "certify = true\n[[lights]]\ndirection = [1, 0, 0]\nshadow = true\n";
    }
    if (!fits_floats(text)) GTEST_SKIP() << "F is beyond float32";
    int loops = 0;
    for (const std::string& shader : shaders_of(text, Stage::fragment)) {
        const std::string code = fuzz::without_comments(shader);
        for (const std::string& head : loop_heads(code)) {
            ++loops;
            EXPECT_TRUE(is_counted(head) || other_loops.count(head)) << head;
        }
        EXPECT_EQ(code.find("goto"), code.npos);
    }
    EXPECT_GT(loops, 2);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Hostile, testing::Range(1u, 41u));

TEST(HostileLoops, AreFound) {
    for (const char* endless :
         {"for (int k = 0; k < count; ++k)", "for (int k = 0; k < 9; --k)", "for (;;)",
          "for (int k = 0; k < 9; k += step)", "for (float k = 0.0; k < 9; ++k)",
          "for (int k = 0; k != 9; ++k)"}) {
        ASSERT_THAT(loop_heads(endless), testing::ElementsAre(endless));
        EXPECT_FALSE(is_counted(endless)) << endless;
    }
    EXPECT_TRUE(is_counted("for (int k = s.refinements + 1; k < LIGHTS && anything; ++k)"));
}

} // namespace
} // namespace isomotion::shader
