#include "testing.h"

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <unistd.h>

namespace isomotion::scene {
namespace fs = std::filesystem;

std::string ball() { return ball_with(0, ""); }

std::string ball_with(int number, const std::string& line) {
    const char* lines[] = {"title = \"A ball\"",
                           "[time]",
                           "fps = 30",
                           "frames = 60",
                           "[surface]",
                           "formula = \"x^2 + y^2 + z^2 - radius^2\"",
                           "bounds = { sphere = 1.5 }",
                           "[parameters]",
                           "radius = 1",
                           "[camera]",
                           "position = [4, 0, 0]",
                           "fov = 40",
                           "[output]",
                           "size = [64, 64]"};
    std::string text;
    for (int k = 1; k <= int(std::size(lines)); ++k) {
        text += (k == number ? line : lines[k - 1]) + std::string("\n");
    }
    return text;
}

std::string ball_and(const std::string& lines) { return ball() + lines + "\n"; }

std::string blobs(const std::string& array) {
    return "[surface]\n"
           "formula = \"sum(blobs, w*exp(-4*((x-cx)^2 + y^2 + z^2))) - 0.5\"\n"
           "bounds = { sphere = 3 }\n"
           "[arrays.blobs]\n" +
           array + "\n";
}

Scenes::Scenes() {
    std::string name = (fs::temp_directory_path() / "isomotion-scenes-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
    folder_ = name;
    fs::create_directories(folder_ / "shaders");
    fs::create_directories(folder_ / "animations" / "surfaces");
    ::setenv("ISOMOTION_DATA", name.c_str(), 1);
}

Scenes::~Scenes() {
    ::unsetenv("ISOMOTION_DATA");
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
}

fs::path Scenes::write(const std::string& name, const std::string& text) const {
    const fs::path file = folder_ / name;
    std::ofstream(file) << text;
    return file;
}

Scene Scenes::loaded(const std::string& text, const std::vector<Override>& overrides) const {
    return load(write("scene.toml", text).string(), overrides);
}

template<class Load> std::string Scenes::caught(Load&& load) const {
    std::string message = "nothing is wrong";
    try {
        load();
    } catch (const SceneError& error) {
        message = error.what();
    }
    const std::string prefix = folder_.string() + "/";
    for (auto at = message.find(prefix); at != message.npos; at = message.find(prefix)) {
        message.erase(at, prefix.size());
    }
    return message;
}

std::string Scenes::mistake(const std::string& text, const std::vector<Override>& overrides) const {
    return caught([&] { loaded(text, overrides); });
}

std::string Scenes::mistake_of_name(const std::string& name) const {
    return caught([&] { load(name); });
}

std::string mistake_of_text(const std::string& text, const std::string& file) {
    try {
        load_text(text, file);
    } catch (const SceneError& error) {
        return error.what();
    }
    return "nothing is wrong";
}

} // namespace isomotion::scene
