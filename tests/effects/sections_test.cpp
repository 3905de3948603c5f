// What sections leave, drawn: against truth, by every method and stage, and what light, mirrors and
// channels make of it.
#include <cmath>

#include <fmt/format.h>

#include "render/drawing.h"
#include "roots/cut_rays.h"
#include "roots/field_at_frame.h"
#include "roots/judge.h"

namespace isomotion::render::sections_test {
namespace {

using shader::Channel;

gpu::Context& context_of_sections() {
    static const auto it = gpu::Context::create();
    return *it;
}

constexpr const char* ball_of_1 =
    "[surface]\nformula = \"x^2 + y^2 + z^2 - 1\"\nbounds = { sphere = 1.5 }\n";
constexpr const char* waves =
    "[surface]\nformula = \"sin(3*x)*cos(3*y) + sin(3*y)*cos(3*z) + sin(3*z)*cos(3*x) - 0.3\"\n"
    "bounds = { sphere = 2 }\n";
constexpr const char* small_picture = "[output]\nsize = [64, 64]\n";

Picture with_caps(const scene::Scene& scene, int frame = 1,
                  StageChoice stage = StageChoice::fragment) {
    RenderOptions options{scene.output.width, scene.output.height, every_channel, {}};
    options.channels.push_back(Channel::cap);
    options.stage = stage;
    Renderer renderer(context_of_sections(), scene, options);
    return renderer.draw(scene::in_formula_coordinates(scene::at_frame(scene, frame)));
}

float value(const Picture& picture, const char* layer, std::size_t pixel) {
    return picture.frame.find(layer)->samples[pixel];
}
bool is_hit(const Picture& picture, std::size_t pixel) {
    return Verdict(int(value(picture, "verdict", pixel))) == Verdict::hit;
}

struct Judged {
    int wrong = 0, undecided = 0, hits = 0, caps = 0, of_other_section = 0;
};

// Every pixel against truth.
Judged judged(const scene::Scene& scene, const Picture& picture, int frame = 1) {
    const scene::SceneAt now = scene::in_formula_coordinates(scene::at_frame(scene, frame));
    const int width = scene.output.width, height = scene.output.height;
    const roots::Tubes all(now, width, height);
    std::vector<roots::Tube> tubes;
    for (int k = 0; k < width * height; ++k) tubes.push_back(all.at(k % width, k / width));
    roots::EnclosedField field(*scene.surfaces[0].field);
    const auto at_frame = field.at(now.surfaces[0], 1);
    roots::RootFinder finder = at_frame.finder();
    std::vector<roots::FirstRoot> roots(tubes.size());
    roots::find_first(finder, roots::Sections(now), tubes, roots);
    Judged judged;
    for (std::size_t k = 0; k < tubes.size(); ++k) {
        const glm::dvec3 p(value(picture, "P.X", k), value(picture, "P.Y", k),
                           value(picture, "P.Z", k));
        const bool hit = is_hit(picture, k);
        const double t = glm::dot(p - tubes[k].anchor, tubes[k].direction);
        const roots::Fault fault = roots::judge(roots[k], hit, t, tubes[k].footprint);
        judged.undecided += fault == roots::Fault::undecided;
        judged.wrong += fault != roots::Fault::none && fault != roots::Fault::undecided;
        judged.hits += hit;
        const int cap = int(value(picture, "cap", k));
        judged.caps += cap > 0;
        const bool is_certain = roots[k].answer == roots::Answer::hit;
        judged.of_other_section += is_certain && hit && (roots[k].cap >= 0) != (cap > 0);
    }
    return judged;
}

const std::vector<std::pair<const char*, const char*>> cuts{
    {"a half-space", "[[sections]]\nnormal = [1, -0.3, 0.2]\noffset = 0.15\n"},
    {"a ball", "[[sections]]\nsphere = 0.9\ncentre = [0.8, 0.4, 0.3]\n"},
    {"several", "[[sections]]\nnormal = [1, 0, 0]\noffset = 0.6\n[[sections]]\nnormal = [0, 1, "
                "0.2]\npoint = [0, 0.3, 0]\n[[sections]]\nsphere = 0.5\ncentre = [0.3, 0, 0.6]\n"
                "[[sections]]\nsphere = 0.4\ncentre = [0.7, -0.4, 0.3]\n"},
    {"two balls in each other", "[[sections]]\nsphere = 0.6\ncentre = [0.7, 0.2, 0]\n[[sections]]"
                                "\nsphere = 0.6\ncentre = [0.7, -0.4, 0.2]\n"}};

class Sections : public testing::TestWithParam<const char*> {};

TEST_P(Sections, AreDrawnAsTruthHasThem) {
    for (const auto& [what, cut] : cuts) {
        for (const char* surface : {ball_of_1, waves}) {
            SCOPED_TRACE(fmt::format("{}, {}", what, surface));
            const scene::Scene scene = scene_of(fmt::format(
                "{}{}{}[isolation]\nmethod = \"{}\"\n", surface, cut, small_picture, GetParam()));
            const Judged found = judged(scene, with_caps(scene));
            EXPECT_EQ(found.wrong, 0);
            EXPECT_EQ(found.of_other_section, 0);
            EXPECT_GT(found.caps, 100);
            EXPECT_GT(found.hits, found.caps);
            EXPECT_LT(found.undecided, 5);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Methods, Sections,
                         testing::Values("hermite", "interval", "affine", "sphere"));

TEST(Section, BeamsAndComputeShadersSeeTheSame) {
    for (const auto& [what, cut] : cuts) {
        SCOPED_TRACE(what);
        const std::string text = std::string(ball_of_1) + cut + small_picture;
        const scene::Scene without = scene_of(text + "[isolation]\nbeam = false\n");
        const scene::Scene with = scene_of(text + "[isolation]\nbeam = true\n");
        EXPECT_EQ(judged(without, with_caps(without)).wrong, 0);
        EXPECT_EQ(judged(with, with_caps(with)).wrong, 0);
        if (context_of_sections().info().has(4, 3)) {
            EXPECT_EQ(judged(with, with_caps(with, 1, StageChoice::compute)).wrong, 0);
        }
    }
}

// Few evaluations in a draw, so that rays stop between and within parts.
TEST(Section, TheNumberOfDrawsDoesNotMatter) {
    const scene::Scene scene = scene_of(std::string(ball_of_1) + cuts[2].second + small_picture);
    const Picture whole = draw(context_of_sections(), scene);
    for (const int evaluations : {30, 40}) {
        const Picture parts = draw(context_of_sections(), scene, 1, MarchPlan{64, 64, evaluations});
        for (std::size_t k = 0; k < 64 * 64; ++k) {
            ASSERT_EQ(value(whole, "verdict", k), value(parts, "verdict", k));
            if (is_hit(whole, k)) {
                ASSERT_NEAR(value(whole, "Z", k), value(parts, "Z", k), 1e-5);
            }
        }
    }
}

TEST(Section, CutsAllOrNothing) {
    const scene::Scene none = scene_of(std::string(ball_of_1) + small_picture);
    const scene::Scene beside = scene_of(std::string(ball_of_1) + small_picture +
                                         "[[sections]]\nnormal = [1, 0, 0]\noffset = 5\n");
    const scene::Scene all = scene_of(std::string(ball_of_1) + small_picture +
                                      "[[sections]]\nnormal = [1, 0, 0]\noffset = -5\n");
    const Picture whole = with_caps(none);
    const Picture as_whole = with_caps(beside);
    EXPECT_EQ(count(with_caps(all), Verdict::hit), 0);
    EXPECT_EQ(count(whole, Verdict::hit), count(as_whole, Verdict::hit));
    for (std::size_t k = 0; k < 64 * 64; ++k) ASSERT_EQ(value(as_whole, "cap", k), 0);
}

// Through the eye, and with the eye in the solid and in what is taken away of it.
TEST(Section, MayPassThroughTheCamera) {
    const char* cameras[] = {
        "[camera]\nposition = [0, -3, 0]\ntarget = [0, 0, 0]\n",
        "[camera]\nposition = [-0.4, 0, 0.1]\ntarget = [1, 0.3, 0]\nfov = 70\n",
        "[camera]\nposition = [0.4, 0, 0.1]\ntarget = [-1, 0.3, 0]\nfov = 70\n"};
    for (const char* camera : cameras) {
        SCOPED_TRACE(camera);
        const scene::Scene scene = scene_of(std::string(ball_of_1) + camera + small_picture +
                                            "[[sections]]\nnormal = [1, 0, 0]\n");
        const Judged found = judged(scene, with_caps(scene));
        EXPECT_EQ(found.wrong, 0);
        EXPECT_GT(found.hits, 300);
    }
}

// In world coordinates: the surface turns and moves, the knife stays.
TEST(Section, StandsInTheWorld) {
    const scene::Scene scene = scene_of(
        "[surface]\nformula = \"x^2 + 4*y^2 + z^2 - 1\"\nbounds = { sphere = 1.5 }\n"
        "transform = { translate = [100, 20, 3], rotate = [20, 40, 70], scale = 10 }\n"
        "[camera]\nposition = [140, 20, 3]\ntarget = [100, 20, 3]\n" +
        std::string(small_picture) + "[[sections]]\nnormal = [2, 0, 0]\npoint = [102, 0, 0]\n");
    EXPECT_EQ(judged(scene, with_caps(scene)).wrong, 0);
    RenderOptions options{64, 64, every_channel, {}};
    options.channels.push_back(Channel::cap);
    Renderer renderer(context_of_sections(), scene, options);
    const Picture picture = renderer.draw(scene::at_frame(scene, 1));
    int caps = 0;
    for (std::size_t k = 0; k < 64 * 64; ++k) {
        if (value(picture, "cap", k) != 1) continue;
        ++caps;
        ASSERT_NEAR(value(picture, "P.X", k), 102, 1e-3);
        ASSERT_NEAR(value(picture, "N.X", k), 1, 1e-6);
    }
    EXPECT_GT(caps, 300);
}

// A plane that moves away from the eye at 0.5 a second, as the channel velocity has its caps.
TEST(Section, MovesAsItsNumbersDo) {
    const scene::Scene scene =
        scene_of("[time]\nfps = 25\nframes = 50\n" + std::string(ball_of_1) +
                 "[camera]\nposition = [5, 0, 0]\ntarget = [0, 0, 0]\n" + small_picture +
                 "[[sections]]\nnormal = [1, 0, 0]\noffset = { keys = [[0, 0.6], [2, -0.4]] }\n");
    RenderOptions options{64, 64, every_channel, {}};
    options.channels.insert(options.channels.end(), {Channel::cap, Channel::velocity});
    Renderer renderer(context_of_sections(), scene, options);
    for (const int frame : {1, 26}) {
        const Motion motion = motion_about(scene, frame);
        const Picture picture = renderer.draw(scene::at_frame(scene, frame), {}, &motion);
        const double at = 0.6 - 0.5 * (frame - 1) / 25.0;
        int caps = 0;
        for (std::size_t k = 0; k < 64 * 64; ++k) {
            if (value(picture, "cap", k) != 1) {
                ASSERT_EQ(value(picture, "velocity.N", k), 0);
                continue;
            }
            ++caps;
            ASSERT_NEAR(value(picture, "P.X", k), at, 1e-5);
            ASSERT_NEAR(value(picture, "velocity.N", k), -0.5, 1e-3);
        }
        EXPECT_GT(caps, 200);
    }
}

constexpr const char* white = "[material]\ncolor = [1, 1, 1]\nback_color = [1, 1, 1]\n";

// A flat cap hides nothing of itself; a bowl's rim casts a shadow into it.
TEST(Section, ShadowsAreThoseOfWhatIsLeft) {
    const auto lit = [&](const std::string& cut, const char* shadow) {
        const scene::Scene scene = scene_of(std::string(ball_of_1) + cut + white + small_picture +
                                            "[camera]\nposition = [5, 0, 0]\ntarget = [0, 0, 0]\n"
                                            "[[lights]]\ndirection = [1, 0, 1]\nshadow = " +
                                            shadow + "\n");
        return with_caps(scene);
    };
    const std::string flat = "[[sections]]\nnormal = [1, 0, 0]\noffset = 0.2\n";
    const Picture cap = lit(flat, "true"), free = lit(flat, "false");
    for (std::size_t k = 0; k < 64 * 64; ++k)
        ASSERT_NEAR(value(cap, "R", k), value(free, "R", k), 1e-6) << k;
    // Light comes at 45 degrees into the half ball of radius 0.8 about (1, 0, 0): a place of the
    // bowl is dark where its way to the light leaves through the ball's solid. The ball is convex
    // and the bowl is a ball, so the way leaves the removed ball and must then be outside.
    const std::string bowl = "[[sections]]\nsphere = 0.8\ncentre = [1, 0, 0]\n";
    const Picture dark = lit(bowl, "true");
    const glm::dvec3 light = glm::normalize(glm::dvec3(1, 0, 1));
    int in_shadow = 0, lit_caps = 0, wrong = 0;
    for (std::size_t k = 0; k < 64 * 64; ++k) {
        if (value(dark, "cap", k) != 1) continue;
        const glm::dvec3 p(value(dark, "P.X", k), value(dark, "P.Y", k), value(dark, "P.Z", k));
        const glm::dvec3 n(value(dark, "N.X", k), value(dark, "N.Y", k), value(dark, "N.Z", k));
        const double facing = glm::dot(n, light);
        // Where light grazes, beginning a twentieth of a pixel off the bowl changes much.
        if (facing < 0.2) continue;
        const glm::dvec3 from = p - glm::dvec3(1, 0, 0);
        const glm::dvec3 leaves = p - 2 * glm::dot(from, light) * light;
        const double off = glm::length(leaves) - 1;
        if (std::abs(off) < 0.02) continue;
        const double expected = 0.12 + (off < 0 ? 0 : facing);
        in_shadow += off < 0;
        lit_caps += off > 0;
        if (std::abs(value(dark, "R", k) - expected) <= 1e-3) continue;
        ++wrong;
        ADD_FAILURE() << fmt::format("{} in place of {} at ({}, {}, {}), facing {}, off {}",
                                     value(dark, "R", k), expected, p.x, p.y, p.z, facing, off);
    }
    EXPECT_EQ(wrong, 0);
    EXPECT_GT(in_shadow, 20);
    EXPECT_GT(lit_caps, 100);
}

TEST(Section, OcclusionOfAFlatCapIsNone) {
    const std::string text = std::string(ball_of_1) + white + small_picture +
                             "[camera]\nposition = [5, 0, 0]\ntarget = [0, 0, 0]\n"
                             "[[sections]]\nnormal = [1, 0, 0]\noffset = 0.2\n";
    const Picture open = with_caps(scene_of(text));
    const Picture occluded = with_caps(scene_of(text + "[occlusion]\n"));
    for (std::size_t k = 0; k < 64 * 64; ++k) {
        if (value(open, "cap", k) == 1) {
            ASSERT_NEAR(value(open, "R", k), value(occluded, "R", k), 1e-5) << k;
        }
    }
}

// The cap of a half ball as a mirror: what is above it is seen in it, as in a mirror of its own.
TEST(Section, CapsMirror) {
    const scene::Scene scene = scene_of(
        "[surface]\nformula = \"min(x^2 + y^2 + z^2, x^2 + y^2 + (z - 1.5)^2) - 0.64\"\n"
        "bounds = { sphere = 3 }\n[material]\nmodel = \"ggx\"\nmetallic = 1\nroughness = 0\n"
        "reflection = \"self\"\ncolor = [1, 0.2, 0.2]\n[output]\nsize = [64, 64]\n"
        "background = [0, 0, 1]\n[camera]\nposition = [4, 0, 2]\ntarget = [0, 0, 0.5]\n"
        "[[sections]]\nsphere = 0.3\ncentre = [0, 0, 0.8]\n");
    const Picture picture = with_caps(scene);
    EXPECT_GT(count(picture, Verdict::hit), 500);
    for (std::size_t k = 0; k < 64 * 64; ++k) ASSERT_TRUE(std::isfinite(value(picture, "R", k)));
}

TEST(Section, CapsHaveTheirColour) {
    const auto red_of = [&](const std::string& material) {
        const Picture picture = with_caps(scene_of(
            std::string(ball_of_1) + "[material]\n" + material + small_picture +
            "[camera]\nposition = [5, 0, 0]\ntarget = [0, 0, 0]\n[[lights]]\ndirection = [1, 0, 0]"
            "\n[[sections]]\nnormal = [1, 0, 0]\n"));
        const std::size_t middle = 32 * 64 + 32;
        EXPECT_EQ(value(picture, "cap", middle), 1);
        return value(picture, "R", middle);
    };
    EXPECT_NEAR(red_of("color = [0.5, 0, 0]\n"), 1.12 * 0.5, 1e-4);
    EXPECT_NEAR(red_of("color = [0.5, 0, 0]\nback_color = [0.25, 0, 0]\n"), 1.12 * 0.25, 1e-4);
    EXPECT_NEAR(
        red_of("color = [0.5, 0, 0]\nback_color = [0.25, 0, 0]\ncap_color = [0.75, 0, 0]\n"),
        1.12 * 0.75, 1e-4);
    EXPECT_NEAR(red_of("color = [\"0.3 + x\", 0, 0]\n"), 1.12 * 0.3, 1e-4);
}

// Elements that lists and grids find, with the solid where their sum is large.
TEST(Section, SumsByListsAndByPlace) {
    for (const int count : {40, 800}) {
        SCOPED_TRACE(count);
        const scene::Scene scene = scene_of(fmt::format(
            "[surface]\nformula = \"1 - sum(blobs, exp(-k*((x-cx)^2 + (y-cy)^2 + (z-cz)^2)))\"\n"
            "bounds = {{ sphere = 2 }}\n[arrays.blobs]\ncount = {}\nk = {}\n"
            "cx = \"2*random(i, 0) - 1\"\ncy = \"2*random(i, 1) - 1\"\ncz = \"2*random(i, 2) - "
            "1\"\n"
            "{}[[sections]]\nnormal = [1, 0.2, 0.1]\noffset = 0.1\n",
            count, count == 40 ? 8 : 60, small_picture));
        const Judged found = judged(scene, with_caps(scene));
        EXPECT_EQ(found.wrong, 0);
        EXPECT_GT(found.caps, 100);
    }
}

// Where F has no value there is no solid, and so no cap.
TEST(Section, NoCapIsWhereFHasNoValue) {
    const scene::Scene scene =
        scene_of("[surface]\nformula = \"log(z) + x^2 + y^2 - 0.2\"\nbounds = { sphere = 1 }\n" +
                 std::string(small_picture) +
                 "[camera]\nposition = [5, 0, 1]\ntarget = [0, 0, 0]\n"
                 "[[sections]]\nnormal = [1, 0, 0]\n");
    const Picture picture = with_caps(scene);
    int caps = 0;
    for (std::size_t k = 0; k < 64 * 64; ++k) {
        if (value(picture, "cap", k) != 1) continue;
        ++caps;
        ASSERT_GT(value(picture, "P.Z", k), 0);
    }
    EXPECT_GT(caps, 100);
    EXPECT_EQ(judged(scene, picture).wrong, 0);
}

} // namespace
} // namespace isomotion::render::sections_test
