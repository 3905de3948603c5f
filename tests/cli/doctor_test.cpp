// `isomotion doctor`: what a machine has, whatever its drivers do.
#include "cli.h"

#include <cmath>
#include <sys/mount.h>

#include <nlohmann/json.hpp>

namespace isomotion::cli {
namespace {

using nlohmann::json;

class Doctor : public Cli {
protected:
    Ending examine(const std::map<std::string, std::optional<std::string>>& environment,
                   Words options = {}) const {
        Circumstances circumstances = this->circumstances();
        for (const auto& [name, value] : environment) circumstances.environment[name] = value;
        options.insert(options.begin(), "doctor");
        const Ending ending = run(options, circumstances);
        EXPECT_EQ(names(), std::set<std::string>{"sphere.toml"});
        return ending;
    }
    static json back_end(const json& report, const std::string& name) {
        for (const json& found : report.at("backends")) {
            if (found.at("name") == name) return found;
        }
        ADD_FAILURE() << "no " << name << " in " << report;
        return {};
    }
    static json report_of(const Ending& ending) {
        const json report = json::parse(ending.out, nullptr, false);
        EXPECT_TRUE(report.is_object()) << ending;
        return report;
    }
};

TEST_F(Doctor, ACrashOfADriverIsALine) {
    const Ending ending = examine({{"ISOMOTION_OSMESA", CRASHING_DRIVER}});
    EXPECT_THAT(ending.out, HasSubstr("\nosmesa   does not work: the driver ended its process: "
                                      "signal 11 (Segmentation fault)"));
    // What comes after it is told all the same.
    EXPECT_THAT(ending.out, HasSubstr("\nglfw     "));
}

TEST_F(Doctor, AHangOfADriverEnds) {
    const Ending ending = examine({{"ISOMOTION_OSMESA", HANGING_DRIVER},
                                   {"__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent/driver"},
                                   {"DISPLAY", std::nullopt}},
                                  {"--timeout", "2"});
    EXPECT_EQ(ending.code, 3) << ending;
    EXPECT_THAT(ending.out, HasSubstr("\nosmesa   does not work: no answer within 2 s"));
}

// The facts that the shaders are written for. They hold on every back end that works.
TEST_F(Doctor, MeasuresArithmetic) {
    const Ending ending = examine({}, {"--json"});
    if (ending.code == 3) GTEST_SKIP() << "no back end works here: " << ending.out;
    const json report = report_of(ending);
    int measured = 0;
    for (const json& found : report.at("backends")) {
        if (!found.at("works")) continue;
        SCOPED_TRACE(found.at("name"));
        EXPECT_FALSE(found.at("renderer").get<std::string>().empty());
        EXPECT_GE(found.at("limits").at("texture_size"), 16384);
        // The speed is measured of hardware alone: software renderers take too long for it.
        const double speed = found.at("operations_a_second").at("fragment").get<double>();
        EXPECT_EQ(speed == 0, found.at("software").get<bool>()) << found;
        const json& arithmetic = found.at("arithmetic");
        ASSERT_FALSE(arithmetic.contains("reason")) << arithmetic;
        for (const json& behaviour : arithmetic.at("behaviours")) {
            const std::string what = behaviour.at("what");
            if (what.starts_with("precise") || what == "NaN < 1" || what == "NaN >= 1") {
                EXPECT_TRUE(behaviour.at("ieee")) << behaviour;
            }
        }
        ASSERT_GE(arithmetic.at("errors").size(), 10u);
        for (const json& error : arithmetic.at("errors")) {
            // The kernels keep within a few ulp whatever the driver's functions do; of those only
            // that something was measured is known.
            EXPECT_LT(error.at("own"), 4) << error;
            EXPECT_GT(error.at("own"), 0) << error;
            EXPECT_NE(error.at("driver"), 0) << error;
        }
        ++measured;
    }
    EXPECT_GT(measured, 0);
}

TEST_F(Doctor, EndsWithWhatToExpectOfTheMachine) {
    const Ending ending = examine({{"DISPLAY", std::nullopt}});
    if (ending.code == 3) GTEST_SKIP() << "no back end works here: " << ending.out;
    const std::string last = ending.out.substr(ending.out.rfind('\n', ending.out.size() - 2) + 1);
    EXPECT_THAT(last,
                testing::MatchesRegex("expect   .+: blobby75 renders [0-9.]+ frames a second at "
                                      "256x256, and plays at about [0-9]+ pixels( or more)?\n"));
    // One back end works: no drivers are advised for the others.
    EXPECT_THAT(ending.out, Not(HasSubstr("install an OpenGL driver")));
}

TEST_F(Doctor, TellsWhatIsNotThere) {
    const image::TemporaryFolder empty;
    const json report =
        report_of(examine({{"PATH", empty.path().string()}}, {"--json", "--timeout", "60"}));
    EXPECT_THAT(report.at("ffmpeg").at("reason"), HasSubstr("not found on PATH"));
    EXPECT_THAT(report.at("sbatch").at("reason"), HasSubstr("not found on PATH"));
    EXPECT_GT(report.at("processors"), 0);
    EXPECT_GT(report.at("disk").at("free_bytes"), 0);
    EXPECT_TRUE(report.at("disk").at("writable"));
    EXPECT_EQ(report.at("files").at("folder"), ISOMOTION_SOURCE_DIR);
}

TEST_F(Doctor, MissingFilesAreALine) {
    const Ending ending = examine({{"ISOMOTION_DATA", folder().string()}});
    EXPECT_THAT(ending.out, StartsWith("files    ISOMOTION_DATA="));
    EXPECT_THAT(ending.out, HasSubstr("\negl      "));
    if (ending.code == 0) {
        EXPECT_THAT(ending.out, HasSubstr("arithmetic is not known: "));
    }
}

TEST_F(Doctor, AFolderThatTakesNoFileIsALine) {
    const image::TemporaryFolder place;
    const image::Disk disk(place, MS_RDONLY, "");
    if (!disk) GTEST_SKIP() << "mounting a file system is not allowed here";
    Circumstances circumstances = this->circumstances();
    circumstances.folder = place.path();
    const json report = report_of(run({"doctor", "--json"}, circumstances));
    EXPECT_FALSE(report.at("disk").at("writable"));
    EXPECT_THAT(report.at("disk").at("reason"), HasSubstr("Read-only"));
}

} // namespace
} // namespace isomotion::cli
