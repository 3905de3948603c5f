// Runs shaders/effects/material.glsl on the GPU.
#pragma once

#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "gpu/program.h"

namespace isomotion::effects {

// Directions away from the surface.
struct Geometry {
    glm::vec3 normal, to_viewer, to_light;
};

struct Gloss {
    glm::vec3 albedo;
    glm::vec4 numbers; // the uniform `gloss`
};

class BrdfOnGpu {
public:
    // `call` is a vec3 in GLSL of albedo, normal, to_viewer and to_light.
    explicit BrdfOnGpu(const std::string& model,
                       const std::string& call = "reflected(albedo, normal, to_viewer, to_light)");

    std::vector<glm::vec3> operator()(const Gloss& gloss,
                                      const std::vector<Geometry>& places) const;

private:
    gpu::Program program_;
};

} // namespace isomotion::effects
