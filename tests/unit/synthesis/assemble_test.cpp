// What the assembled text depends on, and what it does not.
#include <gmock/gmock.h>

#include "formula/glsl/glsl.h"
#include "scenes.h"
#include "synthesis/shader_files.h"

namespace isomotion::synthesis {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class Assemble : public testing::Test {
protected:
    static void SetUpTestSuite() { use_shaders_of_source_tree(); }
};

void expect_same_text(const Shaders& a, const Shaders& b) {
    EXPECT_EQ(a.vertex, b.vertex);
    EXPECT_EQ(a.march, b.march);
    EXPECT_EQ(a.active, b.active);
    EXPECT_EQ(a.shade, b.shade);
}

// Everything in a scene that is a value, twice.
constexpr const char* one_set_of_values = R"(
[time]
fps = 30
frames = 10
[surface]
formula = "sum(blobs, w*exp(-k*((x-cx)^2 + (y-cy)^2 + z^2))) - a*b"
bounds = { sphere = 2 }
[parameters]
a = 1
b = "2 + t"
[arrays.blobs]
count = 5
cx = "i/n"
cy = [1, 2, 3, 4, 5]
k = 3
w = 1
[material]
color = [1, 0, 0]
)";

constexpr const char* another_set_of_values = R"(
[time]
fps = "24000/1001"
frames = 500
seed = 7
[surface]
formula = "sum(blobs, w*exp(-k*((x-cx)^2 + (y-cy)^2 + z^2))) - a*b"
bounds = { sphere = "3 + t", centre = [1, 2, 3] }
transform = { translate = [5, 0, "t"], rotate = [0, 30, 0], scale = 1000 }
[parameters]
a = { keys = [[0, 0.0], [2, 3.1]], ease = "smooth" }
b = -1e-20
[arrays.blobs]
count = 5
cx = 'random(i, 0)'
cy = 'cos(t*i)'
k = 9
w = 4
[isolation]
method = "hermite"
step = 0.5
near = 0.1
far = 0.2
horizon = 0.3
bisections = 3
[camera]
position = [9, 8, 7]
fov = 10
[[lights]]
direction = [0, 0, 1]
color = [0.1, 0.2, 0.3]
[material]
color = ["t", 1, 0]
[output]
size = [77, 33]
)";

TEST_F(Assemble, NoValueIsInTheText) {
    expect_same_text(assemble(scene_of(one_set_of_values), every_channel),
                     assemble(scene_of(another_set_of_values), every_channel));
}

TEST_F(Assemble, TheSameSceneGivesTheSameText) {
    expect_same_text(assemble(scene_of(one_set_of_values)), assemble(scene_of(one_set_of_values)));
}

TEST_F(Assemble, WithoutChannelsThereIsNoLineOfOne) {
    const Shaders plain = assemble(scene_of(surface_text("x")));
    for (const auto& name : shader_files()) {
        if (!name.starts_with("channels/")) continue;
        EXPECT_THAT(plain.shade + plain.march, Not(HasSubstr(name)));
        std::istringstream lines(read_shader(name));
        for (std::string line; std::getline(lines, line);) {
            if (line.empty() || line == "}") continue;
            EXPECT_THAT(plain.shade + plain.march + plain.active, Not(HasSubstr(line)));
        }
    }
    EXPECT_THAT(plain.attachments, IsEmpty());
}

TEST_F(Assemble, AChannelAddsItsOwnFileADefineAndACall) {
    const scene::Scene scene = scene_of(surface_text("x"));
    const Shaders plain = assemble(scene), with_depth = assemble(scene, {Channel::depth});
    EXPECT_EQ(with_depth.march, plain.march);
    EXPECT_EQ(with_depth.active, plain.active);
    EXPECT_EQ(with_depth.vertex, plain.vertex);
    EXPECT_THAT(without(lines_of(plain.shade), lines_of(with_depth.shade)), IsEmpty());
    Lines expected = lines_of(read_shader("channels/depth.glsl"));
    expected.insert({"", "// shaders/channels/depth.glsl", "#define DEPTH_LOCATION 2",
                     "    write_depth(ray, hit, verdict);"});
    EXPECT_EQ(without(lines_of(with_depth.shade), lines_of(plain.shade)), expected);
}

// Attachments are numbered without gaps, whatever is asked for in whatever order.
TEST_F(Assemble, ChannelsTakeTheNextAttachment) {
    const scene::Scene scene = scene_of(surface_text("x"));
    const Shaders two = assemble(scene, {Channel::position, Channel::normal});
    EXPECT_EQ(two.attachments, (std::vector{Channel::normal, Channel::position}));
    EXPECT_THAT(two.shade, HasSubstr("#define NORMAL_LOCATION 2\n"));
    EXPECT_THAT(two.shade, HasSubstr("#define POSITION_LOCATION 3\n"));
    EXPECT_THAT(two.shade, Not(HasSubstr("DEPTH_LOCATION")));
    expect_same_text(two, assemble(scene, {Channel::normal, Channel::position, Channel::normal}));
    // These two are in every picture's record.
    expect_same_text(assemble(scene), assemble(scene, {Channel::verdict, Channel::evaluations}));
}

TEST_F(Assemble, TheMethodChangesTheMarchAlone) {
    std::set<std::string> marches;
    std::vector<Shaders> all;
    for (const auto& method : every_method) {
        all.push_back(assemble(scene_of(surface_text("x*y", every_bounds[0], method))));
        marches.insert(all.back().march);
        EXPECT_EQ(all.back().shade, all.front().shade);
        EXPECT_EQ(all.back().active, all.front().active);
    }
    EXPECT_EQ(marches.size(), every_method.size());
    // Uniform steps with a sign test pay for no derivative.
    EXPECT_THAT(all[0].march, Not(HasSubstr("field_along")));
    EXPECT_THAT(all[0].march, HasSubstr("float field(vec3 p)"));
    // The two adaptive methods differ by one file.
    Lines taylor = lines_of(read_shader("march/taylor_test.glsl"));
    taylor.insert("// shaders/march/taylor_test.glsl");
    const Lines more = without(lines_of(all[2].march), lines_of(all[1].march));
    EXPECT_THAT(without(more, taylor), IsEmpty());
}

TEST_F(Assemble, TheBoundsShapeChangesOneFile) {
    const Shaders sphere = assemble(scene_of(surface_text("x", every_bounds[0])), every_channel);
    const Shaders box = assemble(scene_of(surface_text("x", every_bounds[1])), every_channel);
    Lines clip_box = lines_of(read_shader("march/clip_box.glsl"));
    clip_box.insert("// shaders/march/clip_box.glsl");
    Lines clip_sphere = lines_of(read_shader("march/clip_sphere.glsl"));
    clip_sphere.insert("// shaders/march/clip_sphere.glsl");
    for (const auto& text : {&Shaders::march, &Shaders::shade}) {
        const Lines b = lines_of(box.*text), s = lines_of(sphere.*text);
        EXPECT_EQ(without(b, s), without(clip_box, clip_sphere));
        EXPECT_EQ(without(s, b), without(clip_sphere, clip_box));
    }
    EXPECT_EQ(box.active, sphere.active);
}

// Proofs are shaders of their own: others only tell them where rays ended, as they tell a channel.
TEST_F(Assemble, ProofsAddAChannelToThePictureAndChangeNoOtherShader) {
    for (const auto& bounds : every_bounds) {
        const std::string text = surface_text("x*y - 1", bounds);
        const Shaders plain = assemble(scene_of(text), every_channel);
        const Shaders proving = assemble(scene_of(text + "certify = true\n"), every_channel);
        EXPECT_EQ(proving.march, plain.march);
        EXPECT_EQ(proving.active, plain.active);
        EXPECT_EQ(proving.vertex, plain.vertex);
        Lines ending = lines_of(read_shader("channels/ending.glsl"));
        ending.insert({"", "// shaders/channels/ending.glsl", "#define ENDING_LOCATION 5",
                       "    write_ending(ray, hit, verdict);"});
        for (const auto part : {&Shaders::shade, &Shaders::whole}) {
            EXPECT_THAT(without(lines_of(plain.*part), lines_of(proving.*part)), IsEmpty());
            EXPECT_EQ(without(lines_of(proving.*part), lines_of(plain.*part)), ending);
        }
        EXPECT_EQ(proving.attachments.size(), plain.attachments.size() + 1);
        ASSERT_EQ(plain.beams.size(), proving.beams.size());
        for (std::size_t k = 0; k < plain.beams.size(); ++k) {
            EXPECT_EQ(plain.beams[k].text, proving.beams[k].text);
        }
        EXPECT_THAT(plain.block_proof + plain.begin_proof + plain.proof + plain.sharp_proof +
                        plain.double_proof,
                    IsEmpty());
        EXPECT_THAT(proving.proof, HasSubstr("proof/prove.glsl"));
        for (const auto& name : plain.files) EXPECT_FALSE(name.starts_with("proof/")) << name;
    }
}

TEST_F(Assemble, ASumStaysOneLoopAndOneSizeOfText) {
    const Shaders few = assemble(scene_of(blobs_text(75)));
    const Shaders many = assemble(scene_of(blobs_text(5000)));
    for (const auto& text : {&Shaders::march, &Shaders::shade}) {
        EXPECT_EQ(occurrences(few.*text, "for (int e0"), 1);
        EXPECT_EQ(occurrences(few.*text, "array0_texel("), 2) << "its definition and one call";
        const Lines f = lines_of(few.*text), m = lines_of(many.*text);
        EXPECT_EQ(without(f, m),
                  (Lines{"layout(std140) uniform array0_block { vec4 array0[75]; };",
                         "vec4 array0_texel(int element, int texel) { return array0[element]; }"}));
        EXPECT_EQ(without(m, f), (Lines{"uniform samplerBuffer array0;",
                                        "vec4 array0_texel(int element, int texel) { return "
                                        "texelFetch(array0, element); }"}));
    }
}

TEST_F(Assemble, AFieldIsCalledFromOnePlace) {
    const Shaders shaders = assemble(scene_of(surface_text("x*y - 1")), every_channel);
    EXPECT_EQ(occurrences(shaders.march, "field_along("), 2) << "its definition and one call";
    EXPECT_EQ(occurrences(shaders.march, "sample_field("), 2);
    for (const char* method : {"interval", "affine", "sphere"}) {
        const Shaders on_pieces =
            assemble(scene_of(surface_text("x*y - 1", every_bounds[0], method)), every_channel);
        EXPECT_EQ(occurrences(on_pieces.march, "field_along_interval("), 2);
        EXPECT_EQ(occurrences(on_pieces.march, " field("), 2);
    }
    EXPECT_EQ(occurrences(shaders.shade, "field_gradient("), 2);
}

TEST_F(Assemble, ArraysAreStoredWhereTheyFit) {
    const auto storage = [](int count) { return assemble(scene_of(blobs_text(count))).arrays[0]; };
    // Three fields take one texel of 16 bytes, and a block has 16 kB.
    EXPECT_EQ(storage(1024).kind, ArrayStorage::Kind::uniform_block);
    EXPECT_EQ(storage(1025).kind, ArrayStorage::Kind::texture_buffer);
    EXPECT_EQ(storage(1025).capacity, 1025);
    EXPECT_EQ(storage(1).texels, 1);
}

TEST_F(Assemble, EachFileAppearsOnce) {
    const auto* all_kernels = "sqrt(x)/y + exp(x)^y + log(x) + sin(x) + tan(y) + asin(x) + tanh(x)";
    for (const auto& method : every_method) {
        for (const auto& bounds : every_bounds) {
            const Shaders shaders =
                assemble(scene_of(surface_text(all_kernels, bounds, method)), every_channel);
            const std::set<std::string> names(shaders.files.begin(), shaders.files.end());
            EXPECT_EQ(names.size(), shaders.files.size());
            for (const auto& text : {&Shaders::march, &Shaders::active, &Shaders::shade}) {
                EXPECT_TRUE((shaders.*text).starts_with("#version "));
                EXPECT_EQ(occurrences(shaders.*text, "#version"), 1);
                for (const auto& name : names) {
                    EXPECT_LE(occurrences(shaders.*text, "// shaders/" + name + "\n"), 1) << name;
                }
            }
        }
    }
}

TEST_F(Assemble, EveryShaderFileIsUsedBySomeScene) {
    std::set<std::string> used;
    const auto* all_kernels = "sqrt(x)/y + exp(x)^y + log(x) + sin(x) + asin(x) + chebyshev(5, x)";
    for (const auto& method : every_method) {
        for (const auto& bounds : every_bounds) {
            const Shaders shaders =
                assemble(scene_of(surface_text(all_kernels, bounds, method)), every_channel);
            used.insert(shaders.files.begin(), shaders.files.end());
        }
    }
    const Shaders of_shadows = assemble(scene_of(surface_text("x", every_bounds[0], "hermite") +
                                                 "[[lights]]\ndirection = [1, 1, 1]\n"
                                                 "shadow = true\n"));
    used.insert(of_shadows.files.begin(), of_shadows.files.end());
    const Shaders of_long = assemble(scene_of(surface_text(long_formula())));
    used.insert(of_long.files.begin(), of_long.files.end());
    const Shaders of_sides =
        assemble(scene_of(surface_text("x") + "[material]\nback_color = [1, 1, 1]\n"));
    used.insert(of_sides.files.begin(), of_sides.files.end());
    for (const auto& paint : every_paint) {
        const Shaders painted = assemble(scene_of(surface_text("x") + paint));
        used.insert(painted.files.begin(), painted.files.end());
    }
    for (const auto& effects : every_effect) {
        const Shaders called = assemble(scene_of(surface_text("x") + effects), {Channel::velocity});
        used.insert(called.files.begin(), called.files.end());
    }
    std::vector<std::string> texts{surface_text("x^3 - y", every_bounds[0], "chebyshev") +
                                   every_effect[0]};
    for (const auto& bounds : every_bounds) {
        texts.push_back(surface_text("x", bounds) + "certify = true\n");
        texts.push_back(surface_text(all_kernels, bounds) + "certify = true\n");
        texts.push_back(surface_text("x", bounds, "hermite"));
        texts.push_back(blobs_text(75, bounds, "hermite"));
    }
    for (const auto& text : texts) {
        const Shaders shaders = assemble(scene_of(text));
        used.insert(shaders.files.begin(), shaders.files.end());
    }
    const Shaders by_compute = assemble(scene_of(surface_text("x")), {}, Stage::compute);
    used.insert(by_compute.files.begin(), by_compute.files.end());
    // probe/ asks about a driver, whatever the scene: render::arithmetic.
    std::set<std::string> of_scenes = shader_files();
    std::erase_if(of_scenes, [](const std::string& name) { return name.starts_with("probe/"); });
    EXPECT_EQ(used, of_scenes);
}

TEST_F(Assemble, ShaderFilesAreSmall) {
    for (const auto& name : shader_files()) {
        EXPECT_LT(std::filesystem::file_size(shader_folder / name), 8192u) << name;
    }
}

// Only a field made by hand can hold most of these: the parser refuses them. It must not matter.
TEST_F(Assemble, NoFormulaTextBreaksTheShader) {
    for (const char* hostile :
         {"x -\n1", "x -\r\n1", "x\t-\v\f1", "x - 1 \\", "x - 1 \\\n\\\n#error no", "x */ /* y",
          "x - 1 // \xC3\xBC\xE2\x88\x92\xF0\x9F\x92\xA7", "\xFF\xFE",
          "x ?"
          "?/\n#error no"}) {
        formula::Field field = formula::make_field("x - 1", {});
        field.text = hostile;
        std::vector<std::string> files;
        ShaderText text(files);
        const FieldStorage storage = field_storage(field, 0, {});
        add_field(text, field, storage, {FieldFunction::value});
        const std::string shader = text.take();
        for (const char c : shader) EXPECT_TRUE((c >= ' ' && c <= '~') || c == '\n') << hostile;
        const std::string head = "\n// generated from: ";
        ASSERT_EQ(occurrences(shader, head), 1);
        const std::size_t begin = shader.find(head) + head.size();
        const std::size_t end = shader.find('\n', begin);
        EXPECT_EQ(end - begin, std::string(hostile).size());
        EXPECT_EQ(shader.substr(end + 1), formula::glsl_value(field)) << "one line: " << hostile;
        EXPECT_THAT(shader.substr(begin, end - begin), Not(HasSubstr("\\")));
    }
    const Shaders lines = assemble(scene_of(surface_text("\n x^2\n\t+ y^2 \r\n - 1\n")));
    EXPECT_THAT(lines.march, HasSubstr("// generated from:"));
}

// Pay for what the scene calls for: no line of an effect that it does not name.
TEST_F(Assemble, TwoSidesOnlyWhereTheSceneTellsThemApart) {
    const std::string one = std::string(one_set_of_values);
    const Shaders plain = assemble(scene_of(one));
    const Shaders sided = assemble(scene_of(one + "back_color = [0, 0, 1]\n"));
    EXPECT_EQ(plain.march, sided.march);
    EXPECT_THAT(plain.shade, Not(HasSubstr("inside_color")));
    EXPECT_THAT(plain.files, Not(testing::Contains("shade/two_sided.glsl")));
    EXPECT_THAT(sided.shade, HasSubstr("inside_color"));
    EXPECT_THAT(sided.files, testing::Contains("shade/two_sided.glsl"));
    EXPECT_THAT(sided.files, Not(testing::Contains("shade/one_sided.glsl")));
}

TEST_F(Assemble, PaintOnlyWhereTheSceneHasIt) {
    const Shaders plain = assemble(scene_of(one_set_of_values));
    EXPECT_THAT(plain.shade, Not(HasSubstr("paint")));
    EXPECT_THAT(plain.shade, Not(HasSubstr("essian")));
    for (const auto& file : plain.files) EXPECT_FALSE(file.starts_with("effects/")) << file;
    for (const auto& paint : every_paint) {
        const Shaders painted = assemble(scene_of(one_set_of_values + paint));
        EXPECT_EQ(painted.march, plain.march);
        const bool curved = paint.find("curvature") != paint.npos;
        EXPECT_EQ(occurrences(painted.shade, "Hessian field_hessian(vec3 p) {"), curved) << paint;
        EXPECT_EQ(occurrences(painted.shade, "vec3 surface_color(Hit hit) {"), 1);
        // Paint takes the place of one_sided.glsl, and adds.
        const Lines lost = without(lines_of(plain.shade), lines_of(painted.shade));
        EXPECT_THAT(lost, testing::UnorderedElementsAre("// shaders/shade/one_sided.glsl",
                                                        "    return material_color.rgb;"));
    }
}

// A kernel that field and paint share is defined once.
TEST_F(Assemble, PaintAndFieldShareKernels) {
    for (const std::string& formula : {std::string("exp(x) + sin(y)"), long_formula()}) {
        const Shaders painted =
            assemble(scene_of(surface_text(formula) + "[material.colormap]\nrange = [0, 1]\n"
                                                      "value = 'exp(nz)*mean_curvature*sin(x)'\n"));
        EXPECT_EQ(occurrences(painted.shade, "// shaders/math/exp.glsl"), 1);
        EXPECT_EQ(occurrences(painted.shade, "// shaders/math/trig.glsl"), 1);
        EXPECT_EQ(occurrences(painted.shade, "// shaders/math/bits.glsl"), 1);
        EXPECT_EQ(occurrences(painted.shade, "uniform Parameters {"), 1);
    }
}

} // namespace
} // namespace isomotion::synthesis
