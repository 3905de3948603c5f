// Runs a field's generated GLSL on the GPU, assembled from the pieces that scenes are assembled of.
#pragma once

#include <array>
#include <vector>

#include <glm/glm.hpp>

#include "formula/field.h"

namespace isomotion::shader {

// One of the functions a field has, on both sides.
struct FunctionOfField {
    const char* name;
    const formula::Program formula::Field::*program;
    int outputs;
};

inline constexpr std::array<FunctionOfField, 3> field_functions{
    {{"field", &formula::Field::value, 1},
     {"field_directional", &formula::Field::directional, 2},
     {"field_gradient", &formula::Field::gradient, 3}}};

// A point, and a direction for the slope along it.
struct Probe {
    glm::vec3 p, d;
};

// What each of field_functions gives at every probe, in the current context; outputs come first.
std::array<std::vector<glm::vec4>, 3> run_on_gpu(const formula::Field& field,
                                                 const formula::Bindings<float>& bindings,
                                                 const std::vector<Probe>& probes);

// x, y, z, dx, dy, dz.
using GpuBox = std::array<glm::vec2, 6>;

// F; F and dF/dt; the gradient.
struct GpuBounds {
    std::array<glm::vec2, 6> outputs;
};

// What field_interval, field_directional_interval and field_gradient_interval give over every box.
std::vector<GpuBounds> bounds_on_gpu(const formula::Field& field,
                                     const formula::Bindings<float>& bindings,
                                     const std::vector<GpuBox>& boxes);

// The same in doubles, in a context of OpenGL 4.0.
using DoubleBox = std::array<glm::dvec2, 6>;
std::vector<DoubleBox> double_bounds_on_gpu(const formula::Field& field,
                                            const formula::Bindings<float>& bindings,
                                            const std::vector<DoubleBox>& boxes);

} // namespace isomotion::shader
