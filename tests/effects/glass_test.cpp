// Glass: the light that goes through a ball and a prism, by the closed forms of optics.
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

} // namespace
} // namespace isomotion::render::glass_test
