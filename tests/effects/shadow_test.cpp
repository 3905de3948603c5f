// Shadow rays: nothing that is lit is dark, nothing hidden is lit.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "render/drawing.h"
#include "render/exposure.h"
#include "roots/first_root.h"
#include "scene/method.h"

namespace isomotion::render::shadow_test {
namespace {

gpu::Context& context() {
    static const auto it = gpu::Context::create();
    return *it;
}

const std::vector<float>& layer(const Picture& picture, const char* name) {
    return picture.frame.find(name)->samples;
}

glm::dvec3 vector_at(const Picture& picture, const char* prefix, std::size_t pixel) {
    glm::dvec3 v;
    for (int k = 0; k < 3; ++k) {
        v[k] = layer(picture, fmt::format("{}.{}", prefix, "XYZ"[k]).c_str())[pixel];
    }
    return v;
}

bool is_hit(const Picture& picture, std::size_t pixel) {
    return Verdict(int(layer(picture, "verdict")[pixel])) == Verdict::hit;
}

// White, under one white light, so that a pixel's red is 0.12 and what the light adds.
std::string white(const std::string& surface, const std::string& light, bool shadow,
                  const std::string& more = {}) {
    return fmt::format("[surface]\n{}\n[material]\ncolor = [1, 1, 1]\nback_color = [1, 1, 1]\n"
                       "[[lights]]\n{}\nshadow = {}\n[output]\nsize = [96, 96]\n{}",
                       surface, light, shadow, more);
}

// Pixels whose colours differ, by default by more than rounding.
std::int64_t different(const Picture& a, const Picture& b, float by = 1e-6f) {
    std::int64_t count = 0;
    for (std::size_t k = 0; k < layer(a, "R").size(); ++k) {
        count += std::abs(layer(a, "R")[k] - layer(b, "R")[k]) > by;
    }
    return count;
}

constexpr const char* ball = "formula = \"x^2 + y^2 + z^2 - 1\"\nbounds = { sphere = 1.5 }";

class ConvexShadow : public testing::TestWithParam<std::string> {};

// A convex surface hides nothing of itself, wherever the light is: neither acne nor a terminator
// that is not where N.L = 0. Each pixel has the light that its own normal tells.
TEST_P(ConvexShadow, HidesNothingOfItself) {
    const std::string view = "[camera]\nposition = [2.1, 1.4, 1.1]\n";
    struct Light {
        const char* key;
        glm::dvec3 at;
    };
    const Light lights[] = {{"position", {1.2, 0.9, 2}},
                            {"direction", {2.1, 1.4, 1.1}},
                            {"direction", {-1, 0.3, 0.2}},
                            {"direction", {0, 0, 1}}};
    const auto text = [](const Light& light) {
        return fmt::format("{} = [{}, {}, {}]", light.key, light.at.x, light.at.y, light.at.z);
    };
    // Taylor's test sees roots beyond the edges too; no surface is there to be lit.
    const Picture certain =
        draw(context(), scene_of(white(GetParam(), text(lights[0]), false, view)));
    for (const char* method :
         {"hermite", "amp-sign", "marching", "amp-taylor", "interval", "affine", "sphere"}) {
        for (const Light& light : lights) {
            SCOPED_TRACE(fmt::format("{}, {}", text(light), method));
            const std::string more = view + fmt::format("[isolation]\nmethod = \"{}\"\n", method);
            const Picture lit =
                draw(context(), scene_of(white(GetParam(), text(light), true, more)));
            EXPECT_GT(count(lit, Verdict::hit), 1000);
            const auto vector = [&](std::string of, std::size_t k) {
                return glm::dvec3(layer(lit, (of + ".X").c_str())[k],
                                  layer(lit, (of + ".Y").c_str())[k],
                                  layer(lit, (of + ".Z").c_str())[k]);
            };
            int changed = 0;
            for (std::size_t k = 0; k < layer(lit, "R").size(); ++k) {
                if (!is_hit(certain, k) || !is_hit(lit, k)) continue;
                const bool is_far = light.key == std::string_view("direction");
                const glm::dvec3 to =
                    glm::normalize(light.at - (is_far ? 0.0 : 1.0) * vector("P", k));
                const double wanted = 0.12 + std::max(glm::dot(vector("N", k), to), 0.0);
                changed += std::abs(layer(lit, "R")[k] - wanted) > 1e-6;
            }
            EXPECT_EQ(changed, 0);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, ConvexShadow,
    testing::Values(ball, "formula = \"x^4 + y^4 + z^4 - 1\"\nbounds = { sphere = 1.5 }",
                    "formula = \"abs(x) + abs(y) + abs(z) - 1.2\"\nbounds = { sphere = 1.3 }",
                    "formula = \"x^2 + 4*y^2 + 9*z^2 - 1\"\nbounds = { sphere = 1.3 }",
                    "formula = \"1e6*(x^2 + y^2 + z^2 - 1)\"\nbounds = { sphere = 1.5 }"));

TEST(Shadow, OfASphereOnTheGroundIsAnEllipse) {
    // Lit along (1, 0, 1), the unit sphere's shadow on z = -1.2 is the ellipse about (-1.2, 0) with
    // half axes sqrt(2) and 1.
    const Picture picture = draw(
        context(), scene_of(white(ball, "direction = [1, 0, 1]", true,
                                  "[ground]\nheight = -1.2\ncolor = [1, 1, 1]\n[camera]\n"
                                  "position = [0.001, 0, 12]\ntarget = [0, 0, 0]\nup = [0, 1, 0]\n"
                                  "projection = \"orthographic\"\nheight = 8\n")));
    int inside = 0, wrong = 0;
    for (int row = 0; row < 96; ++row) {
        for (int column = 0; column < 96; ++column) {
            const auto pixel = std::size_t(row * 96 + column);
            if (is_hit(picture, pixel)) continue;
            const double x = 8 * ((column + 0.5) / 96 - 0.5), y = 8 * (0.5 - (row + 0.5) / 96);
            const double r = std::hypot((x + 1.2) / std::sqrt(2.0), y);
            if (std::abs(r - 1) < 0.03) continue; // a third of a pixel
            const double expected = 0.12 + (r < 1 ? 0.0 : std::sqrt(0.5));
            inside += r < 1;
            wrong += std::abs(layer(picture, "R")[pixel] - expected) > 1e-4;
        }
    }
    EXPECT_GT(inside, 200);
    EXPECT_EQ(wrong, 0);
}

TEST(Shadow, ALightBehindASurfaceDoesNotReachThroughIt) {
    // Inside a closed shell with the light outside, everything is dark.
    const Picture picture =
        draw(context(), scene_of(white(ball, "direction = [0.3, 0.2, 1]", true,
                                       "[camera]\nposition = [0, 0, 0]\ntarget = [0, 1, 0.2]\n")));
    EXPECT_EQ(count(picture, Verdict::hit), 96 * 96);
    for (const float red : layer(picture, "R")) ASSERT_NEAR(red, 0.12, 1e-6);
}

TEST(Shadow, APointLightCastsNoneFromBehindItself) {
    // Between the two spheres: each is lit as if the other were not there.
    const std::string pair =
        "formula = \"min((x - 1.5)^2, (x + 1.5)^2) + y^2 + z^2 - 0.5\"\nbounds = { sphere = 2.5 }";
    const std::string camera = "[camera]\nposition = [0, -9, 3]\n";
    const std::string light = "position = [0, 0, 0]\nfalloff = 1";
    const Picture with = draw(context(), scene_of(white(pair, light, true, camera)));
    const Picture without = draw(context(), scene_of(white(pair, light, false, camera)));
    EXPECT_GT(count(with, Verdict::hit), 200);
    EXPECT_EQ(different(with, without), 0);
    // From beyond one of them, the other is in the dark.
    const std::string beyond = "position = [4, 0, 0]";
    const Picture hidden = draw(context(), scene_of(white(pair, beyond, true, camera)));
    int left = 0, lit = 0;
    for (std::size_t k = 0; k < layer(hidden, "R").size(); ++k) {
        if (!is_hit(hidden, k) || layer(hidden, "P.X")[k] > 0) continue;
        ++left;
        lit += layer(hidden, "R")[k] > 0.1201f;
    }
    EXPECT_GT(left, 100);
    EXPECT_EQ(lit, 0);
}

// A place is lit by the sum of what each light alone would give it, its shadow included.
TEST(Shadow, OfSeveralLightsAddUp) {
    const std::vector<std::string> lights{"direction = [1, 2, 3]", "position = [0, 4, 1]",
                                          "direction = [3, -1, 1]"};
    const auto torus = [](const char* method, std::span<const std::string> lit) {
        std::string text =
            fmt::format("[surface]\nformula = \"(x^2 + y^2 + z^2 + 0.6)^2 - 2.6*(x^2 + z^2)\"\n"
                        "bounds = {{ sphere = 2 }}\n[material]\ncolor = [1, 1, 1]\n[isolation]\n"
                        "method = \"{}\"\n[camera]\nposition = [3, 2, 3]\n[output]\n"
                        "size = [96, 96]\n",
                        method);
        for (const std::string& light : lit) text += "[[lights]]\n" + light + "\nshadow = true\n";
        return scene_of(text);
    };
    for (const auto& method : scene::method_traits) {
        const std::string name(method.name);
        SCOPED_TRACE(name);
        const Picture all = draw(context(), torus(name.c_str(), lights));
        std::vector<Picture> alone;
        for (const std::string& light : lights) {
            alone.push_back(draw(context(), torus(name.c_str(), std::span(&light, 1))));
        }
        EXPECT_GT(count(all, Verdict::hit), 1000);
        int wrong = 0;
        std::int64_t evaluations = 0; // the eye's rays are in each of the three
        for (const Picture& picture : alone) evaluations += picture.evaluations();
        for (std::size_t k = 0; k < layer(all, "R").size(); ++k) {
            if (!is_hit(all, k)) continue;
            double sum = 0.12;
            for (const Picture& picture : alone) sum += layer(picture, "R")[k] - 0.12;
            wrong += std::abs(layer(all, "R")[k] - sum) > 1e-5;
        }
        EXPECT_EQ(wrong, 0);
        EXPECT_LE(all.evaluations(), evaluations);
    }
}

// Along a crease, cubics doubt touches that bounds must judge. A shadow ray that forgets so stands
// still up to its limit, and draws wait for it.
TEST(ShadowRays, StandStillNowhere) {
    std::int64_t most = 0;
    for (const auto& [m, n] : {std::pair(0.4, 2.5), {0.67, 0.5}, {1.6, 0.9}}) {
        const std::string formula =
            fmt::format("(abs(x)^{0} + abs(y)^{0})^{1} + abs(z)^{2} - 1", m, n / m, n);
        SCOPED_TRACE(formula);
        const Picture picture =
            draw(context(),
                 scene_of(fmt::format("[surface]\nformula = '{}'\nbounds = {{ sphere = 1.8 }}\n"
                                      "[[lights]]\ndirection = [0.3, 1, 0.4]\nshadow = true\n"
                                      "[[lights]]\ndirection = [1, -0.1, 0.02]\nshadow = true\n"
                                      "[camera]\nposition = [2.5, 2, 1.6]\n"
                                      "[output]\nsize = [128, 128]\n",
                                      formula)));
        const RayCount shadow = picture.rays[std::size_t(RayKind::shadow)];
        EXPECT_GT(shadow.evaluations, 0);
        EXPECT_EQ(shadow.undecided, 0) << "at " << shadow.column << ", " << shadow.row;
        most = std::max(most, shadow.most);
    }
    EXPECT_LT(most, 800); // of two rays
}

// The penumbrae of a wide light along creases, sampled 1,024 times: rays that go by cubics, and end
// undecided after some evaluations, see what rays that go by bounds alone see.
TEST(ShadowRays, OfWideLightsAreThoseOfBounds) {
    const auto exposed = [](const std::string& formula, const char* method) {
        const scene::Scene scene =
            scene_of(fmt::format("[surface]\nformula = '{}'\nbounds = {{ sphere = 1.8 }}\n"
                                 "[isolation]\nmethod = '{}'\n[material]\ncolor = [1, 1, 1]\n"
                                 "[[lights]]\ndirection = [0.3, 1, 0.4]\nradius = 9\n"
                                 "color = [1, 1, 1]\nshadow = true\n"
                                 "[camera]\nposition = [2.5, 2, 1.6]\n"
                                 "[output]\nsize = [24, 24]\nsamples = 1024\n",
                                 formula, method));
        Renderer renderer(context(), scene, {.width = 24, .height = 24});
        return expose(renderer, scene, 1);
    };
    for (const char* formula : {"(abs(x)^0.4 + abs(y)^0.4)^6.25 + abs(z)^2.5 - 1",
                                "max(abs(x) + abs(y) - 1, min(abs(z) - 0.2, x^2 + z^2 - 0.3))"}) {
        SCOPED_TRACE(formula);
        const Picture cubics = exposed(formula, "hermite"), bounds = exposed(formula, "interval");
        EXPECT_GT(cubics.rays[std::size_t(RayKind::shadow)].evaluations, 0);
        // Four rays of 1,024 may lie on an edge.
        EXPECT_EQ(different(cubics, bounds, 4 / 1024.0f), 0);
    }
}

// What certified truth says of the way from a hit to the light.
class TrueShadow {
public:
    TrueShadow(const scene::Scene& scene, const scene::SceneAt& now)
        : now_(now)
        , programs_(formula::enclosure_programs(*scene.surfaces[0].field))
        , finder_(programs_, now.surfaces[0]) {}

    roots::FirstRoot root(const glm::dvec3& from, const glm::dvec3& direction, double radius) {
        roots::Tube tube;
        tube.anchor = from;
        tube.direction = direction;
        tube.radius = radius;
        tube.direction_radius = 1e-6;
        tube.footprint = 8 * radius;
        tube.near = tube.near_inside = 0;
        // Beyond the bounds nothing is drawn.
        const glm::dvec3 way = from - now_.surfaces[0].bounds.centre;
        const double b = glm::dot(way, direction);
        const double c =
            glm::dot(way, way) - now_.surfaces[0].bounds.radius * now_.surfaces[0].bounds.radius;
        tube.far = tube.far_inside = -b + std::sqrt(std::max(0.0, b * b - c));
        roots::FirstRoot found;
        finder_.find(std::span(&tube, 1), std::span(&found, 1));
        return found;
    }

private:
    const scene::SceneAt& now_;
    formula::EnclosurePrograms programs_;
    roots::RootFinder finder_;
};

std::vector<std::string> surfaces_in_balls() {
    std::vector<std::string> names;
    for (const auto& file :
         std::filesystem::directory_iterator(ISOMOTION_SOURCE_DIR "/animations/surfaces")) {
        const std::string name = file.path().stem();
        const scene::Scene scene = scene_of("[surface]\nuse = \"" + name + "\"\n");
        // Truth needs minutes for these; boxes end elsewhere than TrueShadow.
        if (scene.surfaces[0].bounds.shape == scene::Bounds::Shape::sphere &&
            name != "sarti_dodecic") {
            names.push_back(name);
        }
    }
    std::sort(names.begin(), names.end());
    return names;
}

class CatalogueShadow : public testing::TestWithParam<std::string> {};

TEST_P(CatalogueShadow, IsWhatTruthSays) {
    const glm::dvec3 light = glm::normalize(glm::dvec3(0.4, -0.5, 1));
    const std::string use = fmt::format("use = \"{}\"", GetParam());
    const auto drawn = [&](double step) {
        return draw(
            context(),
            scene_of(white(use, "direction = [0.4, -0.5, 1]", true,
                           fmt::format("[isolation]\nstep = {}\nmethod = \"amp-sign\"\n", step))));
    };
    const scene::Scene scene = scene_of(white(use, "direction = [0.4, -0.5, 1]", true));
    const scene::SceneAt now = scene::at_frame(scene, 1);
    const Picture picture = drawn(scene.surfaces[0].isolation.step / 2);
    TrueShadow truth(scene, now);
    const double pixel = 2 * glm::length(scene::rays(now, 96, 96).up) / 96;
    int lit = 0, dark = 0, leaks = 0, acne = 0, open = 0;
    for (std::size_t k = 0; k < layer(picture, "R").size(); ++k) {
        if (!is_hit(picture, k)) continue;
        const glm::dvec3 normal = vector_at(picture, "N", k);
        const double cosine = glm::dot(normal, light);
        if (cosine < 0.05) continue; // too dark to tell by the colour
        const bool is_lit = std::abs(layer(picture, "R")[k] - (0.12 + cosine)) < 0.01;
        // From as near as the ray is drawn, and from half a pixel: where these differ, the surface
        // hides what it touches.
        bool free = true, blocked = true;
        for (const double off : {0.05, 0.5}) {
            const roots::FirstRoot root =
                truth.root(vector_at(picture, "P", k) + off * pixel * normal, light, 0.005 * pixel);
            free &= root.answer == roots::Answer::miss;
            blocked &= root.answer == roots::Answer::hit;
        }
        open += !free && !blocked;
        lit += free;
        dark += blocked;
        acne += free && !is_lit;
        leaks += blocked && is_lit;
    }
    const int certain = lit + dark;
    EXPECT_GT(certain, 100);
    EXPECT_LE(open, certain / 10);
    EXPECT_LE(acne, 2) << "of " << lit;
    EXPECT_LE(leaks, 2) << "of " << dark;
    RecordProperty("acne", acne);
    RecordProperty("leaks", leaks);
    fmt::print("{:<22} lit {:>5} dark {:>5} open {:>4} acne {:>3} leaks {:>3}\n", GetParam(), lit,
               dark, open, acne, leaks);
    // The offset comes from the gradient and the pixel: another step is another picture only where
    // the roots are others.
    const Picture finer = drawn(scene.surfaces[0].isolation.step / 4);
    EXPECT_LE(different(picture, finer, 0.03f), 96 * 96 / 200);
}

// Drivers end loops that go on for long, wherever a sum then is. All but three elements add nothing
// here, but the last takes back what the first added.
TEST(Shadow, OfSeveralLightsThroughLongSums) {
    const auto picture = [](int elements) {
        std::string text = fmt::format(R"toml(
[surface]
formula = "0.6 - sum(blobs, w*exp(-12*((x-c)^2 + y^2 + (z-0.5*c)^2)) + b)"
bounds = {{ sphere = 1.6 }}
[arrays.blobs]
count = {}
w = "1 - floor(min(1, i/3))"
c = "0.6*(min(i, 2) - 1)"
b = "5*(1 - min(1, i)) - 5*floor(i/(n - 1))"
[ground]
height = -0.7
color = [1, 1, 1]
[isolation]
method = "marching"
step = 0.02
[camera]
position = [1, -3, 2]
[output]
size = [48, 48]
)toml",
                                       elements);
        for (const char* from : {"[1, 0.2, 1]", "[-1, 0.5, 0.8]", "[0.1, -1, 0.9]"})
            text += fmt::format("[[lights]]\ndirection = {}\nshadow = true\n", from);
        return draw(context(), scene_of(text));
    };
    const Picture few = picture(3), many = picture(1500);
    EXPECT_GT(count(few, Verdict::hit), 100);
    EXPECT_EQ(different(few, many, 0.01f), 0);
}

INSTANTIATE_TEST_SUITE_P(Surfaces, CatalogueShadow, testing::ValuesIn(surfaces_in_balls()),
                         [](const auto& tested) { return tested.param; });

} // namespace
} // namespace isomotion::render::shadow_test
