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

std::vector<scene::Override> render_settings(const Session& session) {
    const Look& look = session.look();
    const scene::Scene& scene = session.scene();
    const animation::Animation& animation = scene.timeline.animation;
    std::vector<scene::Override> all;
    for (const auto& [name, value] : look.overrides.values) {
        // A scene that was read again may have it no more: then it holds nothing.
        if (!animation.find(name)) continue;
        const bool of_array = name.find('.') != name.npos;
        all.push_back(fmt::format("{}{}={}", of_array ? "arrays." : "", name, value));
    }
    for (const auto& [name, factor] : look.overrides.factors) {
        if (auto setting = multiplied(animation, name, factor)) {
            all.push_back(*std::move(setting));
        }
    }
    if (look.camera) {
        all.push_back("camera=" + inline_table(camera_text(*look.camera, scene.camera.shutter)));
    }
    const scene::Isolation& own = scene.isolation;
    const scene::Isolation& used = look.isolation;
    if (used.method != own.method) {
        all.push_back(fmt::format("isolation.method=\"{}\"", scene::name(used.method)));
    }
    // What a scene leaves out follows from its first frame, which a released parameter moves: all
    // of them are said.
    all.push_back(fmt::format("isolation.step={}", used.step));
    all.push_back(fmt::format("isolation.near={}", used.near));
    all.push_back(fmt::format("isolation.far={}", used.far));
    all.push_back(fmt::format("isolation.horizon={}", used.horizon));
    all.push_back(fmt::format("isolation.bisections={}", used.bisections));
    all.push_back(fmt::format("isolation.safety={}", used.safety));
    all.push_back(fmt::format("isolation.limit={}", used.limit));
    return all;
}

} // namespace isomotion::player
