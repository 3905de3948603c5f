// Each system call that the program makes fails once: after it there is a clear error and the right
// exit code, all files are whole, and --resume makes of them what an undisturbed run makes.
#include "export.h"

#include <cerrno>
#include <cstring>
#include <fstream>

namespace isomotion::faults {
namespace {

struct Fault {
    const char* call;
    int code;
};

constexpr Fault faults[] = {
    {"open", EMFILE},   {"write", ENOSPC},  {"write", EIO},         {"fsync", EIO},
    {"rename", EACCES}, {"ftruncate", EIO}, {"flock", ENOLCK},      {"fstat", EIO},
    {"unlink", EACCES}, {"spawn", EAGAIN},  {"socketpair", EMFILE}, {"memfd", EMFILE},
    {"read", EIO},      {"pread", EIO},     {"stat", EACCES},       {"thread", EAGAIN},
    {"mmap", ENOMEM},
};

class FailingCalls : public Export, public testing::WithParamInterface<Fault> {
protected:
    Words short_command(const std::string& output, Words more = {}) {
        // Memory has pages of its own where a picture is not the smallest.
        const bool is_of_memory = GetParam().code == ENOMEM;
        more.insert(more.end(), {"--frames", "1-4", "--size", is_of_memory ? "256x256" : "8x8",
                                 "--audit", "off"});
        return command(output, more);
    }
    Ending run_preloaded(const Words& words, const std::string& fault,
                         const std::string& counted = {}) const {
        Circumstances circumstances = this->circumstances();
        circumstances.environment["LD_PRELOAD"] = FAILING_CALLS_LIBRARY;
        circumstances.environment["FAILING_CALL"] = fault;
        if (!counted.empty()) circumstances.environment["COUNT_CALLS"] = counted;
        return run(words, circumstances);
    }
    // How often the program makes the call that is to fail.
    int calls_of(const Words& words) const {
        const std::string file = (*this / "counted").string();
        EXPECT_EQ(run_preloaded(words, "", file).code, 0);
        std::ifstream counted(file);
        std::string name;
        for (int count = 0; counted >> name >> count;) {
            if (name == GetParam().call) return count;
        }
        ADD_FAILURE() << "no call was counted in " << file;
        return 0;
    }
    static Words as_submitted(Words words) {
        words[0] = "submit";
        words.insert(words.end(), {"--workers", "2"});
        return words;
    }
    std::string fault_at(int count) const {
        return fmt::format("{}:{}:{}", GetParam().call, count, GetParam().code);
    }
    // Exit code 0 is right where nothing of what was asked for depends on the call.
    void expect_an_orderly_end(const Ending& ending) {
        EXPECT_EQ(ending.signal, 0) << ending;
        // 2 where the scene or the program's own files cannot be read.
        EXPECT_THAT(ending.code, testing::AnyOf(0, 2, 3)) << ending;
        const int reason = GetParam().code;
        if (ending.code != 0) {
            EXPECT_THAT(ending.err,
                        HasSubstr(reason == ENOMEM ? "out of memory" : std::strerror(reason)))
                << ending;
        }
    }
    void expect_all_by_resume(const std::string& output) {
        const Ending rest = run(short_command(output, {"--resume"}));
        EXPECT_EQ(rest.code, 0) << rest;
        for (const std::string& name : names("whole")) {
            if (name.ends_with(".png")) {
                EXPECT_EQ(bytes(output + "/" + name), bytes("whole/" + name)) << name;
            }
        }
        expect_verified(output);
    }
    // Most calls of a run are alike: the first, and every so many after them.
    static int next(int count) { return count < 6 ? count + 1 : count + 1 + count / 4; }
};

// A call that is counted nowhere would be tried nowhere, in silence.
TEST_P(FailingCalls, AreMadeBySomeCommand) {
    ASSERT_EQ(run(short_command("whole")).code, 0);
    EXPECT_GT(calls_of(short_command("counted_frames")) +
                  calls_of(short_command("whole", {"--resume"})) +
                  calls_of({"verify", "whole", "--pixels"}) +
                  calls_of(as_submitted(short_command("counted_chunks"))),
              0);
}

TEST_P(FailingCalls, OfARender) {
    ASSERT_EQ(run(short_command("whole")).code, 0);
    const int calls = calls_of(short_command("counted_frames"));
    int tried = 0, told = 0;
    for (int count = 1; count <= calls; count = next(count), ++tried) {
        SCOPED_TRACE(fault_at(count));
        fs::remove_all(*this / "cut");
        const Ending ending = run_preloaded(short_command("cut"), fault_at(count));
        expect_an_orderly_end(ending);
        told += ending.code != 0;
        if (ending.code == 0) expect_verified("cut");
        expect_all_by_resume("cut");
    }
    fmt::print("{} fails: {} of {} calls tried, {} told\n", GetParam().call, tried, calls, told);
    RecordProperty("tried", tried);
}

TEST_P(FailingCalls, OfAResume) {
    ASSERT_EQ(run(short_command("whole")).code, 0);
    const auto cut = [this] {
        fs::remove_all(*this / "cut");
        fs::copy(*this / "whole", *this / "cut", fs::copy_options::recursive);
        fs::remove(*this / "cut/a.0002.png");
        fs::remove(*this / "cut/a.manifest/0003.json");
    };
    cut();
    const int calls = calls_of(short_command("cut", {"--resume"}));
    int tried = 0;
    for (int count = 1; count <= calls; count = next(count), ++tried) {
        SCOPED_TRACE(fault_at(count));
        cut();
        expect_an_orderly_end(run_preloaded(short_command("cut", {"--resume"}), fault_at(count)));
        expect_all_by_resume("cut");
    }
    RecordProperty("tried", tried);
}

TEST_P(FailingCalls, OfAVerify) {
    ASSERT_EQ(run(short_command("whole")).code, 0);
    const Words verify{"verify", "whole", "--pixels"};
    const int calls = calls_of(verify);
    int tried = 0;
    for (int count = 1; count <= calls; count = next(count), ++tried) {
        SCOPED_TRACE(fault_at(count));
        const Ending ending = run_preloaded(verify, fault_at(count));
        EXPECT_EQ(ending.signal, 0) << ending;
        // What cannot be read is not called whole.
        EXPECT_THAT(ending.code, testing::AnyOf(0, 1, 2, 3)) << ending;
        if (ending.code == 0) {
            EXPECT_THAT(ending.out, HasSubstr("\n  whole\n"));
        } else {
            EXPECT_THAT(ending.out + ending.err, Not(IsEmpty()));
        }
    }
    RecordProperty("tried", tried);
}

TEST_P(FailingCalls, OfASubmit) {
    ASSERT_EQ(run(short_command("whole")).code, 0);
    const auto submit = [this](const std::string& output) {
        return as_submitted(short_command(output));
    };
    const int calls = calls_of(submit("counted_frames"));
    int tried = 0;
    for (int count = 1; count <= calls; count = next(count), ++tried) {
        SCOPED_TRACE(fault_at(count));
        fs::remove_all(*this / "cut");
        // Its workers have the fault too, and are tried again.
        const Ending ending = run_preloaded(submit("cut"), fault_at(count));
        expect_an_orderly_end(ending);
        if (ending.code == 0) expect_verified("cut");
        expect_all_by_resume("cut");
    }
    RecordProperty("tried", tried);
}

class FailingMovies : public FailingCalls {};

TEST_P(FailingMovies, AreToldAndMadeByResume) {
    const Words movie = short_command("cut", {"--movie", "cut.mp4"});
    const int calls = calls_of(movie);
    EXPECT_GT(calls, 0);
    for (int count = 1; count <= calls; count = next(count)) {
        SCOPED_TRACE(fault_at(count));
        fs::remove_all(*this / "cut");
        fs::remove(*this / "cut.mp4");
        const Ending ending = run_preloaded(movie, fault_at(count));
        EXPECT_EQ(ending.code, 3) << ending;
        EXPECT_THAT(ending.err, Not(IsEmpty()));
        EXPECT_FALSE(fs::exists(*this / "cut.mp4"));
        expect_verified("cut");
        const Ending rest = run(short_command("cut", {"--movie", "cut.mp4", "--resume"}));
        EXPECT_EQ(rest.code, 0) << rest;
        EXPECT_TRUE(fs::exists(*this / "cut.mp4"));
    }
    RecordProperty("tried", calls);
}

std::string name_of(const testing::TestParamInfo<Fault>& tested) {
    return fmt::format("{}_{}", tested.param.call, strerrorname_np(tested.param.code));
}

INSTANTIATE_TEST_SUITE_P(Once, FailingCalls, testing::ValuesIn(faults), name_of);
INSTANTIATE_TEST_SUITE_P(Once, FailingMovies,
                         testing::Values(Fault{"spawn", EAGAIN}, Fault{"socketpair", EMFILE},
                                         Fault{"send", EPIPE}),
                         name_of);

} // namespace
} // namespace isomotion::faults
