// `isomotion submit` on this machine: the bytes of one `render`, whatever happens to the workers.
#include "farm/local.h"

#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include <fmt/format.h>

#include "cli.h"
#include "files.h"
#include "processes.h"

namespace isomotion::farm {
namespace {

namespace fs = std::filesystem;
using cli::Words;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class Local : public cli::Cli {
protected:
    static Words command(const std::string& verb, const std::string& output, Words more = {}) {
        Words words{verb, "sphere.toml", "--frames", "1-18", "-o", output + "/a.####.png"};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }
    // Frames that take long enough for something to happen between them.
    static Words slow(Words more = {}) {
        more.insert(more.end(), {"--size", "160x160", "--set", "output.samples=30"});
        return more;
    }
    void expect_same_files(const std::string& one, const std::string& other) const {
        EXPECT_EQ(files_in(*this / one), files_in(*this / other));
        for (const std::string& name : files_in(*this / one)) {
            EXPECT_EQ(bytes(one + "/" + name), bytes(other + "/" + name)) << name;
        }
    }
    std::size_t frames_in(const std::string& output) const {
        std::size_t number = 0;
        for (const std::string& name : files_in(*this / output)) number += name[0] == 'a';
        return number;
    }
    bool works() const { return !renders_into(folder()).empty(); }
};

TEST_F(Local, ManyProcessesWriteTheBytesOfOne) {
    ASSERT_EQ(run(command("render", "one", {"--set", "r=0.7 + 0.1*t"})).code, 0);
    const cli::Ending ending = run(
        command("submit", "many", {"--set", "r=0.7 + 0.1*t", "--workers", "3", "--chunk", "4"}));
    EXPECT_EQ(ending.code, 0) << ending;
    EXPECT_THAT(ending.err, IsEmpty());
    EXPECT_THAT(ending.out, HasSubstr("18 frames in 6 chunks by 3 processes"));
    expect_same_files("one", "many");
}

TEST_F(Local, OptionsReachTheWorkersAsTheyWere) {
    const Words options{"--size",
                        "20x30",
                        "--method",
                        "amp-taylor",
                        "--step",
                        "0.02",
                        "--set",
                        "camera.position=[0, -3, 1]",
                        "--channels",
                        "z,proof",
                        "--certify",
                        "--set",
                        "r=-0.5",
                        "--set",
                        "camera.fov=30 + 2*sin(t)"};
    Words one{"render", "sphere.toml", "--frames", "7-3", "-o", "one/a.%02d.exr"};
    Words many{"submit", "sphere.toml", "--frames", "7-3", "-o", "many/a.%02d.exr", "--workers=2"};
    one.insert(one.end(), options.begin(), options.end());
    many.insert(many.end(), options.begin(), options.end());
    ASSERT_EQ(run(one).code, 0);
    const cli::Ending ending = run(many);
    EXPECT_EQ(ending.code, 0) << ending;
    EXPECT_EQ(files_in(*this / "one").size(), 5u);
    expect_same_files("one", "many");
}

TEST_F(Local, TheMovieIsJoinedWhenAllFramesAreThere) {
    // ffmpeg, which the package list has, may be missing where somebody installs by hand.
    if (cli::run({"/bin/sh", "-c", "command -v ffmpeg"}, {}).code != 0) {
        GTEST_SKIP() << "ffmpeg is not installed";
    }
    ASSERT_EQ(run(command("render", "one", {"--movie", "one/m.gif"})).code, 0);
    const cli::Ending ending =
        run(command("submit", "many", {"--movie", "many/m.gif", "--workers", "2"}));
    EXPECT_EQ(ending.code, 0) << ending;
    expect_same_files("one", "many");
}

TEST_F(Local, AWorkerKilledInTheMiddleIsReplaced) {
    ASSERT_EQ(run(command("render", "one", slow())).code, 0);
    cli::Circumstances circumstances = this->circumstances();
    pid_t killed = 0;
    circumstances.interrupt_when = [&](auto) {
        if (killed == 0 && frames_in("many") >= 2) {
            const auto workers = renders_into(folder());
            if (!workers.empty()) ::kill(killed = workers.front().id, SIGKILL);
        }
        return false;
    };
    const cli::Ending ending =
        run(command("submit", "many", slow({"--workers", "2"})), circumstances);
    EXPECT_EQ(ending.code, 0) << ending;
    EXPECT_NE(killed, 0);
    EXPECT_THAT(ending.err, HasSubstr("render ended with signal 9, try 1 of 3"));
    EXPECT_THAT(ending.out, HasSubstr("; 1 tried again\n"));
    expect_same_files("one", "many");
}

// Before the first frame is drawn the manifest knows of chunks that nobody has begun.
TEST_F(Local, VerifyMissesTheChunksThatAKilledRunNeverBegan) {
    cli::Circumstances circumstances = this->circumstances();
    circumstances.interrupt_signal = SIGKILL;
    circumstances.interrupt_when = [&](auto) { return frames_in("many") >= 2; };
    const cli::Ending ending =
        run(command("submit", "many", slow({"--workers", "1", "--chunk", "3"})), circumstances);
    EXPECT_EQ(ending.signal, SIGKILL) << ending;
    while (works()) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    const cli::Ending verified = run({"verify", "many"});
    EXPECT_EQ(verified.code, 1) << verified;
    EXPECT_THAT(verified.out, HasSubstr(", 18 frames, "));
    EXPECT_THAT(verified.out, HasSubstr("-18)\n")); // the end of what is missing
    EXPECT_EQ(run(command("render", "many", slow({"--resume"}))).code, 0);
    EXPECT_EQ(run({"verify", "many"}).code, 0);
}

// A folder in a frame's place can't be replaced by it.
TEST_F(Local, AChunkThatAlwaysFailsLeavesTheOthersWhole) {
    ASSERT_EQ(run(command("render", "one")).code, 0);
    fs::create_directories(*this / "many/a.0008.png/in the way");
    const Words many = command("submit", "many", {"--workers", "2", "--chunk", "3"});
    const cli::Ending ending = run(many);
    EXPECT_EQ(ending.code, 3) << ending;
    EXPECT_THAT(ending.err, HasSubstr("frames 7-9: render ended with exit status 3, try 2 of 3"));
    EXPECT_THAT(ending.err, HasSubstr("try 3 of 3: given up:\n"));
    EXPECT_THAT(ending.err, HasSubstr("a.0008.png")); // its last words
    EXPECT_THAT(ending.err, HasSubstr("\n1 of 6 chunks failed"));
    for (const int frame : {1, 6, 7, 10, 18}) {
        const std::string name = fmt::format("/a.{:04}.png", frame);
        EXPECT_EQ(bytes("one" + name), bytes("many" + name));
    }
    fs::remove_all(*this / "many/a.0008.png");
    EXPECT_EQ(run(many).code, 0);
    expect_same_files("one", "many");
}

class Ended : public Local, public testing::WithParamInterface<int> {};
INSTANTIATE_TEST_SUITE_P(Local, Ended, testing::Values(SIGINT, SIGTERM), [](const auto& signal) {
    return signal.param == SIGINT ? "int" : "term";
});

// By Control-C or by a batch system.
TEST_P(Ended, ASignalEndsTheWorkersToo) {
    ASSERT_EQ(run(command("render", "one", slow())).code, 0);
    cli::Circumstances circumstances = this->circumstances();
    circumstances.interrupt_when = [&](auto) { return frames_in("many") >= 2; };
    circumstances.interrupt_signal = GetParam();
    const Words many = command("submit", "many", slow({"--workers", "2"}));
    const cli::Ending ending = run(many, circumstances);
    EXPECT_EQ(ending.code, 130) << ending;
    EXPECT_THAT(ending.err, HasSubstr("--resume"));
    EXPECT_THAT(ending.err, Not(HasSubstr("asked to stop")));
    EXPECT_FALSE(works());
    EXPECT_LT(frames_in("many"), 18u);
    expect_only_whole_files();
    EXPECT_EQ(run(many).code, 0);
    expect_same_files("one", "many");
}

TEST_F(Local, WorkersEndWithTheirFarm) {
    cli::Circumstances circumstances = this->circumstances();
    circumstances.interrupt_when = [&](auto) { return frames_in("many") >= 2; };
    circumstances.interrupt_signal = SIGKILL;
    const cli::Ending ending =
        run(command("submit", "many", slow({"--workers", "2"})), circumstances);
    EXPECT_EQ(ending.signal, SIGKILL) << ending;
    for (int waited = 0; works() && waited < 600; ++waited)
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    EXPECT_FALSE(works());
    EXPECT_LT(frames_in("many"), 18u);
    expect_only_whole_files();
}

TEST_F(Local, AWrongCommandStartsNothing) {
    const std::pair<Words, std::string> wrong[] = {
        {{"--max-wrong", "100"}, "--max-wrong: each chunk would choose for itself"},
        {{"--chunk", "0"}, "--chunk"},
        {{"--workers", "-1"}, "--workers"},
        {{"--engine", "carrier pigeons"}, "--engine"},
        {{"--set", "rr=1"}, "parameters.rr: nothing uses this parameter"},
        {{"--frames", "0"}, "frames and steps count from 1"},
        {{"-o", "a.png"}, "put #### where their number goes"},
        {{"--movie", "a.avi"}, "--movie a.avi: a movie's name ends in .mp4"}};
    for (const auto& [more, message] : wrong) {
        SCOPED_TRACE(more[0]);
        Words words{"submit", "sphere.toml"};
        words.insert(words.end(), more.begin(), more.end());
        const cli::Ending ending = run(words);
        EXPECT_EQ(ending.code, 2) << ending;
        EXPECT_THAT(ending.err, HasSubstr(message));
        EXPECT_EQ(names(), std::set<std::string>{"sphere.toml"});
    }
}

// Programs in isomotion's place.
class LocalEnding : public Local {
protected:
    Ending ending_of(
        const std::string& script, int chunks, const Workforce& workforce,
        std::function<bool()> stop = [] { return false; }) {
        write("worker", "#!/bin/sh\n" + script);
        fs::permissions(*this / "worker", fs::perms::owner_all);
        Job job;
        job.program = *this / "worker";
        job.folder = folder();
        job.scene = *this / "sphere.toml";
        job.output = *this / "a.####.png";
        Watcher watcher;
        watcher.stop = std::move(stop);
        watcher.tell = [this](const std::string& text) { told_ += text + '\n'; };
        const std::vector<Chunk> all(std::size_t(chunks), Chunk{1, 2});
        return render_locally(job, all, workforce, watcher);
    }
    // A line for each process started.
    std::string log() const { return *this / "log"; }
    long started() const {
        const std::string text = bytes("log");
        return std::ranges::count(text, '\n');
    }
    std::string told_;
};

TEST_F(LocalEnding, EveryChunkIsDoneOnceIfAllGoesWell) {
    const Ending ending = ending_of("echo >>" + log(), 7, {.workers = 3});
    EXPECT_EQ(ending.code, 0);
    EXPECT_EQ(ending.tried_again, 0);
    EXPECT_EQ(started(), 7);
    EXPECT_THAT(told_, IsEmpty());
}

TEST_F(LocalEnding, TriesAreCounted) {
    const Ending ending =
        ending_of("echo >>" + log() + "; echo no >&2; exit 1", 2, {.workers = 2, .tries = 4});
    EXPECT_EQ(ending.code, 1);
    EXPECT_EQ(ending.failed, 2);
    EXPECT_EQ(ending.tried_again, 6);
    EXPECT_EQ(started(), 8);
    EXPECT_THAT(told_, HasSubstr("try 4 of 4: given up:\nno\n"));
}

TEST_F(LocalEnding, AWrongSceneIsNotTriedAgain) {
    const Ending ending = ending_of("echo >>" + log() + "; exit 2", 9, {.workers = 1});
    EXPECT_EQ(ending.code, 2);
    EXPECT_EQ(started(), 1);
}

TEST_F(LocalEnding, AnEndBySignalIsTheMachines) {
    const Ending ending = ending_of("kill -9 $$", 1, {.workers = 1, .tries = 2});
    EXPECT_EQ(ending.code, 3);
    EXPECT_EQ(ending.tried_again, 1);
}

TEST_F(LocalEnding, AWorkerThatIsAskedToStopAndEndsOtherwiseIsTold) {
    const auto told_of = [&](const std::string& at_the_end) {
        told_.clear();
        fs::remove(log());
        const Ending ending = ending_of("trap '" + at_the_end + "' TERM; echo >>" + log() +
                                            "; while :; do sleep 0.01; done",
                                        1, {.workers = 1}, [&] { return fs::exists(log()); });
        EXPECT_TRUE(ending.stopped);
        return told_;
    };
    EXPECT_EQ(told_of("exit 130"), "");
    EXPECT_EQ(told_of("exit 0"), "");
    EXPECT_EQ(told_of("echo why >&2; exit 3"),
              "frames 1-2: render ended with exit status 3, asked to stop:\nwhy\n");
    EXPECT_EQ(told_of("kill -9 $$"), "frames 1-2: render ended with signal 9, asked to stop\n");
    EXPECT_EQ(told_of("trap - TERM; kill $$"), ""); // as one that has not begun
    EXPECT_EQ(told_of("echo >" + (*this / "a.0001.png").string() + "; trap - TERM; kill $$"),
              "frames 1-2: render ended with signal 15, asked to stop\n");
}

TEST_F(LocalEnding, WarningsOfWorkersAreTold) {
    EXPECT_EQ(ending_of("echo careful >&2", 2, {.workers = 1}).code, 0);
    EXPECT_EQ(told_, "careful\ncareful\n");
}

} // namespace
} // namespace isomotion::farm
