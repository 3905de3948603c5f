// The first root of a field on one exact ray, by Arb: what certified ray casting says of a whole
// tube, asked once more of its middle.
//
// A piece of the ray is free of roots if the ball of F over it leaves out 0, if F is monotone and
// has one sign at both ends, or if the slope is too small to reach 0 from both ends (Piyavskii
// 1972). Other pieces are halved. F at a point has `precision` bits; t is a double, so nothing is
// said of pieces narrower than some doubles.
// dF/dt is the program that truth runs too; ball_program_test holds it against difference
// quotients.
#pragma once

#include <glm/glm.hpp>

#include "arb/ball_program.h"
#include "formula/enclosure.h"

namespace isomotion::roots_arb {

using ball::Ball;
using ball::BallProgram;

struct Ray {
    glm::dvec3 anchor{0}, direction{0}; // points are anchor + t * direction, exactly
};

struct Search {
    // The first certain change of sign is between low and high, two doubles close together.
    bool crosses = false;
    double low = 0, high = 0;
    // Pieces before it, or on the entire ray, that could not be told from zero. The first and the
    // last one's ends.
    int unproven = 0;
    double unproven_low = 0, unproven_high = 0;
    bool budget_ended = false; // what is beyond is unproven
};

// Keeps hold of the field's programs.
class ThinRays {
public:
    ThinRays(const formula::EnclosurePrograms& field, const formula::Bindings<float>& bindings)
        : value_(field.value)
        , along_(field.directional)
        , bindings_(formula::convert<double>(bindings)) {}

    int sign_at(const Ray& ray, double t) { return at(ray, t).sign(); }
    // Roots in [from, to], of at most `budget` pieces.
    Search search(const Ray& ray, double from, double to, int budget);

    static constexpr slong precision = 200;

private:
    struct Piece;
    Ball at(const Ray& ray, double t);
    bool is_free(const Ray& ray, const Piece& piece);

    BallProgram value_, along_;
    formula::Bindings<double> bindings_;
};

} // namespace isomotion::roots_arb
