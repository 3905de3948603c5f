#include "shader/shader_files.h"

#include <algorithm>

#include "base/file_text.h"
#include "scene/data_folder.h"

namespace isomotion::shader {
namespace {

struct KernelFile {
    std::string name;
    std::set<std::string> kernels;
    std::vector<std::string> needs;
};

using KernelTable = std::vector<KernelFile>;

// The kernels, in an order in which every file comes after what it needs; each file's first line
// says the same.
const KernelTable& kernel_table() {
    static const KernelTable table{
        {"math/bits.glsl", {}, {}},
        {"math/sqrt.glsl", {"sqrt"}, {"math/bits.glsl"}},
        {"math/divide.glsl", {"divide"}, {"math/bits.glsl"}},
        {"math/exp.glsl", {"exp", "sinh", "cosh", "tanh"}, {}},
        {"math/log.glsl", {"log"}, {"math/bits.glsl"}},
        {"math/inverse_hyperbolic.glsl", {"asinh", "acosh"}, {"math/bits.glsl", "math/log.glsl"}},
        {"math/erf.glsl", {"erf"}, {"math/bits.glsl", "math/exp.glsl"}},
        {"math/cbrt.glsl", {"cbrt"}, {}},
        {"math/pow.glsl", {"pow"}, {"math/bits.glsl", "math/exp.glsl", "math/log.glsl"}},
        {"math/trig.glsl", {"sin", "cos", "tan"}, {"math/bits.glsl", "math/divide.glsl"}},
        {"math/noise.glsl", {"noise"}, {}},
        {"math/inverse_trig.glsl", {"asin", "acos", "atan", "atan2", "angle"}, {"math/bits.glsl"}},
    };
    return table;
}

// The same of shaders/interval/, on top of the kernels for numbers.
const KernelTable& interval_table() {
    static const KernelTable table = [] {
        KernelTable all = kernel_table();
        for (KernelFile& file : all) file.kernels.clear();
        const std::string floats = "interval/float32.glsl", arithmetic = "interval/arithmetic.glsl";
        const std::string divide = "interval/divide.glsl", root = "interval/sqrt.glsl";
        const std::string exp = "interval/exp.glsl", trig = "interval/trig.glsl";
        const std::string inverse_trig = "interval/inverse_trig.glsl";
        const std::string inverse_hyperbolic = "interval/inverse_hyperbolic.glsl";
        const KernelTable own{
            {floats, {}, {"math/bits.glsl"}},
            {arithmetic, {}, {floats}},
            {"interval/exact.glsl", {"exact"}, {arithmetic}},
            {divide, {"divide"}, {arithmetic}},
            {root, {"sqrt"}, {arithmetic}},
            {exp, {"exp", "sinh", "cosh", "tanh"}, {arithmetic, "math/exp.glsl"}},
            {"interval/log.glsl", {"log"}, {arithmetic, "math/log.glsl"}},
            {inverse_hyperbolic, {"asinh", "acosh"}, {arithmetic, "math/inverse_hyperbolic.glsl"}},
            {"interval/erf.glsl", {"erf"}, {arithmetic, "math/erf.glsl"}},
            {"interval/cbrt.glsl", {"cbrt"}, {arithmetic, "math/cbrt.glsl"}},
            {"interval/noise.glsl", {"noise"}, {arithmetic, "math/noise.glsl"}},
            {"interval/pow.glsl", {"pow"}, {arithmetic, "math/pow.glsl"}},
            {trig, {"sin", "cos", "tan"}, {arithmetic, divide, "math/trig.glsl"}},
            {inverse_trig,
             {"asin", "acos", "atan", "atan2", "angle"},
             {arithmetic, divide, "math/inverse_trig.glsl"}},
            {"interval/chebyshev.glsl",
             {"chebyshev"},
             {arithmetic, exp, trig, divide, inverse_trig, inverse_hyperbolic}},
        };
        all.insert(all.end(), own.begin(), own.end());
        return all;
    }();
    return table;
}

// And on doubles. Files for floats come before these.
const KernelTable& double_interval_table() {
    static const KernelTable table = [] {
        const std::string doubles = "interval/float64.glsl";
        const std::string arithmetic = "interval/arithmetic.glsl";
        const std::string by_floats = "interval/by_floats/";
        const std::string around = by_floats + "floats_around.glsl";
        return KernelTable{
            {doubles, {}, {}},
            {arithmetic, {}, {doubles}},
            {"interval/exact.glsl", {"exact"}, {arithmetic}},
            {"interval/divide.glsl", {"divide"}, {arithmetic}},
            {"interval/sqrt.glsl", {"sqrt"}, {arithmetic}},
            {around, {}, {doubles}},
            {by_floats + "exp.glsl", {"exp", "sinh", "cosh", "tanh"}, {around}},
            {by_floats + "log.glsl", {"log"}, {around}},
            {by_floats + "inverse_hyperbolic.glsl", {"asinh", "acosh"}, {around}},
            {by_floats + "erf.glsl", {"erf"}, {around}},
            {by_floats + "cbrt.glsl", {"cbrt"}, {around}},
            {by_floats + "noise.glsl", {"noise"}, {around}},
            {by_floats + "pow.glsl", {"pow"}, {around}},
            {by_floats + "trig.glsl", {"sin", "cos", "tan"}, {around}},
            {by_floats + "inverse_trig.glsl", {"asin", "acos", "atan", "atan2", "angle"}, {around}},
            {by_floats + "chebyshev.glsl", {"chebyshev"}, {around}},
        };
    }();
    return table;
}

// The files with `kernels`, what they need, and `always`.
std::vector<std::string> files_of(const KernelTable& table, const std::set<std::string>& kernels,
                                  const std::string& always) {
    std::set<std::string> wanted{always};
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
        if (wanted.count(file.name)) files.push_back(file.name);
    }
    return files;
}

} // namespace

std::string read_shader(const std::string& name) {
    constexpr std::size_t most = 1 << 20;
    return base::file_text(scene::data_folder() / "shaders" / name, most);
}

std::vector<std::string> kernel_files(const std::set<std::string>& kernels) {
    return files_of(kernel_table(), kernels, "math/bits.glsl");
}

std::vector<std::string> interval_files(const std::set<std::string>& kernels) {
    return files_of(interval_table(), kernels, "interval/arithmetic.glsl");
}

DoubleIntervalFiles double_interval_files(const std::set<std::string>& kernels) {
    std::set<std::string> by_floats = kernels;
    for (const char* on_doubles : {"exact", "divide", "sqrt"}) by_floats.erase(on_doubles);
    return {by_floats.empty() ? kernel_files({}) : interval_files(by_floats),
            files_of(double_interval_table(), kernels, "interval/arithmetic.glsl")};
}

} // namespace isomotion::shader
