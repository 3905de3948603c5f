// A pixel's ray as the shader makes it in float32, in every order a driver may evaluate it.
#pragma once

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <utility>

#include <glm/glm.hpp>

#include "scene/rays.h"
#include "unit/formula/testing.h"

namespace isomotion::roots {

static_assert(FLT_EVAL_METHOD == 0, "float is to be rounded to float");

class Random : public formula::Random {
public:
    using formula::Random::Random;
    // A number of any magnitude between these.
    double size(double low, double high) { return std::exp(in(std::log(low), std::log(high))); }
    glm::dvec3 direction() {
        for (;;) {
            const glm::dvec3 v(in(-1, 1), in(-1, 1), in(-1, 1));
            const double length = glm::length(v);
            if (length > 0.1 && length < 1) return v / length;
        }
    }
};

// What GLSL leaves to the driver. Functions other than sums and products may be off by a few units
// in the last place; a sum of products may be fused from either end.
struct Driver {
    bool fused = false;
    bool flat = false;       // the ray's vectors are summed one by one, not through `across`
    bool up_first = false;   // v * up before u * right
    bool reciprocal = false; // a / b as a * (1 / b)
    int root_ulps = 0, quotient_ulps = 0;

    explicit Driver(Random& random)
        : fused(random.below(2))
        , flat(random.below(2))
        , up_first(random.below(2))
        , reciprocal(random.below(2))
        , root_ulps(random.below(5) - 2)
        , quotient_ulps(random.below(5) - 2) {}

    float mad(float a, float b, float c) const { return fused ? std::fma(a, b, c) : a * b + c; }
    static float off(float a, int ulps) { return a + float(ulps) * std::abs(a) * 0x1p-23f; }
    float root(float a) const { return off(std::sqrt(a), root_ulps); }
    float quotient(float a, float b) const {
        return off(reciprocal ? a * (1 / b) : a / b, quotient_ulps);
    }
    float dot(const glm::vec3& a, const glm::vec3& b) const {
        return up_first ? mad(a.x, b.x, mad(a.y, b.y, a.z * b.z))
                        : mad(a.z, b.z, mad(a.y, b.y, a.x * b.x));
    }
    glm::vec3 mad(float a, const glm::vec3& b, const glm::vec3& c) const {
        return {mad(a, b.x, c.x), mad(a, b.y, c.y), mad(a, b.z, c.z)};
    }
};

// shaders/march/ray.glsl and the two clips.
struct DrawnRay {
    glm::vec3 anchor, direction;
    float near, far;

    bool empty() const { return !(near <= far); }
    glm::vec3 point(const Driver& driver, float t) const {
        return driver.mad(t, direction, anchor);
    }
};

struct Uniforms {
    glm::vec3 origin, axis, right, up;
    float parallel;
    scene::Bounds::Shape shape;
    glm::vec3 min, max, centre;
    float radius;
    glm::vec2 picture;

    Uniforms(const scene::SceneAt& now, int width, int height, const scene::Aim& aim = {}) {
        const scene::Rays rays = scene::rays(now, width, height, aim);
        origin = rays.origin;
        axis = rays.axis;
        right = rays.right;
        up = rays.up;
        parallel = rays.parallel ? 0.0f : 1.0f;
        shape = now.surfaces[0].bounds.shape;
        min = now.surfaces[0].bounds.min;
        max = now.surfaces[0].bounds.max;
        centre = now.surfaces[0].bounds.centre;
        radius = float(now.surfaces[0].bounds.radius);
        picture = {float(2.0 / width), float(2.0 / height)};
    }
};

inline std::pair<float, float> clip_sphere(const Uniforms& is, const Driver& driver,
                                           const glm::vec3& anchor, const glm::vec3& direction) {
    const glm::vec3 from_centre = anchor - is.centre;
    const float middle = -driver.dot(from_centre, direction);
    const glm::vec3 foot = driver.mad(middle, direction, from_centre);
    const float square = driver.fused ? std::fma(is.radius, is.radius, -driver.dot(foot, foot))
                                      : is.radius * is.radius - driver.dot(foot, foot);
    if (square < 0) return {1.0f, 0.0f};
    const float half_chord = driver.root(square);
    return {middle - half_chord, middle + half_chord};
}

inline std::pair<float, float> clip_box(const Uniforms& is, const Driver& driver,
                                        const glm::vec3& anchor, const glm::vec3& direction) {
    float near = -HUGE_VALF, far = HUGE_VALF;
    for (int k = 0; k < 3; ++k) {
        const float slope = std::abs(direction[k]) < 1e-12f ? 1e-12f : direction[k];
        const float a = driver.quotient(is.min[k] - anchor[k], slope);
        const float b = driver.quotient(is.max[k] - anchor[k], slope);
        near = std::max(near, std::min(a, b));
        far = std::min(far, std::max(a, b));
    }
    if (near <= far) return {near, far};
    return {1.0f, 0.0f};
}

// `row` counts from the bottom.
inline DrawnRay drawn(const Uniforms& is, const Driver& driver, int column, int row) {
    const float u = driver.mad(float(column) + 0.5f, is.picture.x, -1.0f);
    const float v = driver.mad(float(row) + 0.5f, is.picture.y, -1.0f);
    const glm::vec3 first = driver.up_first ? is.up : is.right;
    const glm::vec3 second = driver.up_first ? is.right : is.up;
    const float of_first = driver.up_first ? v : u, of_second = driver.up_first ? u : v;
    DrawnRay ray;
    glm::vec3 from_eye = is.axis;
    if (driver.flat) {
        ray.anchor = driver.mad(of_second, second, driver.mad(of_first, first, is.origin));
        if (is.parallel != 0) {
            from_eye = driver.mad(of_second, second, driver.mad(of_first, first, is.axis));
        }
    } else {
        const glm::vec3 across = driver.mad(of_second, second, of_first * first);
        ray.anchor = is.origin + across;
        from_eye = driver.mad(is.parallel, across, is.axis);
    }
    const float distance = driver.root(driver.dot(from_eye, from_eye));
    for (int k = 0; k < 3; ++k) ray.direction[k] = driver.quotient(from_eye[k], distance);
    const bool box = is.shape == scene::Bounds::Shape::box;
    const auto inside = box ? clip_box(is, driver, ray.anchor, ray.direction)
                            : clip_sphere(is, driver, ray.anchor, ray.direction);
    ray.near = std::max(inside.first, -distance);
    ray.far = inside.second;
    return ray;
}

} // namespace isomotion::roots
