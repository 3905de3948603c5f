// What the assembled text depends on, and what it does not.
#include <gmock/gmock.h>

#include "formula/glsl/glsl.h"
#include "scene/surfaces.h"
#include "scenes.h"
#include "shader/shader_files.h"
#include "shader/shader_text.h"

namespace isomotion::shader {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class Assemble : public testing::Test {
protected:
    static void SetUpTestSuite() { use_shaders_of_source_tree(); }
};

// Every pass that runs, as it runs.
void expect_same_text(const Passes& a, const Passes& b) {
    ASSERT_EQ(a.list.size(), b.list.size());
    for (std::size_t k = 0; k < a.list.size(); ++k) {
        EXPECT_EQ(a.list[k].name, b.list[k].name);
        EXPECT_EQ(a.list[k].vertex, b.list[k].vertex) << a.list[k].name;
        EXPECT_EQ(a.list[k].text, b.list[k].text) << a.list[k].name;
    }
    EXPECT_EQ(a.fingerprint(), b.fingerprint());
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
[[lights]]
direction = [1, 0, 0]
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
placement = { translate = [5, 0, "t"], rotate = [0, 30, 0], scale = 1000 }
[parameters]
a = { keys = [[0, 0.0], [2, 3.1]], ease = "smooth" }
b = -1e-2
[arrays.blobs]
count = 5
cx = 'random(i, 0)'
cy = 'cos(t*i)'
k = 0.01
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

// Keys of [material] and tables that bring passes of their own; # is a value.
struct Called {
    std::string material, tables;
};
const std::vector<Called> calls{
    {"", ""},
    {"reflection = 'self'\n", "[[lights]]\ndirection = [#, 1, 0]\nshadow = true\n"},
    {"back_color = [#, 0, 0]\n", "[fog]\ndensity = #\n[ground]\nheight = -#\n[occlusion]\n"},
    {"transmission = #\nior = #\nabsorption = [#, 0, 0]\n",
     "[[lights]]\ndirection = [#, 1, 0]\nshadow = true\n[ground]\nheight = -#\n"},
    {"", "[material.colormap]\nvalue = 'nz'\nrange = [-#, 1]\n"},
    {"cap_color = [#, 0, 0]\n", "[[sections]]\nnormal = [#, 1, 0]\noffset = #\n[[sections]]\n"
                                "sphere = #\n[material.contours]\nvalue = 'z'\nevery = #\n"}};

scene::Scene called(std::string scene, const Called& more, const std::string& value) {
    const std::string head = "[material]\n";
    scene.insert(scene.find(head) + head.size(), more.material);
    std::string text;
    for (const char c : scene + more.tables) text += c == '#' ? value : std::string(1, c);
    return scene_of(text);
}

// Two surfaces of one scene that mirror, shade and hide each other; # is a value.
scene::Scene two_surfaces(const std::string& value) {
    const char* described = R"(
[[surfaces]]
name = "one"
formula = "x^2 + y^2 + z^2 - r"
bounds = { sphere = 2 }
parameters = { r = # }
material = { reflection = "self", color = [#, 1, 0] }
[[surfaces]]
name = "other"
formula = "x*y*z - r"
bounds = { sphere = 2, centre = [#, 0, 0] }
parameters = { r = # }
material = { color = [1, #, 0] }
[[lights]]
direction = [#, 1, 1]
shadow = true
[occlusion]
[ground]
height = -#
)";
    std::string text;
    for (const char* c = described; *c != 0; ++c) text += *c == '#' ? value : std::string(1, *c);
    return scene_of(text);
}

scene::Scene with_glass(const std::string& value) { return scene_of(glass_among_others(value)); }

std::vector<Passes> passes_of_surfaces(const scene::Scene& scene) {
    const std::vector<Channel> channels{Channel::surface, Channel::ending};
    std::vector<Passes> all;
    for (std::size_t k = 0; k < scene.surfaces.size(); ++k)
        all.push_back(assemble(scene::OneSurface(scene, k), channels));
    return all;
}

TEST_F(Assemble, NoValueIsInTheTextOfAnyPass) {
    std::vector<Channel> channels = every_channel;
    channels.push_back(Channel::velocity);
    std::set<Role> roles;
    for (const Called& more : calls) {
        for (const Stage stage : {Stage::fragment, Stage::compute}) {
            scene::Scene one = called(one_set_of_values, more, "0.25");
            scene::Scene other = called(another_set_of_values, more, "0.5");
            one.surfaces[0].isolation.certify = other.surfaces[0].isolation.certify = true;
            expect_same_text(assemble(one, channels, {stage}), assemble(other, channels, {stage}));
            expect_same_text(assemble(one, {}, {stage}), assemble(other, {}, {stage}));
            for (const Pass& pass : assemble(one, channels, {stage}).list) roles.insert(pass.role);
            for (const Pass& pass : assemble(one, {}, {stage}).list) roles.insert(pass.role);
        }
    }
    for (const char* method : {"amp-sign", "hermite"}) {
        const std::string polynomial = surface_text("x", every_bounds[0], method);
        for (const Pass& pass : assemble(scene_of(polynomial + "certify = true\n")).list)
            roles.insert(pass.role);
    }
    for (const auto& described : {two_surfaces, two_plain_surfaces, proved_surfaces, with_glass}) {
        const std::vector<Passes> one = passes_of_surfaces(described("0.25"));
        const std::vector<Passes> other = passes_of_surfaces(described("0.5"));
        for (std::size_t k = 0; k < one.size(); ++k) {
            expect_same_text(one[k], other[k]);
            for (const Pass& pass : one[k].list) roles.insert(pass.role);
        }
    }
    const auto page_with_lists = [](const char* color) {
        const std::string material = fmt::format("[material]\ncolor = [{}, 1, 0]\n", color);
        return assemble(scene_of(blobs_text(75, every_bounds[0], "hermite") + material), {},
                        on_page);
    };
    expect_same_text(page_with_lists("0.25"), page_with_lists("0.5"));
    for (const Pass& pass : page_with_lists("0.25").list) roles.insert(pass.role);
    EXPECT_EQ(roles.size(), std::size_t(Role::double_proof) + 1) << "a role that no scene has";
}

// OpenGL draws into eight attachments at least.
TEST_F(Assemble, NoPassHasMoreThanEightOutputs) {
    std::vector<Channel> channels = every_channel;
    channels.push_back(Channel::ending);
    const scene::Scene plain = two_plain_surfaces("0.25");
    const scene::Scene single = scene_of(surface_text("x"));
    const scene::OneSurface first(plain, 0), second(plain, 1);
    for (const scene::OneSurface& one : {first, second, scene::OneSurface(single)}) {
        for (const std::vector<Channel>& wanted : {channels, {Channel::ending}}) {
            for (const Pass& pass : assemble(one, wanted).list)
                EXPECT_LE(pass.outputs.size(), 8u) << pass.name;
        }
    }
    EXPECT_TRUE(assemble(first, {Channel::ending}).has(Role::fused));
}

TEST_F(Assemble, TheSameSceneGivesTheSameText) {
    expect_same_text(assemble(scene_of(one_set_of_values)), assemble(scene_of(one_set_of_values)));
}

TEST_F(Assemble, WithoutChannelsThereIsNoLineOfOne) {
    const Passes plain = assemble(scene_of(surface_text("x")));
    for (const char* word : {"_out", "_LOCATION", "to_world)"})
        EXPECT_THAT(all_texts(plain), Not(HasSubstr(word)));
    EXPECT_THAT(all_texts(plain),
                HasSubstr("void write_channels(Ray ray, Hit hit, int verdict) {\n}"));
    EXPECT_THAT(plain.attachments, IsEmpty());
}

TEST_F(Assemble, AChannelAddsItsOwnLines) {
    const scene::Scene scene = scene_of(surface_text("x"));
    const Passes plain = assemble(scene), with_depth = assemble(scene, {Channel::depth});
    ASSERT_EQ(with_depth.list.size(), plain.list.size());
    for (std::size_t k = 0; k < plain.list.size(); ++k) {
        const Lines before = lines_of(plain.list[k].text),
                    after = lines_of(with_depth.list[k].text);
        const Role role = plain.list[k].role;
        const bool writes = role == Role::shade || role == Role::fused;
        EXPECT_THAT(without(before, after), IsEmpty()) << plain.list[k].name;
        const Lines more = without(after, before);
        EXPECT_EQ(more.size(), writes ? 5u : 0u) << plain.list[k].name;
        EXPECT_EQ(more.count("#define DEPTH_LOCATION 2"), std::size_t(writes));
        EXPECT_EQ(more.count("layout(location = DEPTH_LOCATION) out vec4 depth_out;"),
                  std::size_t(writes));
        EXPECT_EQ(plain.list[k].vertex, with_depth.list[k].vertex);
    }
}

// Attachments are numbered without gaps, whatever is asked for in whatever order.
TEST_F(Assemble, ChannelsTakeTheNextAttachment) {
    const scene::Scene scene = scene_of(surface_text("x"));
    const Passes two = assemble(scene, {Channel::position, Channel::normal});
    EXPECT_EQ(two.attachments, (std::vector{Channel::normal, Channel::position}));
    EXPECT_THAT(text_of(two, Role::shade), HasSubstr("#define NORMAL_LOCATION 2\n"));
    EXPECT_THAT(text_of(two, Role::shade), HasSubstr("#define POSITION_LOCATION 3\n"));
    EXPECT_THAT(text_of(two, Role::shade), Not(HasSubstr("DEPTH_LOCATION")));
    expect_same_text(two, assemble(scene, {Channel::normal, Channel::position, Channel::normal}));
    // These two are in every picture's record.
    expect_same_text(assemble(scene), assemble(scene, {Channel::verdict, Channel::evaluations}));
}

TEST_F(Assemble, TheMethodChangesTheMarchAlone) {
    std::set<std::string> marches;
    std::vector<Passes> all;
    for (const auto& method : every_method) {
        all.push_back(assemble(scene_of(surface_text("x*y", every_bounds[0], method))));
        marches.insert(text_of(all.back(), Role::march));
        EXPECT_EQ(text_of(all.back(), Role::shade), text_of(all.front(), Role::shade));
        EXPECT_EQ(text_of(all.back(), Role::active), text_of(all.front(), Role::active));
    }
    EXPECT_EQ(marches.size(), every_method.size());
    // Uniform steps with a sign test pay for no derivative.
    EXPECT_THAT(text_of(all[0], Role::march), Not(HasSubstr("field_directional")));
    EXPECT_THAT(text_of(all[0], Role::march), HasSubstr("float field(vec3 p)"));
    // The two adaptive methods differ by their test.
    const std::string steps = read_shader("march/amp_steps.glsl");
    const std::size_t begin = steps.find("#ifdef TAYLOR_TEST\n") + 19;
    const Lines taylor = lines_of(steps.substr(begin, steps.find("#else\n", begin) - begin));
    const Lines more =
        without(lines_of(text_of(all[2], Role::march)), lines_of(text_of(all[1], Role::march)));
    EXPECT_THAT(without(more, taylor), IsEmpty());
}

TEST_F(Assemble, TheBoundsShapeChangesTheClipAlone) {
    const Passes sphere = assemble(scene_of(surface_text("x", every_bounds[0])), every_channel);
    const Passes box = assemble(scene_of(surface_text("x", every_bounds[1])), every_channel);
    // Lines between #ifdef, #else and #endif of a file.
    const std::string ray = read_shader("march/ray.glsl");
    const std::size_t first = ray.find("#ifdef BOX\n"), middle = ray.find("#else\n", first),
                      end = ray.find("#endif\n", middle);
    const Lines clip_box = lines_of(ray.substr(first + 11, middle - first - 11));
    const Lines clip_sphere = lines_of(ray.substr(middle + 6, end - middle - 6));
    for (const Role role : {Role::march, Role::shade, Role::fused}) {
        const Lines b = lines_of(text_of(box, role)), s = lines_of(text_of(sphere, role));
        EXPECT_EQ(without(b, s), without(clip_box, clip_sphere));
        EXPECT_EQ(without(s, b), without(clip_sphere, clip_box));
    }
    EXPECT_EQ(text_of(box, Role::active), text_of(sphere, Role::active));
}

// Proofs are shaders of their own: others only tell them where rays ended, as they tell a channel.
TEST_F(Assemble, ProofsAddAChannelToThePictureAndChangeNoOtherShader) {
    for (const auto& bounds : every_bounds) {
        const std::string text = surface_text("x*y - 1", bounds);
        const Passes plain = assemble(scene_of(text), every_channel);
        const Passes proving = assemble(scene_of(text + "certify = true\n"), every_channel);
        for (const Pass& pass : plain.list) {
            const Pass& with = proving.at(pass.role, pass.level);
            const bool writes = pass.role == Role::shade || pass.role == Role::fused;
            EXPECT_THAT(without(lines_of(pass.text), lines_of(with.text)), IsEmpty()) << pass.name;
            const Lines more = without(lines_of(with.text), lines_of(pass.text));
            EXPECT_EQ(more.count("layout(location = ENDING_LOCATION) out float ending_out;"),
                      std::size_t(writes));
            EXPECT_EQ(more.size(), writes ? 6u : 0u) << pass.name;
            EXPECT_EQ(pass.vertex, with.vertex);
            EXPECT_FALSE(is_proof(pass.role)) << pass.name;
        }
        for (const Pass& pass : proving.list) {
            EXPECT_EQ(is_proof(pass.role), !plain.find(pass.role, pass.level)) << pass.name;
        }
        EXPECT_EQ(proving.attachments.size(), plain.attachments.size() + 1);
        EXPECT_THAT(text_of(proving, Role::proof), HasSubstr("proof/prove_by_models.glsl"));
        const Passes by_bounds =
            assemble(scene_of(surface_text("exp(x)*y - 1", bounds) + "certify = true\n"));
        EXPECT_THAT(text_of(by_bounds, Role::proof), HasSubstr("proof/prove.glsl"));
        EXPECT_FALSE(by_bounds.has(Role::coarse_block_proof));
        for (const auto& name : plain.files()) EXPECT_FALSE(name.starts_with("proof/")) << name;
    }
}

// Whose sums go over all elements, however many.
scene::Scene of_all_elements(int count) {
    scene::Scene scene = scene_of(blobs_text(count));
    scene.surfaces[0].isolation.beam = false;
    return scene;
}

TEST_F(Assemble, ASumStaysOneLoopAndOneSizeOfText) {
    const Passes few = assemble(of_all_elements(75));
    const Passes many = assemble(of_all_elements(5000));
    for (const Role role : {Role::march, Role::shade}) {
        const std::string& text = text_of(few, role);
        EXPECT_EQ(occurrences(text, "for (int e0"), 1);
        EXPECT_EQ(occurrences(text, "array0_texel("), 2) << "its definition and one call";
        const Lines f = lines_of(text), m = lines_of(text_of(many, role));
        EXPECT_EQ(without(f, m),
                  (Lines{"layout(std140) uniform array0_block { vec4 array0[75]; };",
                         "vec4 array0_texel(int element, int texel) { return array0[element]; }"}));
        EXPECT_EQ(without(m, f), (Lines{"uniform IM_BUFFER array0;",
                                        "vec4 array0_texel(int element, int texel) { return "
                                        "IM_BUFFER_AT(array0, element); }"}));
    }
}

TEST_F(Assemble, AFieldIsCalledFromOnePlace) {
    const Passes passes = assemble(scene_of(surface_text("x*y - 1")), every_channel);
    EXPECT_EQ(occurrences(text_of(passes, Role::march), "field_directional("), 2)
        << "its definition and one call";
    EXPECT_EQ(occurrences(text_of(passes, Role::march), "sample_field("), 2);
    for (const char* method : {"interval", "affine", "sphere"}) {
        const Passes on_pieces =
            assemble(scene_of(surface_text("x*y - 1", every_bounds[0], method)), every_channel);
        EXPECT_EQ(occurrences(text_of(on_pieces, Role::march), "field_directional_interval("), 2);
        EXPECT_EQ(occurrences(text_of(on_pieces, Role::march), " field("), 2);
    }
    EXPECT_EQ(occurrences(text_of(passes, Role::shade), "field_gradient("), 2);
}

TEST_F(Assemble, ArraysAreStoredWhereTheyFit) {
    const auto storage = [](int count) { return assemble(of_all_elements(count)).arrays[0]; };
    // Three fields take one texel of 16 bytes, and a block has 16 kB.
    EXPECT_EQ(storage(1024).kind, ArrayStorage::Kind::uniform_block);
    EXPECT_EQ(storage(1025).kind, ArrayStorage::Kind::texture_buffer);
    EXPECT_EQ(storage(1025).capacity, 1025);
    EXPECT_EQ(storage(1).texels, 1);
}

TEST_F(Assemble, EachFileAppearsOnce) {
    const auto expect_once = [](const std::string& formula) {
        for (const auto& method : every_method) {
            for (const auto& bounds : every_bounds) {
                const Passes passes =
                    assemble(scene_of(surface_text(formula, bounds, method)), every_channel);
                EXPECT_FALSE(passes.tapes);
                for (const Pass& pass : passes.list) {
                    const std::set<std::string> names(pass.files.begin(), pass.files.end());
                    EXPECT_EQ(names.size(), pass.files.size()) << pass.name;
                    EXPECT_TRUE(pass.text.starts_with("#version "));
                    EXPECT_EQ(occurrences(pass.text, "#version"), 1);
                    for (const auto& name : names) {
                        EXPECT_LE(occurrences(pass.text, "// shaders/" + name + "\n"), 1) << name;
                    }
                }
            }
        }
    };
    expect_once("sqrt(x)/y + exp(x)^y + log(x) + sin(x) + tan(y) + asin(x) + tanh(x) + "
                "asinh(x) + erf(x) + cbrt(x)");
    expect_once("noise(x, y, z)");
}

TEST_F(Assemble, EveryShaderFileIsUsedBySomeScene) {
    std::set<std::string> used;
    const auto add = [&](const Passes& passes) {
        for (const auto& file : passes.files()) used.insert(file);
    };
    const auto* all_kernels = "sqrt(x)/y + exp(x)^y + log(x) + sin(x) + asin(x) + chebyshev(5, x) "
                              "+ asinh(x) + erf(x) + cbrt(x) + noise(x, y, z)";
    for (const auto& method : every_method) {
        for (const auto& bounds : every_bounds) {
            const Passes passes =
                assemble(scene_of(surface_text(all_kernels, bounds, method)), every_channel);
            add(passes);
        }
    }
    const Passes of_shadows = assemble(scene_of(surface_text("x", every_bounds[0], "hermite") +
                                                "[[lights]]\ndirection = [1, 1, 1]\n"
                                                "shadow = true\n"));
    add(of_shadows);
    const Passes of_long = assemble(scene_of(surface_text(long_formula())));
    add(of_long);
    const Passes of_bits =
        assemble(scene_of(blobs_text(75, every_bounds[0], "hermite")), {}, on_page);
    add(of_bits);
    const Passes of_three_levels =
        assemble(scene_of(blobs_text(384, every_bounds[0], "hermite")), {}, on_page);
    add(of_three_levels);
    const Passes of_sides =
        assemble(scene_of(surface_text("x") + "[material]\nback_color = [1, 1, 1]\n"));
    add(of_sides);
    for (const auto& paint : every_paint) {
        const Passes painted = assemble(scene_of(surface_text("x") + paint));
        add(painted);
    }
    for (const auto& effects : every_effect) {
        const Passes called =
            assemble(scene_of(surface_text("x") + effects), {Channel::velocity, Channel::cap});
        add(called);
    }
    std::vector<std::string> texts{surface_text("x^3 - y", every_bounds[0]) + every_effect[0]};
    for (const auto& bounds : every_bounds) {
        texts.push_back(surface_text("x", bounds) + "certify = true\n");
        texts.push_back(surface_text(all_kernels, bounds) + "certify = true\n");
        texts.push_back(surface_text("x", bounds, "hermite"));
        texts.push_back(surface_text("x", bounds, "hermite") + every_effect.back());
        texts.push_back(surface_text("abs(x)", bounds, "hermite"));            // with kinks alone
        texts.push_back(surface_text(many_balls(), bounds, "hermite"));        // by tapes
        texts.push_back(surface_text("(x^2 - y)^2 - z^3", bounds, "hermite")); // squares
        texts.push_back(surface_text("x - floor(floor(y)/2)", bounds, "hermite"));
        texts.push_back(surface_text("x^2 - y", bounds, "hermite") +
                        "certify = true\n"); // settled, proved
        texts.push_back(blobs_text(75, bounds, "hermite"));
        // by place: smooth, with kinks, with poles, squares
        const std::string d = "((x - cx)^2 + (y - cy)^2 + (z - cz)^2)";
        for (const std::string& term :
             {"exp(-20*" + d + ")", "max(0, 1 - 3*sqrt(" + d + "))", "floor(4*exp(-" + d + "))",
              "exp(-" + d + ")^2", "(9*" + d + " - 1)^2*exp(-20*" + d + ")"}) {
            texts.push_back(blobs_text(5000, bounds, "hermite", term));
        }
        std::string sum = blobs_text(9, bounds, "hermite", d + "*y"); // a polynomial
        texts.push_back(sum.insert(sum.find("[arrays"), "certify = true\n"));
        std::string proved = blobs_text(5000, bounds, "hermite");
        texts.push_back(proved.insert(proved.find("[arrays"), "certify = true\n"));
    }
    for (const auto& text : texts) {
        const Passes passes = assemble(scene_of(text));
        add(passes);
    }
    for (const auto& glass : every_glass) {
        const Passes passes = assemble(scene_of(surface_text("x") + glass));
        add(passes);
    }
    const Passes by_compute =
        assemble(scene_of(surface_text("x", every_bounds[0], "hermite") + "beam = true\n"), {},
                 {Stage::compute});
    add(by_compute);
    const std::vector<Passes> of_surfaces = passes_of_surfaces(two_surfaces("0.5"));
    for (const Passes& passes : of_surfaces) add(passes);
    const std::vector<Passes> of_plain_surfaces = passes_of_surfaces(two_plain_surfaces("0.5"));
    for (const Passes& passes : of_plain_surfaces) add(passes);
    const std::vector<Passes> of_proved_surfaces = passes_of_surfaces(proved_surfaces("0.5"));
    for (const Passes& passes : of_proved_surfaces) add(passes);
    const std::vector<Passes> of_glass = passes_of_surfaces(with_glass("0.5"));
    for (const Passes& passes : of_glass) add(passes);
    const Passes of_long_mirror =
        assemble(scene_of(surface_text(long_formula()) + "[material]\nreflection = 'sky'\n"
                                                         "[environment]\nmap = 'studio.exr'\n"));
    add(of_long_mirror);
    // probe/ asks about a driver, whatever the scene: render::arithmetic.
    std::set<std::string> of_scenes = shader_files();
    std::erase_if(of_scenes, [](const std::string& name) { return name.starts_with("probe/"); });
    EXPECT_THAT(used, testing::ContainerEq(of_scenes));
}

// Compute shaders march where there are more lanes than a picture has blocks.
TEST_F(Assemble, ComputeShadersTakeBeamsForListsAndOfLargePictures) {
    const auto levels = [](const std::string& text, Stage stage, std::int64_t pixels = 0) {
        return assemble(scene_of(text), {}, {.stage = stage, .pixels = pixels}).beams.size();
    };
    const std::string plain = surface_text("x^2 + y^2 + z^2 - 1", every_bounds[0], "hermite");
    const std::string told = plain + "beam = true\n";
    const std::string sum =
        surface_text("sum(p, exp(-9*((x-cx)^2 + y^2 + z^2))) - 0.5", every_bounds[0], "hermite") +
        "[arrays.p]\ncount = 20\ncx = 'i/n'\n";
    EXPECT_GT(levels(plain, Stage::fragment), 0U);
    EXPECT_EQ(levels(plain, Stage::compute), 0U);
    EXPECT_EQ(levels(told, Stage::compute), levels(plain, Stage::fragment));
    EXPECT_EQ(levels(plain, Stage::compute, 1024 * 1024), 0U);
    EXPECT_EQ(levels(plain, Stage::compute, 1920 * 1080), 1U) << "settles blocks";
    EXPECT_EQ(levels(surface_text("exp(x) - y"), Stage::compute, 1920 * 1080), 0U);
    EXPECT_GT(levels(sum, Stage::compute), 0U);
    EXPECT_EQ(levels(sum, Stage::compute), levels(sum, Stage::fragment));
}

// What the table of passes gives units and bindings to is what the texts declare.
TEST_F(Assemble, PassesKnowWhatTheyDeclare) {
    const Passes passes = assemble(called(one_set_of_values, calls[1], "1"), every_channel);
    const Pass& shadow = passes.at(Role::shadow);
    EXPECT_THAT(shadow.blocks, testing::IsSupersetOf({"Frame", "Parameters", "Shading"}));
    EXPECT_THAT(shadow.samplers,
                testing::IsSupersetOf({"state_texture_0", "state_texture_1", "surface_texture_2"}));
    EXPECT_THAT(passes.at(Role::shade).outputs,
                testing::ElementsAre("depth_out", "normal_out", "position_out", "color", "record"));
    EXPECT_THAT(passes.at(Role::march).samplers, testing::Contains("beam_texture"));
    for (const Pass& pass : passes.list) {
        // Every declaration of the texts, however it is looked for.
        const std::string text = pass.vertex + pass.text;
        EXPECT_EQ(occurrences(text, "uniform sampler") > 0, !pass.samplers.empty()) << pass.name;
        for (const auto& name : pass.samplers) {
            EXPECT_GT(occurrences(text, name + ";") + occurrences(text, name + ","), 0) << name;
        }
        for (const auto& name : pass.blocks) {
            EXPECT_GT(occurrences(text, "uniform " + name + " {"), 0) << name;
        }
    }
}

TEST_F(Assemble, ShaderFilesAreSmall) {
    for (const auto& name : shader_files()) {
        EXPECT_LT(std::filesystem::file_size(shader_folder / name), 12288u) << name;
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
        ShaderText text;
        const FieldStorage storage = field_storage(field, 0, {});
        add_field(text, field, storage, {FieldFunction::value});
        const std::string shader = text.text();
        for (const char c : shader) EXPECT_TRUE((c >= ' ' && c <= '~') || c == '\n') << hostile;
        const std::string head = "\n// generated from: ";
        ASSERT_EQ(occurrences(shader, head), 1);
        const std::size_t begin = shader.find(head) + head.size();
        const std::size_t end = shader.find('\n', begin);
        EXPECT_EQ(end - begin, std::string(hostile).size());
        EXPECT_EQ(shader.substr(end + 1), formula::glsl_value(field)) << "one line: " << hostile;
        EXPECT_THAT(shader.substr(begin, end - begin), Not(HasSubstr("\\")));
    }
    const Passes lines = assemble(scene_of(surface_text("\n x^2\n\t+ y^2 \r\n - 1\n")));
    EXPECT_THAT(text_of(lines, Role::march), HasSubstr("// generated from:"));
}

// Pay for what the scene calls for: no line of an effect that it does not name.
TEST_F(Assemble, TwoSidesOnlyWhereTheSceneTellsThemApart) {
    const std::string one = std::string(one_set_of_values);
    const Passes plain = assemble(scene_of(one));
    const Passes sided = assemble(scene_of(one + "back_color = [0, 0, 1]\n"));
    EXPECT_EQ(text_of(plain, Role::march), text_of(sided, Role::march));
    EXPECT_THAT(all_texts(plain), Not(HasSubstr("inside_color")));
    EXPECT_THAT(text_of(plain, Role::shade), Not(HasSubstr("inside_color")));
    EXPECT_THAT(text_of(sided, Role::shade), HasSubstr("inside_color"));
}

TEST_F(Assemble, PaintOnlyWhereTheSceneHasIt) {
    const std::string all = one_set_of_values;
    const std::string scene = all.substr(0, all.find("[material]"));
    const Passes plain = assemble(scene_of(scene));
    EXPECT_THAT(text_of(plain, Role::shade), Not(HasSubstr("paint")));
    EXPECT_THAT(text_of(plain, Role::shade), Not(HasSubstr("essian")));
    for (const auto& file : plain.files()) EXPECT_FALSE(file.starts_with("effects/")) << file;
    for (const auto& paint : every_paint) {
        const Passes painted = assemble(scene_of(scene + paint));
        EXPECT_EQ(text_of(painted, Role::march), text_of(plain, Role::march));
        const bool curved = paint.find("curvature") != paint.npos;
        EXPECT_EQ(occurrences(text_of(painted, Role::shade), "Hessian field_hessian(vec3 p) {"),
                  curved)
            << paint;
        EXPECT_EQ(occurrences(text_of(painted, Role::shade), "vec3 surface_color(Hit hit) {"), 1);
        // Paint takes the place of the material's colour, and adds.
        const Lines lost =
            without(lines_of(text_of(plain, Role::shade)), lines_of(text_of(painted, Role::shade)));
        EXPECT_THAT(lost, testing::Contains("    vec3 color = material_color.rgb;"));
        EXPECT_THAT(lost, testing::IsSubsetOf(
                              {"    vec3 color = material_color.rgb;", "    return color;"}));
    }
}

} // namespace
} // namespace isomotion::shader
