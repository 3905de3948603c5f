// shaders/math/: the table of kernels in C++, the first line of each file and the text below agree.
#include <map>
#include <regex>

#include <gmock/gmock.h>

#include "scenes.h"
#include "shader/shader_files.h"

namespace isomotion::shader {
namespace {

using Names = std::set<std::string>;

struct KernelFile {
    Names kernels; // that the first line names: "exp" for im_exp
    Names needs;   // files, as the first line says
    Names defines; // im_ functions and IM_ constants
    Names uses;
};

Names matches(const std::string& text, const char* pattern) {
    const std::regex regex(pattern);
    Names found;
    for (auto it = std::sregex_iterator(text.begin(), text.end(), regex);
         it != std::sregex_iterator(); ++it) {
        found.insert((*it)[1]);
    }
    return found;
}

std::map<std::string, KernelFile> read_kernel_files() {
    std::map<std::string, KernelFile> files;
    for (const auto& name : shader_files()) {
        if (!name.starts_with("math/")) continue;
        const std::string text = read_shader(name);
        const std::string first = text.substr(0, text.find('\n'));
        const std::size_t needs = first.find("Needs");
        EXPECT_NE(needs, first.npos) << name << ": the first line says what the file needs";
        if (needs == first.npos) continue;
        KernelFile& file = files[name.substr(5)];
        file.kernels = matches(first.substr(0, needs), "im_([a-z0-9]+)");
        file.needs = matches(first.substr(needs), "([a-z_]+\\.glsl)");
        EXPECT_EQ(file.needs.empty(), first.find("no other file") != first.npos) << name;
        const std::string code = std::regex_replace(text, std::regex("//[^\n]*"), "");
        file.defines = matches(code, "\n[a-z0-9]+ (im_[a-z0-9_]+)\\(");
        file.defines.merge(matches(code, "#define (IM_[A-Z]+)"));
        file.uses = matches(code, "\\b(im_[a-z0-9_]+|IM_[A-Z]+)\\b");
    }
    return files;
}

Names closure(const std::map<std::string, KernelFile>& files, const std::string& name) {
    Names all{name};
    for (const auto& need : files.at(name).needs) all.merge(closure(files, need));
    return all;
}

class KernelFiles : public testing::Test {
protected:
    static void SetUpTestSuite() { use_shaders_of_source_tree(); }
    const std::map<std::string, KernelFile> files = read_kernel_files();
};

TEST_F(KernelFiles, AKernelComesWithWhatItsFileNeeds) {
    Names kernels;
    for (const auto& [name, file] : files) {
        for (const auto& kernel : file.kernels) {
            EXPECT_TRUE(file.defines.contains("im_" + kernel)) << name << ": " << kernel;
            kernels.insert(kernel);
            Names expected;
            for (const auto& need : closure(files, name)) expected.insert("math/" + need);
            expected.insert("math/bits.glsl");
            const auto given = kernel_files({kernel});
            EXPECT_EQ(Names(given.begin(), given.end()), expected) << kernel;
            EXPECT_EQ(given.size(), expected.size()) << kernel;
        }
    }
    // All that the writer of GLSL calls is there.
    const auto every = formula::make_field(
        "sqrt(x)/y + exp(x)^y + log(x) + sin(x) + cos(x) + tan(x) + sinh(x) + cosh(x) + tanh(x) + "
        "asin(x) + acos(x) + atan(x) + atan2(y, x) + cos(atan2(y, x)) + asinh(x) + acosh(x) + "
        "erf(x) + "
        "cbrt(x) + noise(x, y, z)",
        {});
    EXPECT_EQ(formula::kernels_used(every.value), kernels);
}

TEST_F(KernelFiles, ComeAfterWhatTheyNeed) {
    Names kernels;
    for (const auto& [name, file] : files) kernels.insert(file.kernels.begin(), file.kernels.end());
    Names before;
    for (const auto& path : kernel_files(kernels)) {
        const std::string name = path.substr(5);
        for (const auto& need : files.at(name).needs) {
            EXPECT_TRUE(before.contains(need)) << name << " stands before " << need;
        }
        before.insert(name);
    }
    EXPECT_EQ(before.size(), files.size()) << "every file belongs to some kernel";
}

TEST_F(KernelFiles, UseOnlyWhatTheyNeedOrDefine) {
    for (const auto& [name, file] : files) {
        Names known = matches(read_shader("prelude.glsl"), "#define (IM_[A-Z]+)");
        for (const auto& need : closure(files, name)) {
            known.insert(files.at(need).defines.begin(), files.at(need).defines.end());
        }
        for (const auto& used : file.uses) {
            EXPECT_TRUE(known.contains(used)) << name << " uses " << used;
        }
        // Nor do they say that they need what they don't.
        for (const auto& need : file.needs) {
            Names theirs;
            for (const auto& each : closure(files, need)) {
                theirs.insert(files.at(each).defines.begin(), files.at(each).defines.end());
            }
            EXPECT_TRUE(std::any_of(file.uses.begin(), file.uses.end(),
                                    [&](const auto& used) { return theirs.contains(used); }))
                << name << " needs nothing of " << need;
        }
    }
}

TEST_F(KernelFiles, WithoutKernelsThereAreOnlyBits) {
    EXPECT_THAT(kernel_files({}), testing::ElementsAre("math/bits.glsl"));
}

} // namespace
} // namespace isomotion::shader
