// Glass among several surfaces: matter in matter, by the closed forms of optics.
#include <cmath>

#include <fmt/format.h>

#include "effects/optics.h"
#include "render/drawing.h"

namespace isomotion::render::nested_glass_test {
namespace {

using shader::Channel;

gpu::Context& context_of_nested_glass() {
    static const auto it = gpu::Context::create();
    return *it;
}

using glm::dvec3;

// Parallel rays along y.
std::string along_y(double height) {
    return fmt::format("[camera]\nposition = [0, -5, 0]\ntarget = [0, 0, 0]\n"
                       "projection = \"orthographic\"\nheight = {}\n",
                       height);
}

std::string material(const std::string& keys) {
    return "material = { transmission = 1, " + keys + " }\n";
}
std::string ball(double radius, const std::string& more, const std::string& place = "[0, 0, 0]") {
    return fmt::format("[[surfaces]]\nformula = \"x^2 + y^2 + z^2 - {0:.17g}^2\"\nbounds = {{ "
                       "sphere = {1:.17g} }}\ntransform = {{ translate = {2} }}\n{3}",
                       radius, 1.1 * radius, place, more);
}
// A slab from y = `from` to y = `to`.
std::string slab(double from, double to, const std::string& more) {
    return fmt::format("[[surfaces]]\nformula = \"max({:.17g} - y, y - {:.17g})\"\nbounds = {{ box "
                       "= [[-9, -4, -9], [9, 4, 9]] }}\n{}",
                       from, to, more);
}
std::string seen_by(const std::string& camera, int side, const std::string& rest) {
    return fmt::format("{}{}[output]\nsize = [{}, {}]\n{}", camera, dark, side, side, rest);
}

Picture drawn(const std::string& text, const std::optional<MarchPlan>& plan = {},
              StageChoice stage = StageChoice::fragment) {
    const scene::Scene scene = scene_of(text);
    RenderOptions options{scene.output.width, scene.output.height, every_channel, {}};
    options.channels.push_back(Channel::surface);
    options.plan = plan;
    options.stage = stage;
    Renderer renderer(context_of_nested_glass(), scene, options);
    return renderer.draw(scene::at_frame(scene, 1));
}

int surface_at(const Picture& picture, std::size_t pixel) {
    return int(picture.frame.find("surface")->samples[pixel]);
}
double largest_difference(const Picture& a, const Picture& b) {
    double most = 0;
    for (std::size_t pixel = 0; pixel < a.frame.channels[0].samples.size(); ++pixel)
        for (int k = 0; k < 3; ++k)
            most = std::max(most, std::abs(color(a, pixel)[k] - color(b, pixel)[k]));
    return most;
}

// Glass in water of the same index is not there, if its matter counts, and if it is as clear.
TEST(NestedGlass, ABallInABallOfTheSameIndexIsInvisible) {
    const std::string water = ball(1, material("ior = 1.4, depth = 8"));
    const std::string elsewhere = ball(0.1, material("ior = 1.4"), "[0, -9, 0]");
    const std::string view = seen_by(along_y(2.4), 48, sky_by_height);
    const Picture alone = drawn(water + elsewhere + view);
    for (const char* place : {"[0, 0, 0]", "[0.3, 0.2, -0.1]"}) {
        const Picture with =
            drawn(water + ball(0.5, material("ior = 1.4, priority = 1"), place) + view);
        EXPECT_LT(largest_difference(alone, with), 2e-3) << place;
    }
    const Picture other = drawn(water + ball(0.5, material("ior = 1.7, priority = 1")) + view);
    EXPECT_GT(largest_difference(alone, other), 0.1);
    // Whose matter does not count is not there, whatever it is of.
    for (const std::string& text :
         {water + ball(0.5, material("ior = 1.7, priority = -1")),
          water + ball(0.5, material("ior = 1.7, absorption = [3, 3, 3]")),
          ball(0.5, material("ior = 1.7, priority = -1")) + water}) {
        EXPECT_LT(largest_difference(alone, drawn(text + view)), 2e-3);
    }
    // Where priorities are equal, the surface that is earlier in the file counts.
    EXPECT_LT(largest_difference(other, drawn(ball(0.5, material("ior = 1.7")) + water + view)),
              2e-3);
}

// Straight on, air in water is seen by its edge: total reflection beyond the critical angle.
TEST(NestedGlass, ABubbleInWaterReflectsTotally) {
    constexpr int side = 129;
    const double n = 1.33, radius = 0.5;
    // In a tank with flat walls, rays reach the bubble straight on.
    const Picture picture = drawn(slab(-1, 1, material(fmt::format("ior = {}, depth = 6", n))) +
                                  ball(radius, material("ior = 1, priority = 1")) +
                                  seen_by(along_y(1.2), side, sky_by_height));
    const double wall = fresnel(0, 1, n);
    int total = 0, through = 0;
    for (int row = 0; row < side; ++row) {
        const double z = 1.2 * (0.5 - (row + 0.5) / side);
        const double a = std::asin(std::min(1.0, std::abs(z) / radius));
        if (std::abs(z) > 0.99 * radius || std::abs(n * std::sin(a) - 1) < 0.02) continue;
        const double red = color(picture, std::size_t(row * side + side / 2)).x;
        const double sign = z < 0 ? -1 : 1;
        if (n * std::sin(a) < 1) {
            ++through;
            continue; // several parts are reflected on the way
        }
        // Turned by pi - 2a towards the side where it met; then the wall, straight or totally.
        const double turned = M_PI - 2 * a, leaves = n * std::sin(turned);
        if (leaves >= 0.98 || turned > 0.5 * M_PI) continue;
        ++total;
        const double back = fresnel(turned, n, 1);
        const double up = sign * leaves;
        const double expected =
            wall * sky({0, -1, 0}).x + // of the wall before
            (1 - wall) * (back * sky({0, 0, up}).x + (1 - back) * sky({0, 0, up}).x);
        EXPECT_NEAR(red, expected, 2e-3) << z;
    }
    EXPECT_GT(total, 4);
    EXPECT_GT(through, 20);
}

// Light that comes straight on through plates: at each face a part is reflected, which the picture
// takes to see what is around, faded again; what is reflected within fades as if it went as far.
struct Plate {
    double way, index, absorption;
};
double through_plates(const std::vector<Plate>& plates) {
    double light = 0, weight = 1, index = 1, fade = 1;
    for (std::size_t k = 0; k <= plates.size(); ++k) {
        const double next = k < plates.size() ? plates[k].index : 1;
        const double reflected = fresnel(0, index, next);
        // Only where light leaves matter through its own surface does the way back fade.
        light += weight * reflected * fade;
        weight *= 1 - reflected;
        if (k == plates.size()) break;
        fade = std::exp(-plates[k].absorption * plates[k].way);
        weight *= fade;
        index = next;
    }
    return light + weight;
}

// A slab of glass and one of water that overlap: between them the matter with the higher priority
// is there, and its absorption holds.
TEST(NestedGlass, PriorityTellsWhoseBeersLawHoldsWhereSlabsOverlap) {
    const double glass = 1.5, water = 1.33, of_glass = 0.3, of_water = 0.7;
    const auto drawn_with = [&](int priority_of_glass, int priority_of_water, bool turned) {
        const std::string parts[] = {
            slab(-1, 0.25,
                 material(fmt::format("ior = {}, absorption = [{}, 0, 0], priority = {}", glass,
                                      of_glass, priority_of_glass))),
            slab(-0.25, 1,
                 material(fmt::format("ior = {}, absorption = [{}, 0, 0], priority = {}", water,
                                      of_water, priority_of_water)))};
        return color(
            drawn(parts[turned ? 1 : 0] + parts[turned ? 0 : 1] + seen_by(along_y(0.1), 8, white)),
            27);
    };
    // What is reflected where glass ends within water has come the whole way within glass.
    const double with_glass = through_plates({{1.25, glass, of_glass}, {0.75, water, of_water}});
    const double with_water = through_plates({{0.75, glass, of_glass}, {1.25, water, of_water}});
    ASSERT_GT(std::abs(with_glass - with_water), 0.05);
    const double tolerance = 2 * fresnel(0, glass, water) + 1e-4; // whether that fades is a choice
    for (const bool turned : {false, true}) {
        EXPECT_NEAR(drawn_with(1, 0, turned).x, with_glass, tolerance);
        EXPECT_NEAR(drawn_with(0, 1, turned).x, with_water, tolerance);
        EXPECT_NEAR(drawn_with(-3, -7, turned).x, with_glass, tolerance);
        // Where they are equal, the earlier slab counts: glass or, turned, water.
        EXPECT_NEAR(drawn_with(5, 5, turned).x, turned ? with_water : with_glass, tolerance);
        EXPECT_NEAR(drawn_with(1, 0, turned).y, 1, 1e-4); // clear there
    }
    // The tolerance is less than what tells them apart by far.
    EXPECT_LT(tolerance, 0.2 * std::abs(with_glass - with_water));
}

// Exact, with one index everywhere: nothing is reflected.
TEST(NestedGlass, TransmittanceOfOverlappingSlabsIsExactWithoutReflections) {
    const auto picture = [&](const char* first, const char* second) {
        return drawn(
            slab(-1, 0.25, material(fmt::format("ior = 1, absorption = [0.3, 2, 0], {}", first))) +
            slab(-0.25, 1, material(fmt::format("ior = 1, absorption = [0.7, 0, 5], {}", second))) +
            seen_by(along_y(0.1), 8, white));
    };
    const auto expect = [](const Picture& found, double way, double other) {
        const dvec3 fade = glm::exp(-(way * dvec3(0.3, 2, 0) + other * dvec3(0.7, 0, 5)));
        for (std::size_t pixel = 0; pixel < 64; ++pixel)
            for (int k = 0; k < 3; ++k) ASSERT_NEAR(color(found, pixel)[k], fade[k], 1e-5);
    };
    expect(picture("priority = 1", "priority = 0"), 1.25, 0.75);
    expect(picture("priority = 0", "priority = 1"), 0.75, 1.25);
    expect(picture("priority = 0", "priority = 0"), 1.25, 0.75);
}

// Slabs that touch have one face there, and those that coincide are the earlier in the file.
TEST(NestedGlass, SlabsThatTouchOrCoincideHaveOneMatterEach) {
    const std::string view = seen_by(along_y(0.1), 8, white);
    for (const int priority : {-1, 0, 1}) {
        const std::string second =
            fmt::format("ior = 1.33, absorption = [0.7, 0, 0], priority = {}", priority);
        const double touching = through_plates({{1, 1.5, 0.3}, {1, 1.33, 0.7}});
        EXPECT_NEAR(color(drawn(slab(-1, 0, material("ior = 1.5, absorption = [0.3, 0, 0]")) +
                                slab(0, 1, material(second)) + view),
                          27)
                        .x,
                    touching, 5e-3);
        const Plate one = priority > 0 ? Plate{2, 1.33, 0.7} : Plate{2, 1.5, 0.3};
        EXPECT_NEAR(color(drawn(slab(-1, 1, material("ior = 1.5, absorption = [0.3, 0, 0]")) +
                                slab(-1, 1, material(second)) + view),
                          27)
                        .x,
                    through_plates({one}), 1e-4);
    }
}

// A plate shifts what is behind it by d sin a (1 - cos a / sqrt(n^2 - sin^2 a)).
TEST(NestedGlass, AnOpaqueBallBehindAPlateIsShifted) {
    constexpr int side = 96;
    const double n = 1.5, thickness = 1, a = glm::radians(50.0);
    const double shift =
        thickness * std::sin(a) * (1 - std::cos(a) / std::sqrt(n * n - std::sin(a) * std::sin(a)));
    const std::string red = "material = { color = [1, 0, 0] }\n";
    const std::string light = "[ambient]\ntop = [1, 1, 1]\nbottom = [1, 1, 1]\n";
    // Rays go along y; the plate is turned about x.
    const std::string turned =
        fmt::format("transform = {{ translate = [0, -1.5, 0], rotate = [{}, 0, "
                    "0] }}\n",
                    glm::degrees(a));
    const auto middle_of_red = [&](const Picture& picture) {
        double sum = 0, rows = 0;
        for (std::size_t pixel = 0; pixel < side * side; ++pixel) {
            const bool is_red = color(picture, pixel).x > 2 * color(picture, pixel).z;
            sum += is_red;
            rows += is_red ? 2.4 * (0.5 - (double(pixel / side) + 0.5) / side) : 0;
        }
        EXPECT_GT(sum, 500);
        return rows / sum;
    };
    for (const bool first : {true, false}) {
        const std::string plate =
            slab(-0.5 * thickness, 0.5 * thickness, turned + material(fmt::format("ior = {}", n)));
        const std::string body = ball(0.4, red);
        const Picture picture = drawn((first ? plate + body : body + plate) + light +
                                      seen_by(along_y(2.4), side, "background = [1, 1, 1]\n"));
        // The plate's front looks down or up: the shift is to one side.
        EXPECT_NEAR(std::abs(middle_of_red(picture)), shift, 0.01);
        EXPECT_EQ(surface_at(picture, side * side / 2 + side / 2), first ? 1 : 2);
    }
    EXPECT_GT(shift, 0.3);
}

// A body within glass that ends where the body ends is seen through it; of both the earlier in the
// file is met.
TEST(NestedGlass, ACoatThatCoincidesWithItsBodyHidesNothing) {
    const std::string red = ball(0.6, "material = { color = [1, 0, 0] }\n");
    const std::string view =
        "[ambient]\ntop = [1, 1, 1]\nbottom = [1, 1, 1]\n" + seen_by(along_y(1.6), 48, white);
    const auto with = [&](const std::string& coat, bool first) {
        return drawn((first ? coat + red : red + coat) + view);
    };
    const Picture alone = with(ball(0.1, material("ior = 1"), "[0, 9, 0]"), true);
    for (const bool first : {false, true}) {
        const Picture coated = with(ball(0.6, material("ior = 1")), first);
        EXPECT_LT(largest_difference(alone, coated), 1e-3) << first;
        EXPECT_EQ(surface_at(coated, 24 * 48 + 24), 1);
        EXPECT_LT(largest_difference(alone, with(ball(0.61, material("ior = 1")), first)), 1e-3);
    }
}

// In a white room clear matter is white, whatever lies in what.
TEST(NestedGlass, IsWhiteInAWhiteRoom) {
    const std::string torus = "[[surfaces]]\nformula = \"(sqrt(x^2 + y^2) - 0.6)^2 + z^2 - 0.08\"\n"
                              "bounds = { sphere = 1.2 }\n";
    const std::string gyroid = "[[surfaces]]\nformula = \"sin(4*x)*cos(4*y) + sin(4*y)*cos(4*z) + "
                               "sin(4*z)*cos(4*x)\"\nbounds = { sphere = 0.9 }\n";
    const std::string view = seen_by("[camera]\nazimuth = 20\nelevation = 30\n", 48, white);
    const std::string camera_within =
        seen_by("[camera]\nposition = [0.1, 0.2, 0.05]\ntarget = [1, 0, 0]\nfov = 80\n", 32, white);
    const std::string texts[] = {
        ball(1, material("ior = 1.33, depth = 6")) + torus + material("ior = 1.5, priority = 2"),
        ball(1, material("ior = 1.33, depth = 6")) + gyroid + material("ior = 0.8, priority = 2"),
        ball(0.8, material("ior = 1.5"), "[0.4, 0, 0]") +
            ball(0.8, material("ior = 1.33, priority = -4"), "[-0.4, 0, 0]") +
            ball(0.7, material("ior = 1, priority = 3"), "[0, 0.3, 0.2]"),
        ball(1, material("ior = 1.5, depth = 0")) + ball(0.5, material("ior = 1.2, priority = 1"))};
    for (const std::string& text : texts) {
        for (const std::string& seen : {view, camera_within}) {
            SCOPED_TRACE(text + seen);
            const Picture picture = drawn(text + seen);
            int hits = 0;
            for (std::size_t pixel = 0; pixel < picture.frame.channels[0].samples.size(); ++pixel) {
                hits += surface_at(picture, pixel) > 0;
                for (int k = 0; k < 3; ++k) ASSERT_NEAR(color(picture, pixel)[k], 1, 1e-4) << pixel;
            }
            EXPECT_GT(hits, 200);
        }
    }
}

// What the eye is in counts from the eye on: in both, the matter with the higher priority.
TEST(NestedGlass, TheEyeMayBeInBoth) {
    const auto picture = [](int priority) {
        return drawn(
            ball(1, material("ior = 1, absorption = [0.5, 0, 0]")) +
            ball(0.6, material(fmt::format("ior = 1, absorption = [0, 2, 0], priority = {}",
                                           priority))) +
            seen_by("[camera]\nposition = [0, 0, 0]\ntarget = [0, 1, 0]\nfov = 80\n", 16, white));
    };
    for (const int priority : {1, 0, -1}) {
        const Picture found = picture(priority);
        const double outer = priority > 0 ? 0.4 : 1, inner = priority > 0 ? 0.6 : 0;
        for (std::size_t pixel = 0; pixel < 256; ++pixel) {
            ASSERT_NEAR(color(found, pixel).x, std::exp(-0.5 * outer), 1e-4);
            ASSERT_NEAR(color(found, pixel).y, std::exp(-2 * inner), 1e-4);
        }
    }
}

// A mirror and glass that pass through each other: where the mirror is outside of the glass, it is
// as without it; within, it is seen through the glass and mirrors what is seen from there.
TEST(NestedGlass, AMirrorAndGlassMayPassThroughEachOther) {
    const std::string chrome = "material = { model = \"ggx\", metallic = 1, color = [1, 1, 1], "
                               "roughness = 0.1, reflection "
                               "= \"self\" }\n";
    const auto scene = [&](const char* place, double index) {
        return ball(0.7, material(fmt::format("ior = {}, depth = 8", index)), place) +
               ball(0.6, chrome, "[0, 0, 0]") + seen_by(along_y(2.4), 48, sky_by_height);
    };
    // Glass with the index of what is around it is not seen, except at its very edge, where rays
    // begin off their line.
    const Picture alone = drawn(scene("[0, 0, 9]", 1));
    const Picture clear = drawn(scene("[0.5, -0.2, 0.1]", 1));
    int other = 0;
    for (std::size_t pixel = 0; pixel < 48 * 48; ++pixel)
        other += glm::distance(color(alone, pixel), color(clear, pixel)) > 5e-3;
    EXPECT_LE(other, 2);
    EXPECT_LT(largest_difference(alone, clear), 0.2);
    const Picture both = drawn(scene("[0.5, -0.2, 0.1]", 1.5));
    EXPECT_GT(largest_difference(alone, both), 0.2);
    // In a white room a perfect mirror is white, too.
    const Picture room = drawn(ball(0.7, material("ior = 1.5, depth = 16"), "[0.5, -0.2, 0.1]") +
                               ball(0.6, chrome, "[0, 0, 0]") + seen_by(along_y(2.4), 48, white));
    const Picture of_chrome =
        drawn(ball(0.7, material("ior = 1.5"), "[0, 0, 9]") + ball(0.6, chrome, "[0, 0, 0]") +
              seen_by(along_y(2.4), 48, white));
    double least = 1;
    for (std::size_t pixel = 0; pixel < 48 * 48; ++pixel)
        least = std::min(least, color(of_chrome, pixel).x);
    for (std::size_t pixel = 0; pixel < 48 * 48; ++pixel) {
        EXPECT_LE(color(room, pixel).x, 1 + 1e-4);
        EXPECT_GE(color(room, pixel).x, std::pow(least, 4) - 1e-4) << pixel;
    }
}

// Matter that reaches its bounds ends there without a surface, and what is behind is seen.
TEST(NestedGlass, MatterEndsAtBoundsWithoutASurface) {
    const std::string all =
        "[[surfaces]]\nformula = \"z - 9\"\nbounds = { box = [[-1, -0.5, -1], [1, "
        "0.5, 1]] }\n";
    const auto found = [&](const std::string& first, const std::string& second) {
        return color(drawn(all + material("ior = 1.5, absorption = [0.5, 0, 0]" + first) +
                           ball(0.4, material("ior = 1, absorption = [0, 0.5, 0]" + second)) +
                           seen_by(along_y(0.02), 9, white)),
                     40);
    };
    // In the middle: of the ball 0.8, of the box 1, or 0.2 where the ball counts.
    const dvec3 box = found("", "");
    EXPECT_NEAR(box.x, std::exp(-0.5), 1e-4);
    EXPECT_NEAR(box.y, 1, 1e-4);
    const double reflected = fresnel(0, 1.5, 1);
    EXPECT_NEAR(found("", ", priority = 1").x, std::exp(-0.1), 4 * reflected);
    EXPECT_NEAR(found("", ", priority = 1").y, std::exp(-0.4), 4 * reflected);
    // What is behind it, in less important matter.
    const Picture behind =
        drawn(all + material("ior = 1, absorption = [0.5, 0, 0], priority = 3") +
              ball(0.4, material("ior = 1, absorption = [0, 0.5, 0]"), "[0, 2, 0]") +
              seen_by(along_y(0.02), 9, white));
    EXPECT_NEAR(color(behind, 40).x, std::exp(-0.5), 1e-4);
    EXPECT_NEAR(color(behind, 40).y, std::exp(-0.4), 1e-4);
}

TEST(NestedGlass, OneMayBeEmptyAndEightMayBeThere) {
    std::string text =
        "[[surfaces]]\nformula = \"x^2 + y^2 + z^2 + 1\"\nbounds = { sphere = 2 }\n" +
        material("ior = 1.5, priority = 9");
    dvec3 fade(0);
    for (int k = 0; k < 7; ++k) {
        const double radius = 1 - 0.12 * k;
        text += ball(radius, material(fmt::format("ior = 1, absorption = [{}, 0, 0], priority = {}",
                                                  0.1 * k, k)));
        fade.x += 2 * 0.1 * k * (k < 6 ? 0.12 : radius);
    }
    const Picture picture =
        drawn(text + "[material]\ndepth = 16\n" + seen_by(along_y(0.02), 9, white));
    EXPECT_NEAR(color(picture, 40).x, std::exp(-fade.x), 1e-4);
    EXPECT_EQ(surface_at(picture, 40), 2);
    EXPECT_EQ(count(picture, Verdict::hit), 81);
}

// Where glass has the index of what is around, the rest is as without it: its light, its shadows on
// each other and on the ground, and mirrors.
TEST(NestedGlass, WithoutAnotherIndexIsInvisible) {
    const std::string rest =
        ball(0.4, "material = { color = [0.8, 0.2, 0.1] }\n", "[0.2, 0.5, 0]") +
        ball(0.3, "material = { color = [0.1, 0.2, 0.9], model = \"blinn-phong\" }\n",
             "[-0.4, 0.2, 0.3]") +
        "[ground]\nheight = -0.6\n[[lights]]\ndirection = [0.2, 0.4, 1]\nshadow = true\n[camera]\n"
        "position = [0, -5, 1]\ntarget = [0, 0, 0]\nfov = 30\n[output]\nsize = [48, 48]\n";
    const auto scene = [&](const char* place) {
        return slab(-0.02, 0.02,
                    fmt::format("transform = {{ translate = {} }}\n", place) +
                        material("ior = 1, depth = 3")) +
               rest;
    };
    // The slab's shadow falls towards the eye, where no ground is seen.
    const Picture before = drawn(scene("[0, -3, -0.2]")), behind = drawn(scene("[0, 60, 0]"));
    int other = 0;
    for (std::size_t pixel = 0; pixel < 48 * 48; ++pixel)
        other += glm::distance(color(before, pixel), color(behind, pixel)) > 5e-3;
    EXPECT_LT(other, 40); // edges
}

// Few evaluations in a draw, small tiles, compute shaders: the same.
TEST(NestedGlass, NeitherDrawsNorPlaceMatter) {
    const std::string balls =
        ball(0.8, material("ior = 1.33, absorption = [0.4, 0.2, 0], depth = 6")) +
        ball(0.5, material("ior = 1.5, priority = 1"), "[0.3, 0, 0.4]");
    const std::string view = seen_by(
        "[camera]\nposition = [3, 2, 1]\ntarget = [0, 0, 0]\nfov = 40\n", 64, sky_by_height);
    const Picture whole = drawn(balls + view);
    EXPECT_LT(largest_difference(whole, drawn(balls + view, MarchPlan{64, 64, 3})), 1e-4);
    EXPECT_LT(largest_difference(whole, drawn(balls + view, MarchPlan{16, 32, 64})), 1e-4);
    if (context_of_nested_glass().info().has(4, 3)) {
        EXPECT_LT(largest_difference(whole, drawn(balls + view, {}, StageChoice::compute)), 1e-4);
    }
}

} // namespace
} // namespace isomotion::render::nested_glass_test
