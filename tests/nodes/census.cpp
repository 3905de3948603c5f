#include "nodes/census.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <unistd.h>

namespace isomotion {
namespace {

scene::Scene scene_of(const std::string& text, const std::vector<scene::Override>& settings) {
    setenv("ISOMOTION_DATA", ISOMOTION_SOURCE_DIR, /*overwrite=*/1);
    const auto file =
        std::filesystem::temp_directory_path() / fmt::format("isomotion-nodes-{}.toml", getpid());
    std::ofstream(file) << text;
    scene::Scene scene = scene::load(file.string(), settings);
    std::filesystem::remove(file);
    return scene;
}

} // namespace

std::uint64_t census_seed() {
    const char* given = std::getenv("ISOMOTION_SEED");
    return given ? std::strtoull(given, nullptr, 10) : 1;
}

Census census_of(const std::string& surface, const std::vector<scene::Override>& settings) {
    const scene::Scene scene = scene_of("[surface]\n" + surface + "\n", settings);
    const std::vector<double> tracks =
        scene.surfaces[0].animation.at(scene.timeline.time(1)).tracks;
    formula::Bindings<double> bindings;
    bindings.parameters.assign(tracks.begin(), tracks.begin() + scene.surfaces[0].parameters);
    Effort effort;
    effort.seed = census_seed();
    return singular_points(*scene.surfaces[0].field, bindings, effort);
}

std::string describe(const Census& census) {
    std::vector<double> radii;
    for (const SingularPoint& node : census.nodes)
        radii.push_back(std::round(1e9 * node.radius()) / 1e9);
    std::sort(radii.begin(), radii.end());
    std::string shells;
    for (auto first = radii.begin(); first != radii.end();) {
        const auto next = std::upper_bound(first, radii.end(), *first + 1e-7);
        shells += fmt::format("{}{} x {:.6g}", shells.empty() ? "" : ", ", next - first, *first);
        first = next;
    }
    std::string points;
    constexpr std::size_t most = 6;
    for (std::size_t k = 0; k < std::min(most, census.degenerate.size()); ++k) {
        const glm::dvec3 p = census.degenerate[k].position();
        points += fmt::format("{}rank {} at ({:.3g}, {:.3g}, {:.3g})", k ? ", " : "",
                              census.degenerate[k].rank, p.x, p.y, p.z);
    }
    if (census.degenerate.size() > most) points += ", ...";
    return fmt::format("{} nodes ({}), {} degenerate ({}); {} starts, seed {}, nearest miss {:.1e}",
                       census.nodes.size(), shells, census.degenerate.size(), points, census.starts,
                       census_seed(), census.nearest_miss);
}

} // namespace isomotion
