// What the elements of an array measure, against closed forms.
#include "render/element_radius.h"

#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "render/drawing.h"

namespace isomotion::render {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

double least(const std::string& formula, int count, const std::string& fields, double bounds = 2) {
    const scene::Scene scene = scene_of(fmt::format(R"([surface]
formula = "{}"
bounds = {{ sphere = {} }}
[arrays.blobs]
count = {}
{}
)",
                                                    formula, bounds, count, fields));
    return least_element_radius(*scene.surfaces[0].field, scene::at_frame(scene, 1).surfaces[0]);
}

constexpr const char* anywhere =
    "cx = \"1.6*random(i, 0) - 0.8\"\ncy = \"1.6*random(i, 1) - 0.8\"\n"
    "cz = \"1.6*random(i, 2) - 0.8\"\n";
constexpr const char* squared = "((x-cx)^2 + (y-cy)^2 + (z-cz)^2)";

// The place where an element matters most is known to a 512th of the bounds, radii to an eighth.
void expect_about(double found, double radius, double bounds = 2) {
    EXPECT_GT(found, radius - bounds / 256);
    EXPECT_LT(found, 1.13 * radius + bounds / 256);
}

TEST(LeastElementRadius, OfGaussians) {
    for (const double radius : {0.04, 0.07, 0.2, 0.4}) {
        SCOPED_TRACE(radius);
        const double a = 0.7 / (radius * radius);
        expect_about(
            least(fmt::format("sum(blobs, exp({}*({} - {}))) - 1", -a, squared, radius * radius),
                  12, anywhere),
            radius);
        // Whichever side F has, and whatever its unit.
        expect_about(least(fmt::format("1e5 - sum(blobs, 1e5*exp({}*({} - {})))", -a, squared,
                                       radius * radius),
                           12, anywhere),
                     radius);
    }
}

TEST(LeastElementRadius, IsOfTheSmallest) {
    const std::string fields = std::string(anywhere) + "r = \"0.2 - 0.01*i\"\n";
    expect_about(least(fmt::format("sum(blobs, exp(1 - {}/r^2)) - 1", squared), 16, fields), 0.05);
}

TEST(LeastElementRadius, IsNeverLessThanA64thOfTheBounds) {
    EXPECT_EQ(least(fmt::format("sum(blobs, exp(1 - {}/1e-4)) - 1", squared), 9, anywhere),
              2.0 / 64);
}

TEST(LeastElementRadius, OfOnesTooWeakToMakeASurfaceIsHalfTheirReach) {
    const double a = 100;
    expect_about(least(fmt::format("sum(blobs, 0.01*exp({}*{})) - 1", -a, squared), 9, anywhere),
                 std::sqrt(std::log(2) / a));
}

TEST(LeastElementRadius, OfPolesIsWhereTheyReachTheSurface) {
    expect_about(least(fmt::format("sum(blobs, 0.01/{}) - 1", squared), 9, anywhere), 0.1);
}

TEST(LeastElementRadius, OfThinOnesIsTheirThickness) {
    expect_about(
        least("sum(blobs, exp(1 - (4*(x-cx))^2 - (y-cy)^2 - (30*(z-cz))^2)) - 1", 5, anywhere),
        1 / 30.0);
}

TEST(LeastElementRadius, IsNoneOfWideOnesNorOfNone) {
    EXPECT_EQ(least(fmt::format("sum(blobs, exp(1 - 3*{})) - 1", squared), 9, anywhere), infinite);
    EXPECT_EQ(least(fmt::format("sum(blobs, exp(1 - 400*{})) - 1", squared), 0, anywhere),
              infinite);
    EXPECT_EQ(least("sum(blobs, 0*cx*cy*cz) + x - 0.1", 3, anywhere), infinite);
    const scene::Scene sphere =
        scene_of("[surface]\nformula = \"x^2+y^2+z^2-1\"\nbounds = { sphere = 2 }\n");
    EXPECT_EQ(
        least_element_radius(*sphere.surfaces[0].field, scene::at_frame(sphere, 1).surfaces[0]),
        infinite);
}

// A term without a value somewhere, or anywhere, is no reason to step finely or not to end.
TEST(LeastElementRadius, OfWhatHasNoValueIsNone) {
    EXPECT_EQ(least("sum(blobs, sqrt(-1 - cx^2 - cy^2 - cz^2 - x^2)) - 1", 3, anywhere), infinite);
}

// Drops far apart in wide bounds, F flat about them: cubics hit what bounds prove is there.
class SmallElements : public Drawing {};
ISOMOTION_ON_EVERY_BACKEND(SmallElements);

TEST_P(SmallElements, AreNotSteppedOver) {
    for (const bool beam : {false, true}) {
        SCOPED_TRACE(beam);
        const auto look = [&](const char* method) {
            return draw(*context, scene_of(fmt::format(R"([surface]
formula = "sum(blobs, exp(90*(0.0072 - {}))) - 1"
bounds = {{ sphere = 2.5 }}
[arrays.blobs]
count = 60
{}[camera]
position = [9, 0, 0]
projection = "orthographic"
height = 2.6
[output]
size = [96, 96]
[isolation]
method = "{}"
beam = {}
)",
                                                       squared, anywhere, method, beam)));
        };
        const Picture cubics = look("hermite"), bounds = look("interval");
        const auto& found = cubics.frame.find("verdict")->samples;
        const auto& there = bounds.frame.find("verdict")->samples;
        int hits = 0, missed = 0;
        for (std::size_t k = 0; k < there.size(); ++k) {
            if (Verdict(int(there[k])) != Verdict::hit) continue;
            ++hits;
            missed += Verdict(int(found[k])) != Verdict::hit;
        }
        EXPECT_GT(hits, 1000);
        EXPECT_LE(missed, 2);
    }
}

// A scene whose blobs shrink and grow, and whose bounds move.
TEST(ElementRadius, IsThatOfTheTimeAsked) {
    const scene::Scene scene = scene_of(R"scene([time]
fps = 10
frames = 20
[surface]
formula = "sum(blobs, exp(1 - ((x-cx)^2 + y^2 + z^2)/r^2)) - 1"
bounds = { sphere = "2 + t" }
[parameters]
r = "0.2 + 0.1*sin(3*t)"
[arrays.blobs]
count = 3
cx = "0.5*i - 0.5"
)scene");
    ElementRadius remembered;
    for (const int frame : {1, 1, 5, 5, 12, 1}) {
        SCOPED_TRACE(frame);
        const scene::SurfaceAt now = scene::at_frame(scene, frame).surfaces[0];
        const formula::Field& field = *scene.surfaces[0].field;
        EXPECT_EQ(remembered.least(field, now), least_element_radius(field, now));
    }
}

} // namespace
} // namespace isomotion::render
