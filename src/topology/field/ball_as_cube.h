// A ball of bounds in the coordinates of a cube, so that what is proved of surfaces in boxes is
// proved of surfaces in balls.
//
// With a_k = y_k^2, the point y of [-1, 1]^3 is mapped to c + r y / sqrt(p), where
// p = 1 + a_1 a_2 + a_2 a_3 + a_3 a_1 - a_1 a_2 a_3. The map is smooth. It is one to one from the
// cube onto the ball, and takes the cube's walls to the sphere (docs/topology-frames.md).
//
// All functions take boxes of the cube and of a little beyond it: |y_k| <= 1 + 2^-20.
#pragma once

#include "scene/scene_at.h"
#include "topology/field/space_box.h"

namespace isomotion::topology {

class BallAsCube {
public:
    explicit BallAsCube(const scene::BoundsAt& ball);

    static scene::BoundsAt cube();

    // Holds the places in space of a box's points, narrowly.
    SpaceBox place(const SpaceBox& y) const;

    // The map's slopes over a box.
    class Slopes {
    public:
        Slopes(const SpaceBox& y, double radius);

        // Slopes and second derivatives by y of a function, from those by its place in space.
        SpaceBox gradient(const SpaceBox& in_space) const;
        SpaceHessian hessian(const SpaceBox& gradient_in_space, const SpaceHessian& in_space) const;

    private:
        SpaceBox turned(const SpaceBox& in_space) const; // for a radius of 1

        double radius_;
        SpaceBox y_, squares_;
        formula::Interval root_, cubed_; // q = p^(-1/2)
        SpaceBox rates_, halves_;        // m_k and y_k m_k, where dp/dy_k = 2 y_k m_k
        SpaceBox first_;                 // slopes of q
        SpaceHessian place_by_y_;        // for a radius of 1; a row for each coordinate's place
    };
    Slopes slopes(const SpaceBox& y) const { return {y, radius_}; }

private:
    std::array<double, 3> centre_;
    double radius_;
    formula::Interval reach_; // the radius, with what places in the cube err by
};

} // namespace isomotion::topology
