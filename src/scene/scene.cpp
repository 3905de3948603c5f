#include "scene/scene.h"

#include <stdexcept>

#include <fmt/format.h>

namespace isomotion::scene {

std::size_t only(std::size_t surfaces) {
    if (surfaces == 1) return 0;
    throw std::logic_error(fmt::format("a scene of {} surfaces where one is asked for", surfaces));
}

std::string reload_argument(const Scene& scene) {
    return scene.formula.empty() ? std::filesystem::absolute(scene.file).string() : scene.formula;
}

} // namespace isomotion::scene
