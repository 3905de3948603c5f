// `isomotion submit --engine slurm` against a real Slurm: whatever fails in the middle, in the end
// there are the bytes of one undisturbed `render`.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

#include <fmt/format.h>
#include <sys/stat.h>

#include "cli.h"
#include "cluster.h"
#include "files.h"

namespace isomotion::farm {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using cli::Words;
using testing::HasSubstr;
using testing::IsEmpty;

class RealSlurm : public cli::Cli {
protected:
    void SetUp() override {
        // The package list has them; a machine set up by hand may lack them.
        if (const auto program = Cluster::missing()) {
            GTEST_SKIP() << *program << " is not installed";
        }
        cluster_.emplace(cluster_folder_.path());
    }

    static Words command(const std::string& verb, const std::string& output) {
        return {verb,    "sphere.toml",          "--frames", "1-16",
                "-o",    output + "/a.####.png", "--size",   "256x256",
                "--set", "output.samples=30"};
    }
    cli::Ending submit(Words more = {}) const {
        Words words = command("submit", "farm");
        words.insert(words.end(), {"--engine", "slurm", "--chunk", "4"});
        words.insert(words.end(), more.begin(), more.end());
        cli::Circumstances at = circumstances();
        at.environment["SLURM_CONF"] = cluster_->configuration();
        return run(words, at);
    }
    // True once it is so; false if it isn't in a time in which it should be.
    template<class Condition> static bool becomes(const Condition& condition) {
        for (const auto end = std::chrono::steady_clock::now() + 120s;
             std::chrono::steady_clock::now() < end; std::this_thread::sleep_for(5ms)) {
            if (condition()) return true;
        }
        return false;
    }
    bool all_jobs_end() const {
        return becomes([&] {
            std::this_thread::sleep_for(50ms);
            return cluster_->queue().empty();
        });
    }
    // Whole and recorded: only then it is kept.
    bool has_frame(int frame) const {
        return fs::exists(*this / fmt::format("farm/a.manifest/{:04}.json", frame));
    }
    void expect_the_bytes_of_one() const {
        render([] {
            Words words = command("render", "one");
            words.erase(words.begin());
            return words;
        }());
        for (const std::string& name : files_in(*this / "one")) {
            EXPECT_EQ(bytes("one/" + name), bytes("farm/" + name)) << name;
        }
    }
    std::string log(const std::string& task) const {
        return bytes("farm/a.slurm/" + task + ".log");
    }
    image::TemporaryFolder cluster_folder_;
    std::optional<Cluster> cluster_; // gone before its folder
};

TEST_F(RealSlurm, ARenderKilledInTheMiddleIsTriedAgain) {
    const cli::Ending ending = submit({"--movie", "farm/m.gif"});
    ASSERT_EQ(ending.code, 0) << ending;
    EXPECT_THAT(ending.out, HasSubstr("16 frames in 4 chunks"));
    ASSERT_TRUE(becomes([&] { return has_frame(1); })) << cluster_->queue();
    bool killed = false;
    for (const Process& render : renders_into(folder())) {
        if (render.environment.find("SLURM_ARRAY_TASK_ID=1") == std::string::npos) continue;
        killed = ::kill(render.id, SIGKILL) == 0;
    }
    EXPECT_TRUE(killed);
    ASSERT_TRUE(all_jobs_end()) << cluster_->queue();
    EXPECT_THAT(log("1"), HasSubstr("frames 1-4: exit status 137 on "));
    EXPECT_THAT(log("1"), HasSubstr("kept from an earlier run"));
    EXPECT_THAT(log("join"), HasSubstr("16 frames kept from an earlier run"));
    EXPECT_THAT(log("join"), HasSubstr("movie: "));
    expect_the_bytes_of_one();
}

TEST_F(RealSlurm, WhatALostMachineWasDoingIsDoneAgain) {
    const cli::Ending ending = submit();
    ASSERT_EQ(ending.code, 0) << ending;
    ASSERT_TRUE(becomes([&] { return has_frame(1) && !cluster_->jobs_on(0).empty(); }));
    cluster_->kill_node(0);
    ASSERT_TRUE(becomes([&] { return cluster_->jobs_on(0).empty(); }));
    // Slurm finds out by itself, but in its own time: half a minute. A health check is faster.
    cluster_->output_of(
        {"scontrol", "update", "nodename=" + Cluster::node_name(0), "state=down", "reason=lost"});
    EXPECT_THAT(cluster_->state_of_node(0), HasSubstr("down"));
    cluster_->start_node(0);
    ASSERT_TRUE(all_jobs_end()) << cluster_->queue();
    EXPECT_THAT(log("join"), HasSubstr("16 frames kept from an earlier run"));
    expect_the_bytes_of_one();
}

TEST_F(RealSlurm, SubmittedAgainItRendersWhatIsMissing) {
    fs::create_directories(*this / "farm/a.0006.png/in the way");
    const cli::Ending first = submit({"--tries", "1"});
    ASSERT_EQ(first.code, 0) << first;
    ASSERT_TRUE(all_jobs_end()) << cluster_->queue();
    // The chunk was given up, and what should have joined all went with it.
    EXPECT_THAT(log("2"), HasSubstr("a.0006.png"));
    EXPECT_FALSE(fs::exists(*this / "farm/a.slurm/join.log"));
    EXPECT_FALSE(has_frame(7));

    const auto identity = [&](const std::string& name) {
        struct stat found = {};
        EXPECT_EQ(::stat((*this / ("farm/" + name)).c_str(), &found), 0) << name;
        return found.st_ino;
    };
    const ino_t before = identity("a.0012.png");
    fs::remove_all(*this / "farm/a.0006.png");
    ASSERT_EQ(submit().code, 0);
    ASSERT_TRUE(all_jobs_end()) << cluster_->queue();
    EXPECT_EQ(identity("a.0012.png"), before);
    EXPECT_THAT(log("join"), HasSubstr("16 frames kept from an earlier run"));
    expect_the_bytes_of_one();
}

TEST_F(RealSlurm, ItsOwnWordsAreToldWhereItRefuses) {
    const cli::Ending ending = submit({"--sbatch=--partition=nowhere"});
    EXPECT_EQ(ending.code, 3) << ending;
    EXPECT_THAT(ending.err, HasSubstr("nowhere"));
    EXPECT_THAT(ending.err, HasSubstr("sbatch ended with exit status 1"));
    EXPECT_THAT(cluster_->queue(), IsEmpty());
}

} // namespace
} // namespace isomotion::farm
