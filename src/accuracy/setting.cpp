#include "accuracy/setting.h"

#include <utility>

#include <fmt/format.h>

namespace isomotion::accuracy {

std::string name(const Setting& setting, const scene::Isolation& scene) {
    if (setting.method == scene::Method::hermite) {
        return fmt::format("hermite safety={:g}", setting.safety);
    }
    if (!scene::takes_steps(setting.method)) return std::string(scene::name(setting.method));
    std::string text = fmt::format("{} step={:g}", scene::name(setting.method), setting.step);
    if (setting.thresholds != 1) text += fmt::format(" thresholds*{:g}", setting.thresholds);
    if (setting.bisections != scene.bisections) {
        text += fmt::format(" bisections={}", setting.bisections);
    }
    return text;
}

namespace {

bool is_own(const Setting& setting, const scene::Isolation& own) {
    return setting.method == own.method && setting.step == own.step && setting.thresholds == 1 &&
           setting.bisections == own.bisections && setting.safety == own.safety;
}

} // namespace

scene::Scene apply(const Setting& setting, scene::Scene scene) {
    const scene::Isolation first = scene.surfaces.front().isolation;
    const bool keeps_others = is_own(setting, first);
    for (scene::Surface& surface : scene.surfaces) {
        const bool is_first = &surface == &scene.surfaces.front();
        if (!is_first && keeps_others) break;
        scene::Isolation& isolation = surface.isolation;
        // Steps are lengths of each surface's own.
        isolation.step = is_first ? setting.step : setting.step * (isolation.step / first.step);
        isolation.method = setting.method;
        isolation.near *= setting.thresholds;
        isolation.far *= setting.thresholds;
        isolation.horizon *= setting.thresholds;
        isolation.bisections = setting.bisections;
        isolation.safety = setting.safety;
    }
    return scene;
}

std::vector<Setting> sweep(const scene::Scene& scene, std::vector<scene::Method> methods,
                           std::vector<double> steps) {
    const scene::Isolation& own = scene.surfaces.front().isolation;
    const bool narrowed = !methods.empty() || !steps.empty();
    if (methods.empty()) {
        for (const scene::MethodTraits& entry : scene::method_traits)
            methods.push_back(entry.method);
    }
    if (steps.empty()) {
        for (const double factor : {4.0, 2.0, 1.0, 0.5, 0.25, 0.125}) {
            steps.push_back(factor * own.step);
        }
    }
    std::vector<Setting> settings;
    for (const scene::Method method : methods) {
        if (method == scene::Method::hermite) {
            for (const double factor : {0.0625, 0.25, 1.0, 4.0}) {
                settings.push_back({method, own.step, 1, own.bisections, factor * own.safety});
            }
            continue;
        }
        if (!scene::takes_steps(method)) {
            settings.push_back({method, own.step, 1, own.bisections, own.safety});
            continue;
        }
        for (const double step : steps) {
            settings.push_back({method, step, 1, own.bisections, own.safety});
        }
    }
    if (narrowed || !scene::takes_steps(own.method)) return settings;
    for (const double factor : {0.25, 4.0}) {
        settings.push_back({own.method, own.step, factor, own.bisections, own.safety});
    }
    for (const int bisections : {4, 16}) {
        settings.push_back({own.method, own.step, 1, bisections, own.safety});
    }
    return settings;
}

} // namespace isomotion::accuracy
