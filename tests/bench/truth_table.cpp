// What certified truth takes and leaves open: every surface of the catalogue and the two animations
// of the paper, as Markdown. truth_table [SIZE [SURFACE...]]
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "roots/certify.h"
#include "scene/reading/load.h"

namespace isomotion {
namespace {

void row(const std::string& name, const std::string& file, int size) {
    const scene::Scene scene =
        scene::load(file, {"look=none", fmt::format("output.size=[{0}, {0}]", size)});
    const scene::SceneAt now = scene::at_frame(scene, scene.output.poster);
    const auto start = std::chrono::steady_clock::now();
    const roots::Truth truth = roots::certify(scene, now, size, size);
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const auto counts = truth.counts();
    const double pixels = double(size) * size;
    fmt::print("| {:<22} | {:>7.1f} | {:>7.1f} | {:>7} | {:>9.0f} | {:>9.0f} |\n", name, seconds,
               double(truth.evaluations) / pixels, counts[std::size_t(roots::Answer::hit)],
               1e6 * double(counts[std::size_t(roots::Answer::touching)]) / pixels,
               1e6 * double(counts[std::size_t(roots::Answer::undecided)]) / pixels);
    std::fflush(stdout);
}

int main(int argc, char** argv) {
    const int size = argc > 1 ? std::stoi(argv[1]) : 512;
    const std::filesystem::path animations = ISOMOTION_SOURCE_DIR "/animations";
    std::vector<std::string> names(argv + std::min(argc, 2), argv + argc);
    if (names.empty()) {
        for (const auto& file : std::filesystem::directory_iterator(animations / "surfaces")) {
            names.push_back("surfaces/" + file.path().stem().string());
        }
        std::sort(names.begin(), names.end());
        names.insert(names.end(), {"blobby75", "twisting_superquadric"});
    }
    fmt::print("| scene, {0} x {0}{1:>9} | seconds | evals/px | hits | touch ppm | open ppm |\n"
               "|---|--:|--:|--:|--:|--:|\n",
               size, "");
    for (const std::string& name : names) {
        const bool surface = name.starts_with("surfaces/");
        const auto text = std::filesystem::temp_directory_path() / "isomotion-truth-table.toml";
        if (surface) {
            FILE* out = std::fopen(text.c_str(), "w");
            fmt::print(out, "[surface]\nuse = \"{}\"\n", name.substr(9));
            std::fclose(out);
        }
        row(name, surface ? text.string() : (animations / (name + ".toml")).string(), size);
    }
    return 0;
}

} // namespace
} // namespace isomotion

int main(int argc, char** argv) { return isomotion::main(argc, argv); }
