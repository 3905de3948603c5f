// Several surfaces in one scene: the nearest of them against truth, what coincides, and that rays
// which begin on one see all.
#include <cmath>

#include <fmt/format.h>

#include "render/drawing.h"
#include "roots/certify.h"
#include "roots/judge.h"
#include "roots/nearest.h"

namespace isomotion::render::surfaces_test {
namespace {

using shader::Channel;

gpu::Context& context_of_surfaces() {
    static const auto it = gpu::Context::create();
    return *it;
}

std::string ball(const std::string& name, const std::string& place, double radius,
                 const std::string& more = "") {
    return fmt::format("[[surfaces]]\nname = \"{}\"\nformula = \"x^2 + y^2 + z^2 - r^2\"\n"
                       "parameters = {{ r = {} }}\nbounds = {{ sphere = {} }}\n"
                       "transform = {{ translate = {} }}\n{}\n",
                       name, radius, 1.1 * radius, place, more);
}

constexpr const char* view =
    "[camera]\nposition = [0, -6, 1]\ntarget = [0, 0, 0]\n[output]\nsize = [64, 64]\n";

Picture drawn(const scene::Scene& scene, StageChoice stage = StageChoice::fragment,
              const std::optional<MarchPlan>& plan = {}) {
    RenderOptions options{scene.output.width, scene.output.height, every_channel, {}};
    std::erase(options.channels, Channel::velocity);
    options.channels.push_back(Channel::surface);
    options.stage = stage;
    options.plan = plan;
    Renderer renderer(context_of_surfaces(), scene, options);
    return renderer.draw(scene::in_formula_coordinates(scene::at_frame(scene, 1)));
}

float value(const Picture& picture, const char* layer, std::size_t pixel) {
    return picture.frame.find(layer)->samples[pixel];
}
bool is_hit(const Picture& picture, std::size_t pixel) {
    return Verdict(int(value(picture, "verdict", pixel))) == Verdict::hit;
}
int count_of(const Picture& picture, int surface) {
    int count = 0;
    for (const float index : picture.frame.find("surface")->samples) count += int(index) == surface;
    return count;
}

// Pixels that truth says are wrong, of the place or of the surface.
int wrong(const scene::Scene& scene, const Picture& picture) {
    const scene::SceneAt now = scene::in_formula_coordinates(scene::at_frame(scene, 1));
    const int width = scene.output.width, height = scene.output.height;
    const roots::Truth truth = roots::certify(scene, now, width, height);
    const roots::Tubes tubes({now, 0}, width, height);
    int wrong = 0;
    for (int k = 0; k < width * height; ++k) {
        const auto at = std::size_t(k);
        const roots::Tube tube = tubes.at(k % width, k / width);
        const glm::dvec3 p(value(picture, "P.X", at), value(picture, "P.Y", at),
                           value(picture, "P.Z", at));
        const roots::FirstRoot& root = truth.roots[at];
        const bool hit = is_hit(picture, at);
        const double t = glm::dot(p - tube.anchor, tube.direction);
        const roots::Fault fault = roots::judge(root, hit, t, tube.footprint);
        wrong += fault != roots::Fault::none && fault != roots::Fault::undecided;
        const bool knows = hit && root.answer == roots::Answer::hit && root.surface >= 0;
        wrong += knows && int(value(picture, "surface", at)) != root.surface + 1;
    }
    return wrong;
}

TEST(Surfaces, TheNearestIsSeenAsTruthHasIt) {
    for (const char* method : {"hermite", "interval", "affine"}) {
        SCOPED_TRACE(method);
        const scene::Scene scene = scene_of(
            ball("left", "[-0.6, 0, 0]", 1) +
            ball("right", "[0.6, -0.3, 0.1]", 0.9,
                 fmt::format("isolation = {{ method = \"{}\" }}", method)) +
            "[[surfaces]]\nname = \"turned\"\nformula = \"x^4 + y^4 + z^4 - 0.4\"\nbounds = { box "
            "= "
            "[[-0.9, -0.9, -0.9], [0.9, 0.9, 0.9]] }\ntransform = { translate = [0, -0.8, 0.5], "
            "rotate = [20, 30, 40], scale = 0.8 }\n" +
            view);
        const Picture picture = drawn(scene);
        EXPECT_EQ(wrong(scene, picture), 0);
        for (int k = 1; k <= 3; ++k) EXPECT_GT(count_of(picture, k), 50) << k;
    }
}

TEST(Surfaces, OneByItselfIsTheSameAmongOthersThatAreElsewhere) {
    const scene::Scene one =
        scene_of("[surface]\nformula = \"x^2 + y^2 + z^2 - 1\"\nbounds = { sphere = 1.1 }\n" +
                 std::string(view));
    const scene::Scene among =
        scene_of("[[surfaces]]\nformula = \"x^2 + y^2 + z^2 - 1\"\nbounds = { sphere = 1.1 }\n" +
                 ball("behind the eye", "[0, -20, 0]", 1) + view);
    const Picture alone = drawn(one), with_other = drawn(among);
    EXPECT_EQ(alone.frame.find("verdict")->samples, with_other.frame.find("verdict")->samples);
    for (const char* layer : {"R", "G", "B", "A", "P.X", "P.Y", "P.Z", "N.X", "N.Y", "N.Z", "Z"}) {
        for (std::size_t k = 0; k < 64 * 64; ++k) {
            const float mine = value(alone, layer, k), among_all = value(with_other, layer, k);
            if (mine != among_all) { // both may be infinite
                ASSERT_NEAR(mine, among_all, 1e-5) << layer;
            }
        }
    }
}

// One draw a surface, or passes: cubics may take other steps by last bits of F.
TEST(Surfaces, PlainOnesTakeADrawEachAndLookAsInPasses) {
    const std::string quartic =
        "[[surfaces]]\nname = \"turned\"\nformula = \"x^4 + y^4 + z^4 - 0.4\"\nbounds = { sphere = "
        "1.6 }\nisolation = { method = \"affine\" }\ntransform = { translate = [0, -0.8, 0.5], "
        "rotate = [20, 30, 40] }\n";
    const std::string balls =
        ball("left", "[-0.6, 0, 0]", 1) + ball("right", "[0.6, -0.3, 0.1]", 0.9);
    const std::string rests[] = {"",
                                 "[[sections]]\nnormal = [0, -1, 0.2]\noffset = 0.5\n[[lights]]\n"
                                 "direction = [1, -1, 1]\n[[lights]]\ndirection = [-1, 0, 1]\n"};
    for (const std::string& rest : rests) {
        const scene::Scene scene = scene_of(balls + quartic + rest + view);
        const Picture one = drawn(scene);
        EXPECT_EQ(one.passes, 3);
        for (const int evaluations : {2, 5, 50}) {
            SCOPED_TRACE(evaluations);
            const Picture passes =
                drawn(scene, StageChoice::fragment,
                      MarchPlan{64, 64, rest.empty() ? evaluations : 20 + evaluations});
            if (evaluations == 2 && rest.empty()) {
                EXPECT_GT(passes.passes, 3);
            }
            for (const image::Channel& channel : one.frame.channels) {
                const std::vector<float>& other = passes.frame.find(channel.name)->samples;
                int different = 0;
                for (std::size_t k = 0; k < other.size(); ++k) {
                    const float mine = channel.samples[k];
                    different += mine != other[k] && !(std::abs(mine - other[k]) < 1e-4f);
                }
                EXPECT_LE(different, channel.name == "evaluations" ? 60 : 2) << channel.name;
            }
        }
    }
}

// Where one hides the other, rays to the other end before they reach it, and nothing of it shows.
TEST(Surfaces, TheHiddenOneChangesNoPixelAndIsNotMarchedTo) {
    const std::string front = ball("front", "[0, 0, 0]", 1);
    const std::string behind = ball("behind", "[0, 3, -0.5]", 0.5);
    const Picture alone = drawn(scene_of(front + ball("beside", "[0, -20, 0]", 1) + view));
    for (const std::string& text : {front + behind, behind + front}) {
        const bool is_last = text.starts_with(front);
        const Picture both = drawn(scene_of(text + view));
        EXPECT_EQ(count_of(both, is_last ? 2 : 1), 0);
        if (!is_last) continue; // which then has coordinates of its own
        for (const char* layer : {"R", "G", "B", "A", "P.X", "P.Y", "P.Z", "N.X", "N.Y", "N.Z", "Z",
                                  "verdict", "evaluations"}) {
            EXPECT_EQ(alone.frame.find(layer)->samples, both.frame.find(layer)->samples) << layer;
        }
    }
}

TEST(Surfaces, WhereTheyCoincideTheEarlierIsSeen) {
    // The same sphere by another formula, and by another placement.
    const std::string other = "[[surfaces]]\nname = \"other\"\nformula = \"sqrt(x^2 + y^2 + z^2) - "
                              "1\"\nbounds = { sphere = 1.5 }\ntransform = { rotate = [10, 20, 30] "
                              "}\n";
    const std::string scaled = "[[surfaces]]\nname = \"scaled\"\nformula = \"x^2 + y^2 + z^2 - "
                               "100\"\nbounds = { sphere = 12 }\ntransform = { scale = 0.1 }\n";
    const std::string one = ball("one", "[0, 0, 0]", 1);
    for (const std::string& text : {one + other + scaled, other + scaled + one, scaled + one}) {
        const Picture picture = drawn(scene_of(text + view));
        EXPECT_GT(count_of(picture, 1), 500);
        EXPECT_EQ(count_of(picture, 2), 0);
        EXPECT_EQ(count_of(picture, 3), 0);
    }
}

TEST(Surfaces, EightWithAnEmptyOneAndOneInAnother) {
    std::string text = ball("outer", "[0, 0, 0]", 0.8) + ball("inner", "[0, 0, 0]", 0.4) +
                       "[[surfaces]]\nname = \"empty\"\nformula = \"x^2 + y^2 + z^2 + 1\"\n"
                       "bounds = { sphere = 2 }\n";
    for (int k = 0; k < 5; ++k)
        text += ball(fmt::format("ball {}", k), fmt::format("[{}, 0, 1.1]", 0.6 * (k - 2)), 0.3);
    const scene::Scene scene = scene_of(text + view);
    const Picture picture = drawn(scene);
    EXPECT_EQ(wrong(scene, picture), 0);
    EXPECT_GT(count_of(picture, 1), 100);
    EXPECT_EQ(count_of(picture, 2), 0);
    EXPECT_EQ(count_of(picture, 3), 0);
    for (int k = 4; k <= 8; ++k) EXPECT_GT(count_of(picture, k), 10) << k;
}

TEST(Surfaces, AreSeenBySectionsAndCut) {
    const scene::Scene scene =
        scene_of(ball("left", "[-0.5, 0, 0]", 1) + ball("right", "[0.5, 0, 0]", 1) +
                 "[[sections]]\nnormal = [0, -1, 0]\noffset = 0.3\n" + view);
    const Picture picture = drawn(scene);
    EXPECT_EQ(wrong(scene, picture), 0);
    EXPECT_GT(count_of(picture, 1), 100);
    EXPECT_GT(count_of(picture, 2), 100);
}

// A small ball between the light and a large one: on the large one the shadow is where the line to
// the light meets the small one.
TEST(Surfaces, CastShadowsOnEachOther) {
    const std::string balls[] = {ball("large", "[0, 0, 0]", 1),
                                 ball("small", "[0, -0.4, 1.8]", 0.35)};
    for (const bool turned : {false, true}) {
        SCOPED_TRACE(turned);
        const scene::Scene scene = scene_of(
            balls[turned ? 1 : 0] + balls[turned ? 0 : 1] +
            "[[lights]]\ndirection = [0, 0, 1]\nshadow = true\n[material]\ncolor = [1, 1, 1]\n" +
            std::string(view));
        const Picture picture = drawn(scene);
        int checked = 0, in_shadow = 0;
        for (std::size_t k = 0; k < 64 * 64; ++k) {
            const int large = turned ? 2 : 1;
            if (int(value(picture, "surface", k)) != large) continue;
            // Positions and normals are in the first one's coordinates.
            const glm::dvec3 n(value(picture, "N.X", k), value(picture, "N.Y", k),
                               value(picture, "N.Z", k));
            const double off = std::hypot(n.x, n.y + 0.4); // of the line to the light
            if (n.z < 0.05 || std::abs(off - 0.35) < 0.03) continue;
            const bool hidden = off < 0.35;
            EXPECT_NEAR(value(picture, "R", k), hidden ? 0.12 : 0.12 + n.z, 0.01);
            ++checked;
            in_shadow += hidden;
        }
        EXPECT_GT(checked, 200);
        EXPECT_GT(in_shadow, 20);
    }
}

// A flat mirror, a cube's face, shows the ball behind it as its mirror image.
TEST(Surfaces, AreSeenInMirrors) {
    const std::string cube =
        "[[surfaces]]\nname = \"mirror\"\nformula = \"max(abs(x), max(abs(y), abs(z))) - 1\"\n"
        "bounds = { sphere = 2 }\ntransform = { translate = [0, 0, -1] }\nmaterial = { model = "
        "\"ggx\", metallic = 1, color = [1, 1, 1], roughness = 0.1, reflection = \"self\" }\n";
    const std::string red = ball("red", "[0, 0, 0.5]", 0.3, "material = { color = [1, 0, 0] }");
    const std::string look =
        "[camera]\nposition = [0, -4, 2]\ntarget = [0, 0, 0]\n[output]\nsize = "
        "[64, 64]\nbackground = [0, 0, 1]\n";
    for (const std::string& text : {cube + red, red + cube}) {
        const scene::Scene scene = scene_of(text + look);
        const Picture picture = drawn(scene);
        const int mirror = text.starts_with(cube) ? 1 : 2;
        const scene::SceneAt now = scene::in_formula_coordinates(scene::at_frame(scene, 1));
        // World coordinates less the first surface's translation.
        const glm::dvec3 first = mirror == 1 ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 0, 0.5);
        int checked = 0, seen = 0;
        for (std::size_t k = 0; k < 64 * 64; ++k) {
            if (int(value(picture, "surface", k)) != mirror || value(picture, "N.Z", k) < 0.99)
                continue;
            const glm::dvec3 p(value(picture, "P.X", k), value(picture, "P.Y", k),
                               value(picture, "P.Z", k));
            glm::dvec3 way = glm::normalize(p - now.camera.position);
            way.z = -way.z;
            const glm::dvec3 from = glm::dvec3(0, 0, 0.5) - first - p; // to the ball's middle
            const double along = glm::dot(from, way), off = glm::length(from - along * way);
            if (along < 0 || std::abs(off - 0.3) < 0.04) continue;
            const bool is_red = value(picture, "R", k) > value(picture, "B", k);
            EXPECT_EQ(is_red, off < 0.3);
            ++checked;
            seen += is_red;
        }
        EXPECT_GT(checked, 200);
        EXPECT_GT(seen, 20);
    }
}

TEST(Surfaces, TakeLightFromAroundOfEachOther) {
    const std::string floor =
        "[[surfaces]]\nname = \"floor\"\nformula = \"z\"\nbounds = { box = [[-2, "
        "-2, -0.5], [2, 2, 0.5]] }\nmaterial = { color = [1, 1, 1] }\n";
    const std::string rest =
        "[occlusion]\nradius = 0.5\n[[lights]]\ndirection = [0, 0, -1]\n[ambient]"
        "\ntop = [1, 1, 1]\n" +
        std::string(view);
    const Picture picture = drawn(scene_of(floor + ball("above", "[0, 0, 0.4]", 0.3) + rest));
    double near = 1, far = 0;
    for (std::size_t k = 0; k < 64 * 64; ++k) {
        if (int(value(picture, "surface", k)) != 1) continue;
        const double off = std::hypot(value(picture, "P.X", k), value(picture, "P.Y", k));
        const double light = value(picture, "R", k);
        if (off < 0.25) near = std::min(near, light);
        if (off > 1.2) far = std::max(far, light);
    }
    EXPECT_LT(near, 0.75);
    EXPECT_NEAR(far, 1, 1e-3);
}

TEST(Surfaces, ComputeShadersAndBeamsSeeTheSame) {
    const std::string text = ball("left", "[-0.6, 0, 0]", 1) +
                             ball("right", "[0.6, -0.3, 0.1]", 0.9) +
                             "[[lights]]\ndirection = [1, -1, 1]\nshadow = true\n" + view;
    for (const char* beam : {"false", "true"}) {
        SCOPED_TRACE(beam);
        const scene::Scene scene = scene_of(text + fmt::format("[isolation]\nbeam = {}\n", beam));
        const Picture by_fragments = drawn(scene);
        EXPECT_EQ(wrong(scene, by_fragments), 0);
        if (!context_of_surfaces().info().has(4, 3)) continue; // no compute shaders
        const Picture by_compute = drawn(scene, StageChoice::compute);
        for (std::size_t c = 0; c < by_fragments.frame.channels.size(); ++c) {
            if (by_fragments.frame.channels[c].name == "evaluations") continue;
            EXPECT_EQ(by_fragments.frame.channels[c].samples, by_compute.frame.channels[c].samples)
                << by_fragments.frame.channels[c].name;
        }
    }
}

TEST(Surfaces, FarFromTheOriginAndFarFromTheEyeTheNearestIsKnown) {
    for (const double far : {0.0, 1e6}) {
        const auto at = [&](double x, double y) { return fmt::format("[{}, {}, 0]", far + x, y); };
        const scene::Scene scene = scene_of(
            ball("back", at(0, 0), 1) + ball("front", at(0.3, -0.1), 1) +
            fmt::format("[camera]\nposition = [{0}, -1000000, 0]\ntarget = [{0}, 0, 0]\nfov = "
                        "0.00015\n[output]\nsize = [64, 64]\n",
                        far));
        const Picture picture = drawn(scene);
        EXPECT_EQ(wrong(scene, picture), 0) << far;
        EXPECT_GT(count_of(picture, 1), 100);
        EXPECT_GT(count_of(picture, 2), 100);
    }
}

TEST(Surfaces, SettingsChangeAlike) {
    const auto scene_with = [](double step, double other) {
        const char* marching = "isolation = {{ method = \"marching\", step = {} }}";
        return scene_of(
            ball("one", "[-1, 0, 0]", 0.5, fmt::format(fmt::runtime(marching), step)) +
            ball("other", "[1, 0, 0]", 0.5, fmt::format(fmt::runtime(marching), other)) + view);
    };
    const auto renderer_of = [](const scene::Scene& scene) {
        RenderOptions options{64, 64, {Channel::surface}, {}};
        return Renderer(context_of_surfaces(), scene, options);
    };
    const auto evaluations = [](Renderer& renderer, const scene::Scene& scene) {
        return renderer.draw(scene::in_formula_coordinates(scene::at_frame(scene, 1)))
            .evaluations();
    };
    const scene::Scene fine = scene_with(0.01, 0.02), coarse = scene_with(0.04, 0.08);
    Renderer adjusted = renderer_of(fine), anew = renderer_of(coarse);
    const auto before = evaluations(adjusted, fine);
    adjusted.adjust(coarse.surfaces[0].isolation);
    const auto after = evaluations(adjusted, fine);
    EXPECT_LT(after, before);
    EXPECT_EQ(after, evaluations(anew, coarse));
    adjusted.adjust(fine.surfaces[0].isolation);
    EXPECT_EQ(evaluations(adjusted, fine), before);
}

} // namespace
} // namespace isomotion::render::surfaces_test
