// The parts of a ray that sections take away. Only half-spaces and balls are used here, not the
// field.
//
// A section takes a half-space or a ball away from the solid F < 0. The remaining solid has two
// kinds of surface: places outside of all sections where F is 0, and caps. A cap is the part of a
// section's own surface where F < 0 and which lies in no other section.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace isomotion::scene {

struct PlacementAt;

// A half-space, dot(where, p) > reach with `where` of unit length, or a ball, |p - where| < reach.
struct SectionAt {
    bool is_ball = false;
    glm::dvec3 where{0, 0, 1};
    double reach = 0;

    // Positive inside the part that is taken away. A distance, except inside a ball.
    double value(const glm::dvec3& p) const;
    // Unit length, into the part that is taken away. The x axis in the middle of a ball.
    glm::dvec3 gradient(const glm::dvec3& p) const;
    bool operator==(const SectionAt&) const = default;
};

// Moves a section from world to formula coordinates.
SectionAt in_formula_coordinates(const SectionAt& section, const PlacementAt& placement);

// The sections in the layout of the uniform `sections` of shaders/section/sections.glsl.
std::vector<glm::vec4> packed(std::span<const SectionAt> sections);

// A longest part of a line anchor + t direction (unit length) that no section takes away. The cuts
// are the sections that end it at each end; none where the line itself ends.
struct PartLeft {
    double begin = 0, end = 0;
    std::optional<int> begin_cut, end_cut;
};

// The parts of the line from `near` to `far` that sections leave, in order. Parts of zero length
// are left out.
std::vector<PartLeft> parts_left(std::span<const SectionAt> sections, const glm::dvec3& anchor,
                                 const glm::dvec3& direction, double near, double far);

} // namespace isomotion::scene
