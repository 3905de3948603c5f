// Composes POV-Ray's translate, rotate and scale of an object.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <glm/glm.hpp>

#include "scene/reading/pov_values.h"

namespace isomotion::scene {

// Transforms in this program's axes (scene/reading/pov.h). They apply in order, as in POV-Ray.
class PovTransform {
public:
    // Reads one transform, if there is one here. Fails for a transform that changes angles.
    bool read(PovCursor& at, PovValues& values);
    // The value of surface.transform; none if the object stays in place.
    std::optional<std::string> toml() const;

private:
    void translate(const std::vector<PovNumber>& by);
    void rotate(const std::vector<PovNumber>& angles, const PovCursor& at);
    void scale(double by, const PovCursor& at);
    void expect_still(const PovCursor& at, std::string_view what) const;

    glm::dmat3 rotation_{1};
    double scale_ = 1;
    glm::dvec3 still_{0};                        // of the translation, the constant part
    std::optional<std::vector<PovNumber>> last_; // further translations that move
    std::optional<std::vector<PovNumber>> turn_; // a rotation about one axis that moves
    bool is_there_ = false;
};

} // namespace isomotion::scene
