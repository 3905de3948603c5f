// find_package(isomotion): a program of somebody else finds, links and runs what is installed.
#include "installation.h"

#include <fstream>

namespace isomotion::package {
namespace {

namespace fs = std::filesystem;
using testing::ContainsRegex;
using testing::HasSubstr;

class FindPackage : public Installation {
protected:
    cli::Ending configure(const fs::path& source, const fs::path& build) const {
        return cli::run(
            {CMAKE_PROGRAM, "-S", source, "-B", build, "-DCMAKE_PREFIX_PATH=" + prefix().string()},
            {});
    }
    // A project that asks for the package so.
    cli::Ending asked(const std::string& request) const {
        const image::TemporaryFolder project;
        std::ofstream(project / "CMakeLists.txt")
            << "cmake_minimum_required(VERSION 3.25)\nproject(asking LANGUAGES CXX)\n"
            << "find_package(isomotion " << request << ")\n";
        return configure(project.path(), project / "build");
    }
};

TEST_F(FindPackage, AProgramDrawsProvesTellsAndExports) {
    const fs::path example = fs::path(ISOMOTION_SOURCE_DIR) / "tests/package/example";
    const image::TemporaryFolder build;
    const cli::Ending configured = configure(example, build.path());
    ASSERT_EQ(configured.code, 0) << configured;
    done({CMAKE_PROGRAM, "--build", build.path()});

    // Neither is installed beside isomotion, and nothing tells them where its shaders are.
    const fs::path scene = example / "meeting.toml";
    const cli::Circumstances there{.folder = build.path(),
                                   .environment = {{"ISOMOTION_DATA", std::nullopt}}};
    const cli::Ending ending = done({build / "meeting", scene}, there);
    EXPECT_THAT(ending.out, ContainsRegex("meeting.png: [1-9][0-9]+ of 9216 rays hit"));
    EXPECT_TRUE(fs::exists(build / "meeting.png"));
    EXPECT_THAT(ending.out, HasSubstr("the middle ray's first root is in [-0.43"));
    // Where 2 exp(-4 d^2) = 0.5: d = sqrt(ln 4)/2 = 0.58870501, t = (1 - d)/0.3 = 1.37098...
    EXPECT_THAT(ending.out, HasSubstr("merge at t in [1.3709832"));
    EXPECT_THAT(ending.out, HasSubstr("], proved\nnothing else happens\n"));

    const std::string files = "out/meeting.0001.png\nout/meeting.0031.png\nout/meeting.0061.png\n";
    EXPECT_EQ(done({build / "exporting", scene}, there).out,
              files + "run 1: 3 drawn\n" + files + "run 2: 0 drawn\nwhole\n");
    done({prefix() / "bin/isomotion", "verify", build / "out"});
}

TEST_F(FindPackage, InstallsOneHeaderAndItsPartsThatStandAlone) {
    std::vector<fs::path> headers;
    for (const auto& entry : fs::recursive_directory_iterator(prefix() / "include")) {
        if (entry.is_regular_file()) headers.push_back(entry.path());
    }
    const fs::path folder = prefix() / "include/isomotion";
    std::vector<fs::path> parts{folder / "isomotion.h"};
    for (const char* part :
         {"accuracy", "drawing", "error", "page", "scene", "sequence", "topology"})
        parts.push_back(folder / (std::string(part) + ".h"));
    EXPECT_THAT(headers, testing::UnorderedElementsAreArray(parts));
    for (const fs::path& header : headers) {
        std::ifstream text(header);
        for (std::string line; std::getline(text, line);) {
            if (!line.starts_with("#include")) continue; // of the standard, or one of the parts
            EXPECT_THAT(
                line, testing::MatchesRegex("#include <[a-z_]+>|#include <isomotion/[a-z]+\\.h>"));
        }
    }
}

// As a module of Python or a plug-in does.
TEST_F(FindPackage, ASharedLibraryMayHoldIt) {
    const image::TemporaryFolder project;
    std::ofstream(project / "CMakeLists.txt")
        << "cmake_minimum_required(VERSION 3.25)\nproject(shared LANGUAGES CXX)\n"
        << "find_package(isomotion REQUIRED)\n"
        << "add_library(shared SHARED shared.cpp)\n"
        << "target_link_libraries(shared PRIVATE isomotion::isomotion)\n"
        << "target_link_options(shared PRIVATE LINKER:--no-undefined)\n";
    std::ofstream(project / "shared.cpp")
        << "#include <isomotion/isomotion.h>\n"
        << "std::string summary() {\n"
        << "    const auto scene = isomotion::Scene::load(\"torus\");\n"
        << "    isomotion::Device device;\n"
        << "    isomotion::Renderer(device, scene).draw(1).write(\"torus.png\");\n"
        << "    return isomotion::topology_of(scene).summary() + isomotion::page_of(scene);\n"
        << "}\n";
    const cli::Ending configured = configure(project.path(), project / "build");
    ASSERT_EQ(configured.code, 0) << configured;
    done({CMAKE_PROGRAM, "--build", project / "build"});
}

// Builds of the source tree as a part of a project take longer: tests/package/CMakeLists.txt.
TEST_F(FindPackage, OrFetchContentHasMadeItAvailable) {
    const image::TemporaryFolder project;
    std::ofstream(project / "CMakeLists.txt")
        << "cmake_minimum_required(VERSION 3.25)\nproject(fetching LANGUAGES C CXX)\n"
        << "include(FetchContent)\n"
        << "FetchContent_Declare(isomotion SOURCE_DIR " ISOMOTION_SOURCE_DIR ")\n"
        << "FetchContent_MakeAvailable(isomotion)\n"
        << "get_target_property(data isomotion::isomotion INTERFACE_COMPILE_DEFINITIONS)\n"
        << "message(STATUS \"data: ${data}\")\n";
    const cli::Ending ending = done({CMAKE_PROGRAM, "-S", project.path(), "-B", project / "build"});
    EXPECT_THAT(ending.out, HasSubstr(ISOMOTION_SOURCE_DIR));
}

TEST_F(FindPackage, MistakesAreTold) {
    EXPECT_THAT(asked("REQUIRED COMPONENTS mesh").err, HasSubstr("no components"));
    EXPECT_THAT(asked("99 REQUIRED").err, HasSubstr("\"99\""));
}

} // namespace
} // namespace isomotion::package
