// A run that is ended at any moment leaves whole files, and --resume makes of them the sequence
// that an undisturbed run makes.
#include "cli.h"

#include <csignal>

#include <fmt/format.h>

namespace isomotion::cli {
namespace {

using std::chrono::milliseconds;
using testing::AnyOf;
using testing::ElementsAre;

constexpr int frames = 30;
constexpr const char* manifest = "a.exr.manifest";

class Interrupted : public Cli {
protected:
    static Words command(const std::string& output) {
        return {
            "render",     "sphere.toml", "--frames", fmt::format("1-{}", frames), "--size", "64x64",
            "--channels", "n,p,verdict", "-o",       output + "/a.####.exr"};
    }
    Words resumed(const std::string& output) const {
        Words words = command(output);
        words.push_back("--resume");
        return words;
    }
    std::set<std::string> present(const std::string& output) const {
        return std::filesystem::exists(*this / output) ? names(output) : std::set<std::string>{};
    }
    // Finished frames, or the hidden files of those being written.
    std::size_t count(const std::string& output, bool hidden) const {
        std::size_t number = 0;
        for (const std::string& name : present(output)) {
            if (name == manifest) continue;
            number += (name[0] == '.') == hidden;
        }
        return number;
    }
    Ending run_until(const std::string& output, int signal,
                     std::function<bool(milliseconds)> moment) const {
        Circumstances circumstances = this->circumstances();
        circumstances.interrupt_when = std::move(moment);
        circumstances.interrupt_signal = signal;
        return run(command(output), circumstances);
    }
    void expect_same_files(const std::string& first, const std::string& second) const {
        EXPECT_EQ(names(first), names(second));
        for (const std::string& name : names(first)) {
            if (name == manifest) continue; // has the times that drawing took
            EXPECT_EQ(bytes(first + "/" + name), bytes(second + "/" + name)) << name;
        }
    }
};

TEST_F(Interrupted, KilledAtAnyMomentAndResumed) {
    ASSERT_EQ(run(command("whole")).code, 0);
    ASSERT_EQ(names("whole").size(), std::size_t(frames + 1));

    const auto after = [](milliseconds time) {
        return [time](milliseconds running) { return running >= time; };
    };
    const auto files = [this](std::size_t number) {
        return [this, number](milliseconds) { return count("cut", false) >= number; };
    };
    const std::pair<std::string, std::function<bool(milliseconds)>> moments[] = {
        {"while it starts", after(milliseconds(20))},
        {"while shaders compile", after(milliseconds(200))},
        {"after the first file", files(1)},
        {"after many files", files(15)},
        {"while a file is written", [this](milliseconds) { return count("cut", true) > 0; }},
    };
    int kills = 0;
    for (const auto& [name, moment] : moments) {
        SCOPED_TRACE(name);
        std::filesystem::remove_all(*this / "cut");
        kills += run_until("cut", SIGKILL, moment).signal == SIGKILL;
        std::size_t whole = 0;
        for (const std::string& file : present("cut")) {
            if (file[0] == '.' || file == manifest) continue; // the first was being written
            EXPECT_EQ(bytes("cut/" + file), bytes("whole/" + file)) << file;
            ++whole;
        }
        EXPECT_LE(count("cut", true), 1u);
        const Ending rest = run(resumed("cut"));
        EXPECT_EQ(rest.code, 0) << rest;
        // The last of them may have lost its record.
        if (whole > 2) {
            EXPECT_THAT(rest.out,
                        AnyOf(HasSubstr(fmt::format("\n{} frames kept from", whole)),
                              HasSubstr(fmt::format("\n{} frames kept from", whole - 1))));
        }
        expect_same_files("cut", "whole"); // hidden files among them
    }
    // On a machine busy with other work a run may come to its end before it is seen.
    EXPECT_GE(kills, 2);
    RecordProperty("kills", kills);
}

TEST_F(Interrupted, StopsAtControlCWithWholeFiles) {
    const Ending ending =
        run_until("cut", SIGINT, [this](milliseconds) { return count("cut", false) >= 3; });
    EXPECT_EQ(ending.code, 130) << ending;
    EXPECT_THAT(ending.err, HasSubstr("--resume renders the rest"));
    expect_only_whole_files();
    const std::size_t whole = count("cut", false);
    EXPECT_LT(whole, std::size_t(frames));

    const Ending rest = run(resumed("cut"));
    EXPECT_EQ(rest.code, 0) << rest;
    EXPECT_THAT(rest.out, HasSubstr(fmt::format("\n{} frames kept from an earlier run", whole)));
    EXPECT_THAT(rest.out, HasSubstr(fmt::format("drawn {} in", frames - int(whole))));
    ASSERT_EQ(run(command("whole")).code, 0);
    expect_same_files("cut", "whole");
}

TEST_F(Interrupted, TerminationStopsAlike) {
    const Ending ending =
        run_until("cut", SIGTERM, [this](milliseconds) { return count("cut", false) >= 1; });
    EXPECT_EQ(ending.code, 130) << ending;
    expect_only_whole_files();
}

// As when a terminal is closed.
TEST_F(Interrupted, HangingUpStopsAlike) {
    const Ending ending =
        run_until("cut", SIGHUP, [this](milliseconds) { return count("cut", false) >= 1; });
    EXPECT_EQ(ending.code, 130) << ending;
    expect_only_whole_files();
}

// Before anything is begun, and in commands that have nothing to bring to an end.
TEST_F(Interrupted, EndsWithTheSameCodeOutsideOfWork) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        Circumstances circumstances = this->circumstances();
        circumstances.interrupt_signal = signal;
        circumstances.interrupt_when = [](milliseconds running) {
            return running >= milliseconds(300);
        };
        const Ending ending =
            run({"accuracy", "sphere.toml", "--size", "1024x1024", "--repeat", "1000", "--quiet"},
                circumstances);
        EXPECT_EQ(ending.code, 130) << ending;
        EXPECT_THAT(ending.err, HasSubstr("stopped"));
    }
}

// While events are looked for, or while their pictures are drawn.
TEST_F(Interrupted, PlotsEndWithTheSameCode) {
    for (const int after : {400, 3000}) {
        Circumstances circumstances = this->circumstances();
        circumstances.interrupt_signal = SIGINT;
        circumstances.interrupt_when = [&](milliseconds running) {
            return running >= milliseconds(after);
        };
        const Ending ending = run(
            {"topology", "blobby75", "--frames", "1-600", "--plot", "cut/a.svg"}, circumstances);
        EXPECT_EQ(ending.code, 130) << ending;
        EXPECT_THAT(ending.err, HasSubstr("interrupted"));
        for (const std::string& file : present("cut")) EXPECT_THAT(file, HasSubstr(".svg"));
    }
}

// A frame of this takes many minutes: it is given up between two of its draws.
TEST_F(Interrupted, StopsInTheMiddleOfAFrame) {
    write("heavy.toml",
          "[surface]\nformula = \"sum(a, sum(b, sqrt(abs(x*u + y*v + z*u*v)))) - 1\"\n"
          "bounds = { sphere = 1.5 }\n"
          "[arrays.a]\ncount = 200\nu = \"sin(i)\"\n"
          "[arrays.b]\ncount = 200\nv = \"cos(i)\"\n"
          "[isolation]\nmethod = \"amp-sign\"\nstep = 1e-3\n");
    Circumstances circumstances = this->circumstances();
    circumstances.interrupt_signal = SIGINT;
    // Once the frame is begun: a slow start would leave the signal to the system.
    circumstances.interrupt_when = [this](milliseconds running) {
        return running >= milliseconds(1500) &&
               std::filesystem::exists(*this / "cut" / "a.manifest" / "writers");
    };
    const Ending ending = run(
        {"render", "heavy.toml", "--frames", "1", "--size", "2048x2048", "-o", "cut/a.####.png"},
        circumstances);
    EXPECT_EQ(ending.code, 130) << ending;
    EXPECT_THAT(ending.err, HasSubstr("stopped"));
    EXPECT_THAT(present("cut"), ElementsAre("a.manifest"));
}

} // namespace
} // namespace isomotion::cli
