// What is wrong with a pixel, against what is certain of its ray.
#pragma once

#include <cstdint>
#include <string_view>

#include "truth/first_root.h"

namespace isomotion::truth {

enum class Fault : std::uint8_t {
    none,
    missed,     // a certain root, but no hit was drawn
    false_hit,  // a hit where there certainly is no root
    wrong_root, // a hit behind the first root
    undecided,  // truth does not know
};

constexpr std::string_view words(Fault fault) {
    switch (fault) {
    case Fault::none:
        return "right";
    case Fault::missed:
        return "a root is missed";
    case Fault::false_hit:
        return "a hit where there is no root";
    case Fault::wrong_root:
        return "a hit behind the first root";
    case Fault::undecided:
        return "not known";
    }
    return "?";
}

// `t`: where on its ray the pixel was hit, if it was; places a pixel's width apart are one. What
// truth calls touching may be hit or not.
Fault judge(const FirstRoot& root, bool hit, double t, double footprint);

} // namespace isomotion::truth
