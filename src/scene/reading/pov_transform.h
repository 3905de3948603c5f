// Where translate, rotate and scale of POV-Ray take an object.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <glm/glm.hpp>

#include "scene/reading/pov_values.h"

namespace isomotion::scene {

// In this program's axes (scene/reading/pov.h). One after the other, as POV-Ray has them.
class PovTransform {
public:
    // Reads one, if it is at one. Fails for those that change angles.
    bool read(PovCursor& at, PovValues& values);
    // The value of surface.transform; none where the object stays.
    std::optional<std::string> toml() const;

private:
    void translate(const std::vector<PovNumber>& by);
    void rotate(const std::vector<PovNumber>& angles, const PovCursor& at);
    void scale(double by, const PovCursor& at);
    void expect_still(const PovCursor& at, std::string_view what) const;

    glm::dmat3 rotation_{1};
    double scale_ = 1;
    glm::dvec3 still_{0};                        // of the translation
    std::optional<std::vector<PovNumber>> last_; // further translations that move
    std::optional<std::vector<PovNumber>> turn_; // about one axis, that moves
    bool is_there_ = false;
};

} // namespace isomotion::scene
