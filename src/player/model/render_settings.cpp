#include "player/model/render_settings.h"

#include <optional>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

#include "player/model/camera_text.h"
#include "scene/method.h"

namespace isomotion::player {
namespace {

// The lines of a section as one table in braces.
std::string inline_table(const std::string& section) {
    std::istringstream lines(section);
    std::string table;
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line.front() == '[') continue;
        table += (table.empty() ? "" : ", ") + line;
    }
    return "{" + table + "}";
}

// A field of all elements, multiplied as controls.h does; none if there is no such field.
std::optional<scene::Override> multiplied(const animation::Animation& animation,
                                          const std::string& name, double factor) {
    if (animation.find(name)) return std::nullopt; // one value for all elements: no factor
    for (const animation::Array& array : animation.arrays()) {
        for (const animation::ArrayField& field : array.fields) {
            if (array.name + "." + field.name != name) continue;
            const std::string key = "arrays." + name;
            if (const auto* number = std::get_if<double>(&field.source)) {
                return fmt::format("{}={}", key, factor * *number);
            }
            if (const auto* list = std::get_if<std::vector<double>>(&field.source)) {
                std::vector<double> values = *list;
                for (double& value : values) value *= factor;
                return fmt::format("{}=[{}]", key, fmt::join(values, ", "));
            }
            if (const auto* text = std::get_if<animation::Expression>(&field.source)) {
                return fmt::format("{}=\"{}*({})\"", key, factor, text->text);
            }
            throw std::runtime_error(
                fmt::format("{} comes from a file and is multiplied here: give it back to save "
                            "frames",
                            name));
        }
    }
    return std::nullopt;
}

} // namespace

namespace {

void add_overrides(const animation::Animation& animation, const Overrides& overrides,
                   const std::string& surface, std::vector<scene::Override>& all) {
    const char* of_parameters = surface.empty() ? "" : "parameters.";
    for (const auto& [name, value] : overrides.values) {
        // A scene that was read again may no longer have the parameter: then nothing is held.
        if (!animation.find(name)) continue;
        const bool of_array = name.find('.') != name.npos;
        all.push_back(
            fmt::format("{}{}{}={}", surface, of_array ? "arrays." : of_parameters, name, value));
    }
    for (const auto& [name, factor] : overrides.factors) {
        if (auto setting = multiplied(animation, name, factor)) all.push_back(surface + *setting);
    }
}

} // namespace

std::vector<scene::Override> render_settings(const Session& session) {
    const Look& look = session.look();
    const scene::Scene& scene = session.scene();
    std::vector<scene::Override> all;
    // The method at hand is the first surface's.
    const bool has_several = scene.surfaces.size() > 1;
    const auto prefix = [&](std::size_t k) {
        return has_several ? fmt::format("surfaces.{}.", k + 1) : "";
    };
    const std::string first = prefix(0);
    for (std::size_t k = 0; k < scene.surfaces.size(); ++k) {
        add_overrides(scene.surfaces[k].animation, of_surface(look.overrides, {scene, k}),
                      prefix(k), all);
    }
    if (look.camera) {
        all.push_back("camera=" + inline_table(camera_text(*look.camera, scene.camera.shutter)));
    }
    const scene::Isolation& own = scene.surfaces.front().isolation;
    const scene::Isolation& used = look.isolation;
    if (used.method != own.method) {
        all.push_back(fmt::format("{}isolation.method=\"{}\"", first, scene::name(used.method)));
    }
    // What a scene leaves out follows from its first frame, which a released parameter moves: all
    // of them are said.
    all.push_back(fmt::format("{}isolation.step={}", first, used.step));
    all.push_back(fmt::format("{}isolation.near={}", first, used.near));
    all.push_back(fmt::format("{}isolation.far={}", first, used.far));
    all.push_back(fmt::format("{}isolation.horizon={}", first, used.horizon));
    all.push_back(fmt::format("{}isolation.bisections={}", first, used.bisections));
    all.push_back(fmt::format("{}isolation.safety={}", first, used.safety));
    all.push_back(fmt::format("{}isolation.limit={}", first, used.limit));
    return all;
}

} // namespace isomotion::player
