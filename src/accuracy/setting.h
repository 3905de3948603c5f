// The settings that an accuracy sweep varies.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace isomotion::accuracy {

struct Setting {
    scene::Method method = scene::Method::amp_sign;
    double step = 0;
    double thresholds = 1; // factor on the scene's near, far and horizon
    int bisections = 10;
    double safety = 32; // of hermite, which ignores the three above
};

// "amp-sign step=0.015", with thresholds and bisections where they differ from the scene's;
// "hermite safety=32".
std::string name(const Setting& setting, const scene::Isolation& scene);

// The scene with the setting instead of its own. The first surface's own setting leaves the other
// surfaces of a scene with theirs; any other setting applies to all.
scene::Scene apply(const Setting& setting, scene::Scene scene);

// Each method once: methods with steps at each step, hermite with several safeties; the scene's own
// method and step also with other thresholds and numbers of bisections. Without `methods`: all that
// can draw the scene. Throws SceneError, with the surface's place, for a method that cannot draw
// one of the surfaces. Without `steps`: the scene's step, times 4 and 2, and down to 1/8 of it.
std::vector<Setting> sweep(const scene::Scene& scene, std::vector<scene::Method> methods,
                           std::vector<double> steps);

} // namespace isomotion::accuracy
