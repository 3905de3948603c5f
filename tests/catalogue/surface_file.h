// The catalogue's surfaces, as a scene gets them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scene/scene_at.h"
#include "unit/formula/testing.h"

namespace isomotion::catalogue {

// The source tree's files are read, wherever the test was built.
void use_source_tree();

// A parameter of a surface's file.
struct Parameter {
    std::string name;
    double preset = 0, min = 0, max = 0;
};
std::vector<Parameter> parameters_of(const std::string& surface);

using Setting = std::pair<std::string, double>;

// No setting, then each parameter at each end of its range, the others at their defaults.
std::vector<std::vector<Setting>> ends_of_parameters(const std::string& surface);
// No setting, then all parameters at the lower end, then all at the upper.
std::vector<std::vector<Setting>> both_ends(const std::string& surface);
std::string describe(const std::vector<Setting>& settings);

// The surface in a scene that says no more than `use` and these parameters.
struct Used {
    scene::Scene scene;
    scene::SceneAt at; // its first frame

    const formula::Field& field() const { return *scene.surfaces[0].field; }
    formula::Bindings<double> bindings() const {
        return formula::convert<double>(at.surfaces[0].bindings);
    }
};
Used used(const std::string& surface, const std::vector<Setting>& settings = {});

// Evenly spread in the bounds, and on their boundary.
glm::dvec3 point_in(const scene::BoundsAt& bounds, formula::Random& random);
glm::dvec3 point_on(const scene::BoundsAt& bounds, formula::Random& random);

inline formula::Point as_inputs(const glm::dvec3& p) { return {p.x, p.y, p.z}; }

} // namespace isomotion::catalogue
