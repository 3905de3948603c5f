#pragma once

#include <stdexcept>
#include <string>

namespace isomotion::scene {

// A mistake in a scene: what() is "file:line: key: what is wrong, and what would be right".
class SceneError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

} // namespace isomotion::scene
