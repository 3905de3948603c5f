// Random and nasty rays: float32 as drivers may compute it, and the worst that GLSL allows them,
// against exact rays in MPFR.
#include "scene/ray_rounding.h"

#include <array>
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "roots/drawn_ray.h"
#include "unit/formula/exact.h"

namespace isomotion::scene::ray_rounding_test {
namespace {

using formula::Exact;
using roots::DrawnRay;
using roots::Driver;
using roots::Random;
using roots::Uniforms;

using ExactVector = std::array<Exact, 3>;

Exact root(const Exact& a) { return formula::computed(mpfr_sqrt, a); }

// The ray of the uniforms.
struct ExactRay {
    ExactVector anchor, direction;

    ExactRay(const Uniforms& is, const glm::ivec2& size, const glm::ivec2& pixel) {
        const auto at = [](int k, int n) { return Exact(2 * k + 1) / Exact(n) - Exact(1); };
        const Exact u = at(pixel.x, size.x), v = at(pixel.y, size.y);
        ExactVector from_eye;
        Exact square;
        for (int k = 0; k < 3; ++k) {
            const Exact across = u * Exact(is.right[k]) + v * Exact(is.up[k]);
            const auto axis = std::size_t(k);
            anchor[axis] = Exact(is.origin[k]) + across;
            from_eye[axis] = Exact(is.axis[k]) + Exact(is.parallel) * across;
            square = square + from_eye[axis] * from_eye[axis];
        }
        const Exact length = root(square);
        for (std::size_t k = 0; k < 3; ++k) direction[k] = from_eye[k] / length;
    }
    ExactVector point(double t) const {
        ExactVector p;
        for (std::size_t k = 0; k < 3; ++k) p[k] = anchor[k] + Exact(t) * direction[k];
        return p;
    }
};

// Numbers that carry the largest error that GLSL allows, on either side at random. The rounding of
// double is nothing to it.
class Worst {
public:
    explicit Worst(Random& random)
        : random_(random) {}

    double off(double exact, double units) {
        return exact * (1 + (random_.below(2) ? units : -units) * RayRounding::unit);
    }
    double sum(double a, double b) { return off(a + b, 1); }
    double product(double a, double b) { return off(a * b, 1); }
    double length(const glm::dvec3& v) {
        const double two = sum(product(v.x, v.x), product(v.y, v.y));
        return off(std::sqrt(sum(two, product(v.z, v.z))), 9);
    }

    struct Ray {
        glm::dvec3 anchor, direction;
    };
    Ray ray(const Uniforms& is, const glm::ivec2& size, const glm::ivec2& pixel) {
        const auto at = [&](int k, int n) {
            return sum(product(off(k + 0.5, 1), off(2.0 / n, 1)), -1);
        };
        const double u = at(pixel.x, size.x), v = at(pixel.y, size.y);
        Ray ray;
        glm::dvec3 from_eye;
        for (int k = 0; k < 3; ++k) {
            const double across = sum(product(u, is.right[k]), product(v, is.up[k]));
            ray.anchor[k] = sum(is.origin[k], across);
            from_eye[k] = sum(is.axis[k], is.parallel * across);
        }
        const double distance = length(from_eye);
        for (int k = 0; k < 3; ++k) ray.direction[k] = off(from_eye[k] / distance, 5);
        return ray;
    }
    glm::dvec3 point(const Ray& ray, double t) {
        glm::dvec3 p;
        for (int k = 0; k < 3; ++k) p[k] = sum(ray.anchor[k], product(t, ray.direction[k]));
        return p;
    }

private:
    Random& random_;
};

struct Case {
    SceneAt now;
    Aim aim;
    glm::ivec2 size{1};
};

constexpr std::array<const char*, 6> kinds{"ordinary", "wide",         "far away",
                                           "parallel", "off its axis", "beside what it sees"};

Case random_case(Random& random, int kind) {
    Case c;
    c.now.surfaces.resize(1);
    BoundsAt& bounds = c.now.surfaces[0].bounds;
    bounds.radius = random.size(1e-4, 1e4);
    bounds.centre =
        random.below(2) ? glm::dvec3(0) : random.size(0.1, 10) * bounds.radius * random.direction();
    CameraAt& camera = c.now.camera;
    double distance = random.in(1.2, 8) * bounds.radius;
    camera.fov = random.in(5, 100);
    camera.height = random.size(0.01, 4) * bounds.radius;
    constexpr std::array sizes{1, 7, 64, 513, 1920, 8192};
    c.size = {sizes[std::size_t(random.below(6))], sizes[std::size_t(random.below(6))]};
    // A turn about an axis leaves coordinates that are 0 or 1.
    glm::dvec3 away = random.direction(), aside(0);
    if (random.below(3) == 0) {
        away = glm::dvec3(0);
        away[random.below(3)] = random.below(2) ? 1 : -1;
    }
    switch (kind) {
    case 1:
        camera.fov = random.in(100, 175);
        if (random.below(2)) distance = random.size(1e-3, 1) * bounds.radius;
        // See at_depth().
        c.size.x = c.size.y = std::max(c.size.x, c.size.y);
        break;
    case 2:
        distance = random.size(1e2, 1e6) * bounds.radius;
        camera.fov = std::max(1e-4, 3 * glm::degrees(bounds.radius / distance));
        break;
    case 3:
        camera.projection = Camera::Projection::orthographic;
        break;
    case 4:
        c.aim.pixel = {random.in(-0.5, 0.5), random.in(-0.5, 0.5)};
        c.aim.lens = {random.in(-0.7, 0.7), random.in(-0.7, 0.7)};
        camera.aperture = random.size(1e-3, 0.5) * bounds.radius;
        camera.focus = random.size(0.3, 3) * distance;
        break;
    case 5:
        aside = random.in(0, 3) * bounds.radius * random.direction();
        break;
    default:
        break;
    }
    camera.target = bounds.centre + aside;
    camera.position = camera.target + distance * away;
    camera.up = random.direction();
    return c;
}

// What is off, as a part of what the model allows.
struct Used {
    double anchor = 0, direction = 0, point = 0;
};

double size_of(const ExactVector& off, Norm norm) {
    Exact square, largest;
    for (const Exact& x : off) {
        square = square + x * x;
        const Exact size = x < Exact(0) ? -x : x;
        if (largest < size) largest = size;
    }
    return norm == Norm::length ? root(square).rounded() : largest.rounded();
}

template<class Vector> double off(const Vector& drawn, const ExactVector& exact, Norm norm) {
    ExactVector off;
    for (int k = 0; k < 3; ++k) off[std::size_t(k)] = Exact(drawn[k]) - exact[std::size_t(k)];
    return size_of(off, norm);
}

class RayRoundingOfCameras : public testing::TestWithParam<int> {
protected:
    // ray(random) makes one driver's ray, whose points point(ray, t) are.
    template<class MakeRay, class MakePoint>
    void check(const Case& c, const glm::ivec2& pixel, Random& random, MakeRay&& make_ray,
               MakePoint&& make_point) {
        const Uniforms uniforms(c.now, c.size.x, c.size.y, c.aim);
        const ExactRay exact(uniforms, c.size, pixel);
        const Rays made = rays(c.now, c.size.x, c.size.y, c.aim);
        const glm::dvec3 forward = glm::normalize(glm::cross(made.up, made.right));
        const auto drawn = make_ray(uniforms);
        const double radius = c.now.surfaces[0].bounds.radius;
        for (const Norm norm : {Norm::coordinate, Norm::length}) {
            const RayRounding allowed = ray_rounding(made, c.now.surfaces[0].bounds, norm);
            const auto within = [&](double& used, double is, double most) {
                EXPECT_LE(is, most) << (norm == Norm::length ? "length" : "coordinate");
                used = std::max(used, is / most);
            };
            within(used_.anchor, off(drawn.anchor, exact.anchor, norm), allowed.anchor);
            within(used_.direction, off(drawn.direction, exact.direction, norm), allowed.direction);
            const glm::dvec3 anchor(exact.anchor[0].rounded(), exact.anchor[1].rounded(),
                                    exact.anchor[2].rounded());
            const glm::dvec3 direction(exact.direction[0].rounded(), exact.direction[1].rounded(),
                                       exact.direction[2].rounded());
            // As truth's tubes count, ...
            const double reach = radius + glm::length(anchor - c.now.surfaces[0].bounds.centre);
            // ... and as beams do.
            const double steepness = glm::dot(direction, forward);
            for (const double part : {-1.0, 1.0, random.in(-1, 1)}) {
                const float far = float(part * reach);
                within(used_.point, off(make_point(drawn, far), exact.point(double(far)), norm),
                       allowed.at_distance(std::abs(double(far)) + 1e-6 * reach));
                const float deep = float(part * radius / steepness);
                within(used_.point, off(make_point(drawn, deep), exact.point(double(deep)), norm),
                       allowed.at_depth(radius));
            }
        }
    }
    Used used_;
};

TEST_P(RayRoundingOfCameras, HoldsWhatDriversDraw) {
    Random random(20261122 + unsigned(GetParam()));
    for (int k = 0; k < 300 && !HasFailure(); ++k) {
        const Case c = random_case(random, GetParam());
        SCOPED_TRACE(fmt::format("camera {}", k));
        for (int n = 0; n < 8; ++n) {
            const glm::ivec2 pixel(random.below(c.size.x), random.below(c.size.y));
            const Driver driver(random);
            check(
                c, pixel, random,
                [&](const Uniforms& uniforms) { return drawn(uniforms, driver, pixel.x, pixel.y); },
                [&](const DrawnRay& ray, float t) { return ray.point(driver, t); });
        }
    }
    RecordProperty("anchor", fmt::format("{:.3f}", used_.anchor));
    RecordProperty("direction", fmt::format("{:.3f}", used_.direction));
    RecordProperty("point", fmt::format("{:.3f}", used_.point));
    EXPECT_GT(used_.point, 0.05) << "so wide a model tells nothing";
}

TEST_P(RayRoundingOfCameras, HoldsTheWorstThatGlslAllows) {
    Random random(20261123 + unsigned(GetParam()));
    for (int k = 0; k < 300 && !HasFailure(); ++k) {
        const Case c = random_case(random, GetParam());
        SCOPED_TRACE(fmt::format("camera {}", k));
        for (int n = 0; n < 16; ++n) {
            // Corners are worst.
            const bool corner = random.below(2) != 0;
            const glm::ivec2 pixel =
                corner ? glm::ivec2(random.below(2), random.below(2)) * (c.size - 1)
                       : glm::ivec2(random.below(c.size.x), random.below(c.size.y));
            Worst worst(random);
            check(
                c, pixel, random,
                [&](const Uniforms& uniforms) { return worst.ray(uniforms, c.size, pixel); },
                [&](const Worst::Ray& ray, float t) { return worst.point(ray, double(t)); });
        }
    }
    RecordProperty("anchor", fmt::format("{:.3f}", used_.anchor));
    RecordProperty("direction", fmt::format("{:.3f}", used_.direction));
    RecordProperty("point", fmt::format("{:.3f}", used_.point));
    EXPECT_GT(used_.point, 0.5) << "the constants are far above what GLSL allows";
}

INSTANTIATE_TEST_SUITE_P(Cameras, RayRoundingOfCameras, testing::Range(0, int(kinds.size())));

} // namespace
} // namespace isomotion::scene::ray_rounding_test
