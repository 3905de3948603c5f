// What sections take away of a ray: geometry of half-spaces and balls, no field.
//
// A section takes a half-space or a ball away from the solid F < 0. What is left has a surface of
// two kinds: where F is 0 outside of all sections, and caps, which are places of a section's own
// surface where F < 0 and no other section is.
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

    // Above 0 in what it takes away; a distance, but within a ball.
    double value(const glm::dvec3& p) const;
    // Unit length, into what it takes away; the x axis in the middle of a ball.
    glm::dvec3 gradient(const glm::dvec3& p) const;
    bool operator==(const SectionAt&) const = default;
};

// From world to formula coordinates.
SectionAt in_formula_coordinates(const SectionAt& section, const PlacementAt& placement);

// As shaders have it: uniform `sections` of shaders/section/sections.glsl.
std::vector<glm::vec4> packed(std::span<const SectionAt> sections);

// A part of a line anchor + t direction (unit length) that no section takes away, as long as it can
// be; at each end the section that ends it, or none where the line itself ends.
struct PartLeft {
    double begin = 0, end = 0;
    std::optional<int> begin_cut, end_cut;
};

// What sections leave of the line from `near` to `far`, in order; parts of no length are left out.
std::vector<PartLeft> parts_left(std::span<const SectionAt> sections, const glm::dvec3& anchor,
                             const glm::dvec3& direction, double near, double far);

} // namespace isomotion::scene
