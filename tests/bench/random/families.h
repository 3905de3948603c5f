// Random surfaces by the class of their formulas: what a stranger may ask the renderer to draw.
// The same seed draws the same scenes on every machine.
#pragma once

#include <cstdint>
#include <ostream>
#include <span>
#include <string>
#include <string_view>

namespace isomotion::bench {

class Draw; // of random numbers: families.cpp

struct Family {
    std::string_view name;
    // The formula, of u, v and w, which are x, y and z turned and moved: at most some units wide.
    std::string (*formula)(Draw&);
    bool has_elements = false; // those of an array `blobs` with the fields cx cy cz a
};

std::span<const Family> families();

inline void PrintTo(const Family& family, std::ostream* out) { *out << family.name; }

// A scene, as TOML, seen by a camera somewhere outside of its bounds.
std::string random_scene(const Family& family, std::uint64_t seed, int size);

} // namespace isomotion::bench
