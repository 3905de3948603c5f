// POV-Ray's transformations as this program's surface.transform.
#pragma once

#include <optional>
#include <string>

#include <glm/glm.hpp>

#include "scene/reading/pov_moves.h"

namespace isomotion::scene {

// Transforms in this program's axes (scene/reading/pov.h). They apply in order, as in POV-Ray.
class PovTransform {
public:
    // False for what surface.transform cannot say: another scale along each axis, a matrix, a
    // motion before another one. What was added before is of no use then.
    bool add(const PovMove& move);
    // The value of surface.transform; none if the object stays in place.
    std::optional<std::string> toml() const;

private:
    bool translate(const PovValue& by);
    bool rotate(const PovValue& angles);
    bool scale(const PovValue& by);

    glm::dmat3 rotation_{1};
    double scale_ = 1;
    glm::dvec3 still_{0};          // of the translation, the constant part
    std::optional<PovValue> last_; // further translations that move
    std::optional<PovValue> turn_; // a rotation about one axis that moves
    bool is_there_ = false;
};

} // namespace isomotion::scene
