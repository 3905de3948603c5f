#include "cli.h"

#include <fstream>
#include <iterator>

namespace isomotion::cli {
namespace fs = std::filesystem;

std::string formula_scene(const std::string& formula) {
    return R"toml(title = "Sphere"
[time]
fps = "30000/1001"
frames = 60
[surface]
formula = ")toml" +
           formula + R"toml("
bounds = { sphere = 1.5 }
[parameters]
r = "1 + 0.2*sin(t)"
[camera]
position = [4, 0, 0]
fov = 40
[output]
size = [48, 48]
)toml";
}

std::string sphere_scene() { return formula_scene("x^2 + y^2 + z^2 - r^2"); }

void Cli::write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
}

Circumstances Cli::circumstances() const {
    return {.folder = folder(), .environment = {{"ISOMOTION_DATA", ISOMOTION_SOURCE_DIR}}};
}

Ending Cli::run(Words arguments, const Circumstances& circumstances) const {
    arguments.insert(arguments.begin(), tested_program(ISOMOTION_PROGRAM));
    return cli::run(arguments, circumstances);
}

Ending Cli::render(Words arguments, const std::string& warning) const {
    arguments.insert(arguments.begin(), "render");
    const Ending ending = run(arguments);
    EXPECT_EQ(ending.code, 0) << ending;
    if (warning.empty()) {
        EXPECT_THAT(ending.err, IsEmpty());
    } else {
        EXPECT_THAT(ending.err, testing::HasSubstr(warning));
    }
    return ending;
}

std::string Cli::bytes(const std::string& name) const {
    std::ifstream file(folder_ / name, std::ios::binary);
    EXPECT_TRUE(file) << name;
    return {std::istreambuf_iterator<char>(file), {}};
}

std::set<std::string> Cli::names(const std::string& inside) const {
    std::set<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder_ / inside)) {
        found.insert(entry.path().filename().string());
    }
    return found;
}

void Cli::expect_only_whole_files() const {
    for (const auto& entry : fs::recursive_directory_iterator(folder())) {
        if (!entry.is_regular_file()) continue;
        const fs::path& file = entry.path();
        EXPECT_THAT(file.filename().string(), Not(StartsWith(".")));
        EXPECT_GT(entry.file_size(), 0u) << file;
        if (file.extension() == ".png" || file.extension() == ".exr") {
            EXPECT_NO_THROW(image::decode(file)) << file;
        }
    }
}

} // namespace isomotion::cli
