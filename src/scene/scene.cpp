#include "scene/scene.h"

namespace isomotion::scene {

std::string word_of(const Scene& scene) {
    return scene.formula.empty() ? std::filesystem::absolute(scene.file).string() : scene.formula;
}

} // namespace isomotion::scene
