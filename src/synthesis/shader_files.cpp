#include "synthesis/shader_files.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "scene/data_folder.h"

namespace isomotion::synthesis {
namespace {

struct KernelFile {
    std::string name;
    std::set<std::string> kernels;
    std::vector<std::string> needs;
};

// In an order in which every file comes after what it needs; each file's first line says the same.
const std::vector<KernelFile>& kernel_table() {
    static const std::vector<KernelFile> table{
        {"bits.glsl", {}, {}},
        {"sqrt.glsl", {"sqrt"}, {"bits.glsl"}},
        {"divide.glsl", {"divide"}, {"bits.glsl"}},
        {"exp.glsl", {"exp", "sinh", "cosh", "tanh"}, {}},
        {"log.glsl", {"log"}, {"bits.glsl"}},
        {"pow.glsl", {"pow"}, {"bits.glsl", "exp.glsl", "log.glsl"}},
        {"trig.glsl", {"sin", "cos", "tan"}, {"bits.glsl", "divide.glsl"}},
        {"inverse_trig.glsl", {"asin", "acos", "atan"}, {}},
    };
    return table;
}

} // namespace

std::string read_shader(const std::string& name) {
    const auto path = scene::data_folder() / "shaders" / name;
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    if (!file) throw std::runtime_error(path.string() + ": this shader file cannot be read");
    return text.str();
}

std::vector<std::string> kernel_files(const std::set<std::string>& kernels) {
    const auto& table = kernel_table();
    std::set<std::string> wanted{"bits.glsl"};
    // Backwards: a file's needs stand before it.
    for (auto file = table.rbegin(); file != table.rend(); ++file) {
        const bool called = std::any_of(kernels.begin(), kernels.end(), [&](const auto& kernel) {
            return file->kernels.count(kernel) > 0;
        });
        if (called) wanted.insert(file->name);
        if (wanted.count(file->name)) wanted.insert(file->needs.begin(), file->needs.end());
    }
    std::vector<std::string> files;
    for (const KernelFile& file : table) {
        if (wanted.count(file.name)) files.push_back("math/" + file.name);
    }
    return files;
}

} // namespace isomotion::synthesis
