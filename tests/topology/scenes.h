// Scenes at one time, for tests of topology.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <fmt/format.h>
#include <unistd.h>

#include "scene/reading/load.h"
#include "scene/scene_at.h"
#include "topology/field/frame_field.h"

namespace isomotion::topology {

inline scene::Scene scene_of(const std::string& text) {
    setenv("ISOMOTION_DATA", ISOMOTION_SOURCE_DIR, /*overwrite=*/1);
    const auto file = std::filesystem::temp_directory_path() /
                      fmt::format("isomotion-topology-{}.toml", getpid());
    std::ofstream(file) << text;
    scene::Scene scene = scene::load(file.string());
    std::filesystem::remove(file);
    return scene;
}

// A scene with elements from the file "table.csv".
inline scene::Scene scene_of(const std::string& text, const std::string& table) {
    setenv("ISOMOTION_DATA", ISOMOTION_SOURCE_DIR, /*overwrite=*/1);
    const auto folder =
        std::filesystem::temp_directory_path() / fmt::format("isomotion-topology-{}", getpid());
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "scene.toml") << text;
    std::ofstream(folder / "table.csv") << table;
    scene::Scene scene = scene::load((folder / "scene.toml").string());
    std::filesystem::remove_all(folder);
    return scene;
}

inline scene::Scene still(const std::string& formula, const std::string& bounds) {
    return scene_of(fmt::format("[surface]\nformula = '''{}'''\nbounds = {}\n", formula, bounds));
}

// A scene of the repository's animations.
inline scene::Scene animated(const std::string& name) {
    setenv("ISOMOTION_DATA", ISOMOTION_SOURCE_DIR, /*overwrite=*/1);
    return scene::load(fmt::format("{}/animations/{}.toml", ISOMOTION_SOURCE_DIR, name));
}

// What a scene's field needs at one time.
struct StillScene {
    formula::Bindings<double> numbers;
    formula::Bindings<formula::Interval> intervals;
    scene::BoundsAt bounds;
    std::shared_ptr<const formula::Field> field;

    StillScene(const scene::Scene& scene, double time)
        : field(scene.surfaces[0].field) {
        const scene::SceneAt now = scene::at(scene, time);
        numbers = formula::convert<double>(now.surfaces[0].bindings);
        intervals = formula::convert<formula::Interval>(numbers);
        bounds = now.surfaces[0].bounds;
    }

    SpaceFormula formula(Side solid) const { return space_formula(*field, intervals, solid); }
};

} // namespace isomotion::topology
