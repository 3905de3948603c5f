#include "methods/subject.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <toml++/toml.h>
#include <unistd.h>

#include "scene/reading/load.h"

namespace isomotion::bench {
namespace {

scene::Scene scene_of(const std::string& text) {
    const auto file = std::filesystem::temp_directory_path() /
                      ("isomotion-methods-" + std::to_string(getpid()) + ".toml");
    std::ofstream(file) << text;
    scene::Scene scene = scene::load(file.string());
    std::filesystem::remove(file);
    return scene;
}

// Even in height and turned by the golden angle; cube roots of numbers evenly in [0, 1) from the
// middle.
constexpr const char* blobs_scene = R"toml(
[surface]
formula = "sum(blobs, exp(-a*((x-cx)^2 + (y-cy)^2 + (z-cz)^2 - R^2))) - 1"
bounds = {{ sphere = {bounds} }}

[parameters]
a = {a}
R = {radius}

[arrays.blobs]
count = {count}
height = "1 - (2*i + 1)/n"
turn = "2.399963229728653*i"
out = "(0.7548776662466927*i - floor(0.7548776662466927*i))^(1/3)"
cx = "out*sqrt(1 - height^2)*cos(turn)"
cy = "out*sqrt(1 - height^2)*sin(turn)"
cz = "out*height"

[isolation]
step = {step}
near = 0.8
far = 0.98
horizon = {horizon}
)toml";

} // namespace

std::vector<std::string> table_1() {
    const toml::table paper =
        toml::parse_file(ISOMOTION_SOURCE_DIR "/tests/bench/paper_tables.toml");
    std::vector<std::pair<std::uint32_t, std::string>> by_line;
    for (const auto& [name, row] : paper) {
        if (row.as_table()->contains("sign")) {
            by_line.emplace_back(row.source().begin.line, name.str());
        }
    }
    std::sort(by_line.begin(), by_line.end());
    std::vector<std::string> names;
    for (const auto& [line, name] : by_line) names.push_back(name);
    return names;
}

Subject surface(const std::string& name) {
    return {name, scene_of("[surface]\nuse = \"" + name + "\"\n")};
}

Subject lit(const std::string& name, int lights) {
    std::string text = "[surface]\nuse = \"" + name + "\"\n";
    for (int k = 0; k < lights; ++k) {
        const double turn = 2 * 3.14159265358979323846 * k / lights;
        text += fmt::format(
            "[[lights]]\ndirection = [{0}, {1}, -1]\nshadow = true\ncolor = [{2}, {2}, {2}]\n",
            std::cos(turn), std::sin(turn), 1.0 / lights);
    }
    return {name, scene_of(text)};
}

Subject animation(const std::string& name, std::vector<int> frames) {
    return {name, scene::load(ISOMOTION_SOURCE_DIR "/animations/" + name + ".toml", {"look=none"}),
            std::move(frames)};
}

Subject blobs(int count) {
    const double grain = std::cbrt(75.0 / count);
    const double a = 32 / (grain * grain), radius = 0.25 * grain;
    const double reach = std::sqrt(radius * radius + std::log(count) / a); // beyond, F < 0
    return {
        fmt::format("{} blobs", count),
        scene_of(fmt::format(blobs_scene, fmt::arg("count", count), fmt::arg("a", a),
                             fmt::arg("radius", radius), fmt::arg("bounds", 1 + reach),
                             fmt::arg("step", 0.05 * grain), fmt::arg("horizon", 1.5 / grain)))};
}

} // namespace isomotion::bench
