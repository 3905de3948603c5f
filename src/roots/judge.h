// Judges a pixel by what is certain about its ray.
#pragma once

#include <cstdint>
#include <string_view>

#include "roots/first_root.h"

namespace isomotion::roots {

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

// `t`: the place on its ray where the pixel was hit, if it was. Places less than a pixel's width
// apart count as equal. A ray that truth calls touching may be hit or not.
Fault judge(const FirstRoot& root, bool hit, double t, double footprint);

} // namespace isomotion::roots
