// Lists of the elements that matter in a beam leave out none that shows. By proofs, whose hits do
// not depend on where a ray begins, as those of cubics do.
#include "render/drawing.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "scene/reading/load.h"
#include "shader/assemble.h"
#include "thorough.h"

namespace isomotion::render::lists_test {
namespace {

// What beams take away. They may add: cubics step over small blobs where they begin far off.
struct Difference {
    int hits = 0, lost = 0;
    // The most, along the surface's normal, as a part of the bounds' radius: how far off a rounding
    // of F is along a ray that grazes the surface is the ray's doing.
    double behind = 0;
};

class Lists : public Drawing {
protected:
    Difference compare(const scene::Scene& scene, int frame, bool expect_lists = true,
                       scene::Method method = scene::Method::interval) {
        scene::Scene plain = scene, beams = scene;
        plain.surfaces[0].isolation.method = beams.surfaces[0].isolation.method = method;
        plain.surfaces[0].isolation.beam = false;
        beams.surfaces[0].isolation.beam = true;
        EXPECT_EQ(shader::assemble(beams).arrays.at(0).has_lists, expect_lists);
        return difference(draw(*context, plain, frame), draw(*context, beams, frame),
                          scene::at_frame(scene, frame));
    }

    static Difference difference(const Picture& plain, const Picture& beams,
                                 const scene::SceneAt& now) {
        Difference result;
        const auto channel = [](const Picture& picture, const char* name) {
            return std::span<const float>(picture.frame.find(name)->samples);
        };
        const auto a = channel(plain, "verdict"), b = channel(beams, "verdict");
        const double radius = now.surfaces[0].bounds.radius * now.surfaces[0].placement.scale;
        for (std::size_t k = 0; k < a.size(); ++k) {
            if (Verdict(int(a[k])) != Verdict::hit) continue;
            result.lost += a[k] != b[k];
            if (a[k] != b[k]) continue;
            ++result.hits;
            const glm::dvec3 place(channel(plain, "P.X")[k], channel(plain, "P.Y")[k],
                                   channel(plain, "P.Z")[k]);
            const glm::dvec3 normal(channel(plain, "N.X")[k], channel(plain, "N.Y")[k],
                                    channel(plain, "N.Z")[k]);
            const double cosine =
                std::abs(glm::dot(normal, glm::normalize(place - now.camera.position)));
            const double behind = channel(beams, "Z")[k] - channel(plain, "Z")[k];
            result.behind = std::max(result.behind, cosine * behind / radius);
        }
        return result;
    }
};
ISOMOTION_ON_EVERY_BACKEND(Lists);

// Blobs of a falling kind in a ball, `formula` of their sum.
std::string blobs(int count, const std::string& formula, const std::string& more = {}) {
    return fmt::format(R"toml([surface]
formula = "{}"
bounds = {{ sphere = 2 }}
[arrays.blobs]
count = {}
cx = "2.4*random(i, 0) - 1.2"
cy = "2.4*random(i, 1) - 1.2"
cz = "2.4*random(i, 2) - 1.2"
[camera]
azimuth = 30
elevation = 20
[output]
size = [97, 61]
{})toml",
                       formula, count, more);
}

constexpr const char* distance = "((x-cx)^2 + (y-cy)^2 + (z-cz)^2)";

std::string gaussian(double sharpness, double threshold) {
    return fmt::format("sum(blobs, exp(-{}*{})) - {}", sharpness, distance, threshold);
}

TEST_P(Lists, OfTheMovingBlobs) {
    const std::vector<std::string> names{"blobby75", "wyvill_soft_objects", "blinn_inverse_square"};
    for (const auto& [name, frame] : pairs_of(names, std::vector{1, 38, 61, 90})) {
        SCOPED_TRACE(fmt::format("{} frame {}", name, frame));
        const Difference found =
            compare(scene::load(name, {"look=none", "output.size=[97,61]"}), frame);
        EXPECT_GT(found.hits, 300);
        EXPECT_LE(found.lost, 1);
        EXPECT_LT(found.behind, 1e-5);
    }
}

TEST_P(Lists, OfThousandsOfElements) {
    const Difference found = compare(scene_of(blobs(2000, gaussian(200, 0.3))), 1);
    EXPECT_GT(found.hits, 500);
    EXPECT_LE(found.lost, 1);
    EXPECT_LT(found.behind, 1e-5);
}

// So wide that all matter everywhere, in so large a picture, nearly all of it outside of the
// bounds, that the two lower levels have no room for lists of 300: beams go on with all elements.
TEST_P(Lists, TooLongOnesAreLeftOut) {
    for (const double sharpness : {0.5, 3.0, 12.0}) {
        const double threshold = sharpness < 1 ? 75 : sharpness < 10 ? 20 : 3;
        std::string text = blobs(300, gaussian(sharpness, threshold));
        text.replace(text.find("[97, 61]"), 8, "[1100, 1100]");
        text.replace(text.find("elevation"), 0, "zoom = 0.07\n");
        const Difference found = compare(scene_of(text), 1);
        EXPECT_GT(found.hits, 300) << sharpness;
        EXPECT_LE(found.lost, 1) << sharpness;
        EXPECT_LT(found.behind, 1e-5) << sharpness;
    }
}

// Formulas that are linear in their sum have lists, whatever the terms.
TEST_P(Lists, OfSumsInOtherFormulas) {
    const std::string d = distance;
    for (const std::string& formula : {
             // compact support, and a plane where the sums are 0
             "sum(blobs, max(0, 1 - 8*" + d + ")^3) - 0.2",
             "z - 0.3 + sum(blobs, max(0, 1 - 20*" + d + ")^3)",
             // poles
             "sum(blobs, 0.01/" + d + ") - 3",
             // large terms that cancel
             "sum(blobs, cx*cy*exp(-20*" + d + ")) + 0.05*x",
         }) {
        const Difference found = compare(scene_of(blobs(75, formula)), 1);
        EXPECT_GT(found.hits, 100) << formula;
        EXPECT_LE(found.lost, 1) << formula;
        EXPECT_LT(found.behind, 1e-5) << formula;
    }
}

// Where nothing tells how large a sum is at a root, all elements stay, and beams lose nothing.
TEST_P(Lists, OthersHaveNone) {
    const std::string d = distance;
    for (const std::string& formula :
         {"1/sum(blobs, 0.01/(" + d + " + 1e-6)) - 0.4",
          "log(sum(blobs, exp(-20*" + d + "))) + 20*z",
          "sum(blobs, cx*exp(-4*" + d + "))/sum(blobs, exp(-4*" + d + ")) - 0.2"}) {
        const Difference found = compare(scene_of(blobs(75, formula)), 1, false);
        EXPECT_GT(found.hits, 100) << formula;
        EXPECT_LE(found.lost, 1) << formula;
        EXPECT_LT(found.behind, 1e-5) << formula;
    }
}

// Eight elements or fewer need no lists, and there may be none at a time.
TEST_P(Lists, OfFewElements) {
    for (const int count : {1, 8, 9}) {
        const Difference found = compare(scene_of(blobs(count, gaussian(4, 0.5))), 1, count > 8);
        EXPECT_GT(found.hits, 100) << count;
        EXPECT_EQ(found.lost, 0) << count;
        EXPECT_LT(found.behind, 1e-5) << count;
    }
}

// One renderer over frames whose numbers of elements differ: no list is left from the frame before.
TEST_P(Lists, FollowANumberOfElementsThatChanges) {
    const scene::Scene scene =
        scene_of(blobs(75, gaussian(30, 0.5), "[isolation]\nmethod = \"hermite\"\nbeam = true\n"));
    scene::Scene plain = scene;
    plain.surfaces[0].isolation.beam = false;
    Renderer with(*context, scene, {97, 61, every_channel, {}});
    Renderer without(*context, plain, {97, 61, every_channel, {}});
    for (const int count : {75, 3, 0, 40, 1, 75}) {
        SCOPED_TRACE(count);
        scene::SceneAt now = scene::at_frame(scene, 1);
        now.surfaces[0].bindings.arrays[0].count = count;
        for (auto& field : now.surfaces[0].bindings.arrays[0].fields)
            field.resize(std::size_t(count));
        const Difference found = difference(without.draw(now), with.draw(now), now);
        EXPECT_EQ(found.hits > 0, count > 0);
        EXPECT_LE(found.lost, 1);
        EXPECT_LT(found.behind, 1e-5);
    }
}

} // namespace
} // namespace isomotion::render::lists_test
