// Glass and water: the light that goes through, by the closed forms of optics.
#include <cmath>

#include <fmt/format.h>

#include "effects/optics.h"
#include "render/drawing.h"

namespace isomotion::render::glass_test {
namespace {

gpu::Context& context_of_glass() {
    static const auto it = gpu::Context::create();
    return *it;
}

using glm::dvec3;

// Parallel rays along y, from -1.2 to 1.2.
constexpr const char* along_y = "[camera]\nposition = [0, -5, 0]\ntarget = [0, 0, 0]\n"
                                "projection = \"orthographic\"\nheight = 2.4\n";
constexpr const char* ball =
    "[surface]\nformula = \"x^2 + y^2 + z^2 - 1\"\nbounds = { sphere = 1.5 }\n";

// A scene of a surface, what it is made of, and what it is seen by.
scene::Scene scene_with(const std::string& surface, const std::string& glass,
                        const std::string& view, const std::string& behind, int side = 64,
                        const std::string& more = "") {
    return scene_of(fmt::format("{}[material]\ntransmission = 1\n{}\n{}{}{}[output]\nsize = [{}, "
                                "{}]\n{}",
                                surface, glass, view, dark, more, side, side, behind));
}

// Lit, before black.
Picture lit_ball(const std::string& material) {
    return draw(
        context_of_glass(),
        scene_of(fmt::format(
            "{}[material]\nmodel = \"ggx\"\nroughness = 0.5\n{}\n{}[[lights]]\ndirection = [0.3, "
            "-1, "
            "0.5]\n[ambient]\ntop = [0.5, 0.5, 0.5]\nbottom = [0.5, 0.5, 0.5]\n[output]\nsize = "
            "[32, 32]\nbackground = [0, 0, 0]\n",
            ball, material, along_y)));
}

bool is_hit(const Picture& picture, std::size_t pixel) {
    return Verdict(int(picture.frame.find("verdict")->samples[pixel])) == Verdict::hit;
}

// The eye's ray of a pixel, from far before the scene.
struct EyeRay {
    dvec3 from, direction;
};
EyeRay eye_ray(const scene::Scene& scene, std::size_t pixel) {
    const int width = scene.output.width, height = scene.output.height;
    const scene::Rays rays = scene::rays(scene::at_frame(scene, 1), width, height);
    const double u = 2 * (double(int(pixel) % width) + 0.5) / width - 1;
    const double v = 1 - 2 * (double(int(pixel) / width) + 0.5) / height;
    const dvec3 across = u * rays.right + v * rays.up;
    const bool parallel = scene.camera.projection == scene::Camera::Projection::orthographic;
    const dvec3 along = rays.axis + (parallel ? dvec3(0) : across);
    return {rays.origin + across - along, glm::normalize(along)};
}

// A ray through a unit ball about the origin, followed by geometry alone: in its plane each chord
// has the same length and turns by the same angle.
dvec3 through_ball(const EyeRay& ray, double ior, const dvec3& absorption, int depth) {
    const double b = glm::dot(ray.from, ray.direction);
    const dvec3 at =
        ray.from + (-b - std::sqrt(b * b - glm::dot(ray.from, ray.from) + 1)) * ray.direction;
    const double a = std::acos(glm::clamp(-glm::dot(at, ray.direction), -1.0, 1.0));
    const double front = fresnel(a, 1, ior);
    const dvec3 mirrored = glm::reflect(ray.direction, at);
    if (front >= 1)
        return sky(mirrored); // nothing enters, and what is reflected meets no ball again
    const double inner = std::asin(std::sin(a) / ior), chord = 2 * std::cos(inner);
    const dvec3 fade = glm::exp(-absorption * chord);
    // Turned within the plane of the ray and the normal.
    const dvec3 axis = a < 1e-9 ? dvec3(0) : glm::normalize(glm::cross(at, ray.direction));
    const auto turned = [&](const dvec3& v, double angle) {
        return std::cos(angle) * v + std::sin(angle) * glm::cross(axis, v);
    };
    const dvec3 within = turned(ray.direction, a - inner);
    const dvec3 light = front * sky(mirrored);
    if (depth == 0) return light + (1 - front) * sky(within);
    const dvec3 end = at + chord * within;
    const dvec3 out = turned(within, a - inner);
    const double back = fresnel(inner, ior, 1);
    return light +
           (1 - front) * fade * (back * fade * sky(glm::reflect(out, end)) + (1 - back) * sky(out));
}

TEST(Glass, ABallIsSeenThroughAsGeometrySays) {
    for (const double ior : {1.5, 1.33, 1.0, 0.7, 2.4}) {
        for (const int depth : {0, 1, 4, 16}) {
            SCOPED_TRACE(fmt::format("ior {}, depth {}", ior, depth));
            const scene::Scene scene = scene_with(
                ball, fmt::format("ior = {}\ndepth = {}\nabsorption = [0.1, 0.5, 0]", ior, depth),
                along_y, sky_by_height);
            const Picture picture = draw(context_of_glass(), scene);
            int hits = 0;
            for (std::size_t pixel = 0; pixel < 64 * 64; ++pixel) {
                const EyeRay ray = eye_ray(scene, pixel);
                if (!is_hit(picture, pixel)) continue;
                // At the edge rays begin off their line, and where reflection becomes total it
                // rises without bound.
                const double off = glm::length(glm::cross(ray.from, ray.direction));
                if (off > 0.99 || std::abs(off - ior) < 0.01) continue;
                ++hits;
                const dvec3 expected = through_ball(ray, ior, {0.1, 0.5, 0}, depth);
                for (int k = 0; k < 3; ++k)
                    ASSERT_NEAR(color(picture, pixel)[k], expected[k], 2e-3) << pixel << ' ' << k;
            }
            EXPECT_GT(hits, 2000);
        }
    }
}

// Rays near the axis of a ball lens meet at f = n R / (2 (n - 1)) from its middle.
TEST(Glass, ABallIsALensWithItsFocusWhereItIs) {
    constexpr int side = 65;
    for (const double n : {1.33, 1.5, 1.8}) {
        const scene::Scene scene =
            scene_with(ball, fmt::format("ior = {}", n),
                       "[camera]\nposition = [0, -5, 0]\ntarget = [0, 0, 0]\n"
                       "projection = \"orthographic\"\nheight = 0.06\n",
                       sky_by_height, side);
        const Picture picture = draw(context_of_glass(), scene);
        const int row = 8, column = side / 2;
        const double height = 0.06 * (0.5 - (row + 0.5) / side);
        const double red = color(picture, std::size_t(row * side + column)).x;
        // The slopes of what is reflected are known near the axis, too: 2 h / R at the front; at
        // the back, by h2 = h (2/n - 1), the mirror image of how the rest leaves.
        const double front = std::pow((n - 1) / (n + 1), 2), through = 1 - front;
        const double focus = n / (2 * (n - 1)), behind = 2 / n - 1;
        const double leaves = -1 / focus;
        const double slopes = front * 2 + through * front * (leaves - 2 * behind);
        const double seen = (2 * (red - 0.5) / height - slopes) / (through * through);
        EXPECT_NEAR(-1 / seen, focus, 0.01 * focus) << n;
    }
}

// Beer's law: through a plate of thickness d at the angle a light goes d / cos b, and fades by
// exp(-absorption way).
TEST(Glass, BeersLawThroughAPlate) {
    const double n = 1.5, thickness = 0.8;
    for (const double degrees : {0.0, 30.0, 60.0}) {
        const double a = glm::radians(degrees), b = std::asin(std::sin(a) / n);
        const scene::Scene scene = scene_with(
            fmt::format(
                "[surface]\nformula = \"abs(y) - {}\"\nbounds = {{ box = [[-9, -1, -9], [9, "
                "1, 9]] }}\n",
                0.5 * thickness),
            "absorption = [0, 0.5, 2]\nior = 1.5",
            fmt::format("[camera]\nposition = [{}, {}, 0]\ntarget = [0, 0, 0]\nprojection = "
                        "\"orthographic\"\nheight = 0.1\n",
                        5 * std::sin(a), -5 * std::cos(a)),
            white, 8);
        const Picture picture = draw(context_of_glass(), scene);
        const double front = fresnel(a, 1, n);
        for (int k = 0; k < 3; ++k) {
            const double fade =
                std::exp(-std::array{0.0, 0.5, 2.0}[std::size_t(k)] * thickness / std::cos(b));
            const double found = color(picture, 36)[k];
            const double passes = fade * ((1 - front) * (1 - front) + (1 - front) * front * fade);
            EXPECT_NEAR(found, front + passes, 1e-4) << degrees;
            // All reflections within, summed.
            const double all = front + (1 - front) * (1 - front) * fade * (1 + front * fade) /
                                           (1 - front * front * fade * fade);
            EXPECT_NEAR(found, all, front * front + 1e-4) << degrees;
        }
    }
}

// A prism of the angle A turns light that comes in at the angle a by
// a - A + asin(sin A sqrt(n^2 - sin^2 a) - cos A sin a).
TEST(Glass, APrismTurnsLightByItsAngle) {
    const double n = 1.5, angle = glm::radians(40.0);
    for (const double degrees : {20.0, 30.0, 45.0}) {
        const double a = glm::radians(degrees);
        // Its faces meet in a line along x, above; light along y comes in at the angle a.
        const double half = 0.5 * angle;
        const auto face = [&](double sign) {
            return fmt::format("({:.17g}*y + {:.17g}*(z - 1))", sign * std::cos(half),
                               std::sin(half));
        };
        // Towards the first face at the angle a: outward normal (-cos half, sin half) in (y, z).
        const double normal = std::atan2(std::sin(half), -std::cos(half));
        const double to_light = normal + a; // light comes from below the normal
        const dvec3 from(0, 8 * std::cos(to_light), 8 * std::sin(to_light));
        const dvec3 target(0, -std::tan(half), 0);
        const scene::Scene scene = scene_with(
            fmt::format(
                "[surface]\nformula = \"max({}, {})\"\nbounds = {{ box = [[-2, -2, -2], [2, "
                "2, 2]] }}\n",
                face(-1), face(1)),
            "ior = 1.5",
            fmt::format("[camera]\nposition = [0, {:.17g}, {:.17g}]\ntarget = [0, {:.17g}, "
                        "0]\nprojection = "
                        "\"orthographic\"\nheight = 0.02\n",
                        from.y + target.y, from.z, target.y),
            sky_by_height, 8);
        const Picture picture = draw(context_of_glass(), scene);
        const EyeRay ray = eye_ray(scene, 36);
        const double inner = std::asin(std::sin(a) / n), second = angle - inner;
        const double leaves = std::asin(n * std::sin(second));
        const double deviation =
            a - angle +
            std::asin(std::sin(angle) * std::sqrt(n * n - std::sin(a) * std::sin(a)) -
                      std::cos(angle) * std::sin(a));
        ASSERT_NEAR(deviation, a + leaves - angle, 1e-9);
        // Towards the base, which is below.
        const double along = std::atan2(ray.direction.z, ray.direction.y) - deviation;
        const dvec3 out(0, std::cos(along), std::sin(along));
        const double front = fresnel(a, 1, n), back = fresnel(second, n, 1);
        const dvec3 first_normal(0, -std::cos(half), std::sin(half)),
            second_normal(0, std::cos(half), std::sin(half));
        const double red = color(picture, 36).x;
        const double reflected = front * sky(glm::reflect(ray.direction, first_normal)).x +
                                 (1 - front) * back * sky(glm::reflect(out, second_normal)).x;
        const double z = 2 * (red - reflected) / ((1 - front) * (1 - back)) - 1;
        EXPECT_NEAR(std::asin(z), along, 2e-3) << degrees;
        EXPECT_GT(std::abs(deviation), 0.3);
    }
}

// In a white room clear glass of any shape is white: no light is lost or made.
class GlassFurnace : public testing::TestWithParam<const char*> {};

TEST_P(GlassFurnace, IsWhite) {
    const std::pair<const char*, const char*> surfaces[] = {
        {"x^2 + y^2 + z^2 - 1", "{ sphere = 1.5 }"},
        {"(sqrt(x^2 + y^2) - 0.8)^2 + z^2 - 0.1", "{ sphere = 1.5 }"},
        {"sin(5*x)*cos(5*y) + sin(5*y)*cos(5*z) + sin(5*z)*cos(5*x)", "{ sphere = 1.2 }"},
        {"max(abs(x), max(abs(y), abs(z))) - 0.7", "{ sphere = 1.5 }"},
        {"abs(x^2 + y^2 + z^2 - 0.8) - 0.05", "{ sphere = 1.2 }"}};
    for (const auto& [formula, bounds] : surfaces) {
        for (const char* glass : {"ior = 1.5\ndepth = 6", "ior = 0.8\ndepth = 3"}) {
            SCOPED_TRACE(fmt::format("{}, {}", formula, glass));
            const scene::Scene scene = scene_with(
                fmt::format(
                    "[surface]\nformula = \"{}\"\nbounds = {}\n[isolation]\nmethod = \"{}\"\n",
                    formula, bounds, GetParam()),
                glass, "[camera]\nazimuth = 20\nelevation = 30\n", white, 48);
            const Picture picture = draw(context_of_glass(), scene);
            EXPECT_GT(count(picture, Verdict::hit), 200);
            for (std::size_t pixel = 0; pixel < 48 * 48; ++pixel) {
                for (int k = 0; k < 3; ++k) ASSERT_NEAR(color(picture, pixel)[k], 1, 1e-4) << pixel;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Methods, GlassFurnace,
                         testing::Values("hermite", "interval", "affine", "sphere", "amp-sign"));

// What has the index of what is around can't be seen: not before the sky, nor before a ground with
// its own shadow on it.
TEST(Glass, WithoutAnotherIndexIsInvisible) {
    const std::string ground = "[ground]\nheight = -1.2\ncolor = [0.5, 0.4, 0.3]\n";
    const std::string light = "[[lights]]\ndirection = [0, 0, 1]\nshadow = true\n";
    const std::string view = "[camera]\nposition = [0, -6, 2]\ntarget = [0, 0, 0]\nfov = 50\n";
    const auto drawn = [&](const std::string& material) {
        return draw(context_of_glass(), scene_of(ball + material + ground + light + view +
                                                 "[output]\nsize = [64, 64]\n" + sky_by_height));
    };
    const Picture glass = drawn("[material]\ntransmission = 1\nior = 1\n");
    const scene::Scene scene = scene_of(ball + view + "[output]\nsize = [64, 64]\n");
    int seen_through = 0, in_shadow = 0;
    for (std::size_t pixel = 0; pixel < 64 * 64; ++pixel) {
        const EyeRay ray = eye_ray(scene, pixel);
        const double way = (-1.2 - ray.from.z) / ray.direction.z;
        dvec3 expected = sky(ray.direction);
        if (ray.direction.z < 0) {
            const dvec3 place = ray.from + way * ray.direction;
            const double off = std::hypot(place.x, place.y);
            if (std::abs(off - 1) < 0.02) continue; // the shadow's edge
            expected = dvec3(0.5, 0.4, 0.3) * (0.12 + (off > 1 ? 1.0 : 0.0));
            in_shadow += off < 1 && is_hit(glass, pixel);
        }
        seen_through += is_hit(glass, pixel);
        for (int k = 0; k < 3; ++k) ASSERT_NEAR(color(glass, pixel)[k], expected[k], 2e-3) << pixel;
    }
    EXPECT_GT(seen_through, 300);
    EXPECT_GT(in_shadow, 20);
}

TEST(Glass, TheEyeMayBeInIt) {
    // In the middle of a ball light leaves straight on; of what is reflected there comes what is
    // behind.
    const double fade = std::exp(-0.7), reflected = 0.04;
    const scene::Scene scene = scene_with(
        ball, "absorption = [0.7, 0.7, 0.7]",
        "[camera]\nposition = [0, 0, 0]\ntarget = [0, 1, 0]\nfov = 80\n", sky_by_height, 32);
    const Picture picture = draw(context_of_glass(), scene);
    for (std::size_t pixel = 0; pixel < 32 * 32; ++pixel) {
        const dvec3 d = eye_ray(scene, pixel).direction;
        const dvec3 expected = fade * ((1 - reflected) * sky(d) + reflected * fade * sky(-d));
        for (int k = 0; k < 3; ++k)
            ASSERT_NEAR(color(picture, pixel)[k], expected[k], 2e-3) << pixel;
    }
    // Matter without a surface in sight ends at the bounds.
    const scene::Scene endless = scene_with(
        "[surface]\nformula = \"z - 9\"\nbounds = { sphere = 2 }\n", "absorption = [0.7, 0.1, 0]",
        "[camera]\nposition = [0, 0, 0]\ntarget = [0, 1, 0]\nfov = 80\n", white, 8);
    const Picture fog = draw(context_of_glass(), endless);
    for (int k = 0; k < 3; ++k) {
        const double density = std::array{0.7, 0.1, 0.0}[std::size_t(k)];
        EXPECT_NEAR(color(fog, 27)[k], std::exp(-2 * density), 1e-4);
    }
}

TEST(Glass, TransmissionMixesItWithTheSurface) {
    const auto drawn = [&](const char* transmission) {
        return draw(context_of_glass(),
                    scene_of(fmt::format("{}[material]\ntransmission = {}\n{}[output]\nsize = [32, "
                                         "32]\n{}",
                                         ball, transmission, along_y, sky_by_height)));
    };
    const Picture none = drawn("0"), half = drawn("\"0.5 + 0*t\""), all = drawn("1");
    for (std::size_t pixel = 0; pixel < 32 * 32; ++pixel) {
        const dvec3 mean = 0.5 * (color(none, pixel) + color(all, pixel));
        for (int k = 0; k < 3; ++k) ASSERT_NEAR(color(half, pixel)[k], mean[k], 1e-5);
    }
    EXPECT_GT(glm::distance(color(none, 16 * 32 + 16), color(all, 16 * 32 + 16)), 0.1);
}

// Few evaluations in a draw, so that rays stop on their ways; and a surface moved and made larger.
TEST(Glass, NeitherDrawsNorPlaceMatter) {
    const auto scene = [&](const char* move, const char* view) {
        return scene_with(std::string(ball) + move, "absorption = [0.4, 0.2, 0]", view,
                          sky_by_height);
    };
    const char* near = "[camera]\nposition = [3, 2, 1]\ntarget = [0, 0, 0]\nfov = 50\n";
    const scene::Scene here = scene("", near);
    const Picture whole = draw(context_of_glass(), here);
    const Picture parts = draw(context_of_glass(), here, 1, MarchPlan{64, 64, 3});
    const Picture tiles = draw(context_of_glass(), here, 1, MarchPlan{16, 32, 64});
    EXPECT_GT(parts.passes, whole.passes + 8);
    for (const Picture* other : {&parts, &tiles}) {
        for (std::size_t pixel = 0; pixel < 64 * 64; ++pixel)
            ASSERT_LT(glm::distance(color(whole, pixel), color(*other, pixel)), 1e-5) << pixel;
    }
    const scene::Scene far = scene_with(
        std::string(ball) + "transform = { translate = [1000, 0, 0], scale = 100 }\n",
        "absorption = [0.004, 0.002, 0]",
        "[camera]\nposition = [1300, 200, 100]\ntarget = [1000, 0, 0]\nfov = 50\n", sky_by_height);
    const Picture moved = draw(context_of_glass(), far);
    for (std::size_t pixel = 0; pixel < 64 * 64; ++pixel) {
        if (!is_hit(whole, pixel)) continue;
        ASSERT_LT(glm::distance(color(whole, pixel), color(moved, pixel)), 0.02) << pixel;
    }
}

// Half a metal that lets all other light through: half of the metal's highlight, half of the
// coat's, and nothing of the matt part.
TEST(Glass, TakesNothingFromTheHighlightOfMetal) {
    const Picture glass = lit_ball("transmission = 1\nmetallic = 0.5\ncolor = [0.9, 0.5, 0.2]\n");
    const Picture metal = lit_ball("metallic = 1\ncolor = [0.9, 0.5, 0.2]\n");
    const Picture coat = lit_ball("metallic = 0\ncolor = [0, 0, 0]\n");
    double brightest = 0;
    for (std::size_t pixel = 0; pixel < 32 * 32; ++pixel) {
        const dvec3 expected = 0.5 * (color(metal, pixel) + color(coat, pixel));
        ASSERT_LT(glm::distance(color(glass, pixel), expected), 1e-5) << pixel;
        brightest = std::max(brightest, expected.r);
    }
    EXPECT_GT(brightest, 0.2);
}

} // namespace
} // namespace isomotion::render::glass_test
