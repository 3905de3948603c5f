#pragma once

#include <cmath>

namespace water {

/// A vector of float. Everything here is made of + - * / and square roots, which IEEE 754 fixes to
/// the bit: a simulation gives the same bytes on every machine that has it.
struct Vec3 {
    float x = 0, y = 0, z = 0;

    Vec3& operator+=(Vec3 b) { return *this = {x + b.x, y + b.y, z + b.z}; }
    Vec3& operator-=(Vec3 b) { return *this = {x - b.x, y - b.y, z - b.z}; }
};

inline Vec3 operator+(Vec3 a, Vec3 b) { return a += b; }
inline Vec3 operator-(Vec3 a, Vec3 b) { return a -= b; }
inline Vec3 operator*(float s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
inline float dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline float length(Vec3 a) { return std::sqrt(dot(a, a)); }

} // namespace water
