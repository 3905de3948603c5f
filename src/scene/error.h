#pragma once

#include <stdexcept>
#include <string>

#include "scene/printable.h"

namespace isomotion::scene {

// A mistake in a scene: what() is "file:line: key: what is wrong, and what would be right". Names
// and texts of the scene in it are printable.
class SceneError : public std::runtime_error {
public:
    explicit SceneError(const std::string& message)
        : std::runtime_error(printable(message)) {}
};

} // namespace isomotion::scene
