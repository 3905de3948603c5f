// Shadows of the catalogue against certified truth: nothing that is lit is dark, nothing hidden is
// lit.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "render/drawing.h"
#include "roots/first_root.h"

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

INSTANTIATE_TEST_SUITE_P(Surfaces, CatalogueShadow, testing::ValuesIn(surfaces_in_balls()),
                         [](const auto& tested) { return tested.param; });

} // namespace
} // namespace isomotion::render::shadow_test
