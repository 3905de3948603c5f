// Programs that are run for what they say, and for as long as they may take.
#include "base/child_process.h"

#include <csignal>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isomotion::base {
namespace {

using namespace std::chrono_literals;
using std::chrono::steady_clock;

ChildProcess shell(const std::string& script) {
    return ChildProcess("/bin/sh", {"-c", script}, Output::keep);
}

TEST(ChildProcess, KeepsItsOutputApartFromItsErrors) {
    ChildProcess child = shell("echo out; echo err >&2; echo more");
    EXPECT_TRUE(child.finish());
    EXPECT_EQ(child.output(), "out\nmore\n");
    EXPECT_EQ(child.last_words(1), "err");
}

// More than a pipe holds while nobody reads.
TEST(ChildProcess, KeepsMuchOutput) {
    ChildProcess child = shell("head -c 1000000 /dev/zero");
    EXPECT_TRUE(child.finish());
    EXPECT_EQ(child.output().size(), 1'000'000u);
}

TEST(ChildProcess, DiscardedOutputIsEmpty) {
    ChildProcess child("/bin/sh", {"-c", "echo out"});
    EXPECT_TRUE(child.finish());
    EXPECT_EQ(child.output(), "");
}

TEST(ChildProcess, IsKilledAtItsDeadline) {
    ChildProcess child = shell("echo before; exec sleep 1000");
    while (child.output().empty()) {
    }
    EXPECT_FALSE(child.finish_by(steady_clock::now() + 10ms));
    EXPECT_EQ(child.ending(), "signal 9");
    EXPECT_EQ(child.output(), "before\n");
}

// Its end counts, not when it is asked for.
TEST(ChildProcess, EndsByItselfBeforeADeadlineThatHasPassed) {
    ChildProcess child = shell("kill -SEGV $$");
    while (!child.ended()) {
    }
    EXPECT_TRUE(child.finish_by(steady_clock::now() - 1s));
    EXPECT_FALSE(child.succeeded());
    EXPECT_EQ(child.ending(), "signal 11");
}

// A worker takes the end of its input for a second signal, which leaves it no time.
TEST(ChildProcess, WaitsWithItsInputOpen) {
    ChildProcess child = shell("exec 3<&0; (read line <&3; echo input ended) &"
                               "trap 'sleep 0.2; kill $!; exit 7' TERM; echo ready; wait");
    while (child.output().empty()) {
    }
    child.terminate();
    child.wait();
    EXPECT_EQ(child.exit_status(), 7);
    EXPECT_EQ(child.output(), "ready\n");
    child.wait(); // once more changes nothing
    EXPECT_EQ(child.exit_status(), 7);
}

// What this program ignores is not ignored by others for it.
TEST(ChildProcess, EndsBySignalsThatItsParentIgnores) {
    const auto before = std::signal(SIGPIPE, SIG_IGN);
    ChildProcess child = shell("kill -PIPE $$; exit 0");
    EXPECT_FALSE(child.finish());
    std::signal(SIGPIPE, before);
    EXPECT_EQ(child.ending(), "signal 13");
}

// The kernel forgets children of a process that ignores SIGCHLD.
TEST(ChildProcess, AnEndingThatNobodyCanTellIsNoSuccess) {
    const auto before = std::signal(SIGCHLD, SIG_IGN);
    ChildProcess waited = shell("exit 0");
    EXPECT_FALSE(waited.finish());
    ChildProcess asked = shell("exit 0");
    const auto deadline = steady_clock::now() + 30s;
    EXPECT_TRUE(asked.finish_by(deadline));
    EXPECT_LT(steady_clock::now(), deadline);
    EXPECT_FALSE(asked.succeeded());
    std::signal(SIGCHLD, before);
}

TEST(ChildProcess, SaysWhereWordsAreLeftOut) {
    ChildProcess child =
        shell("for k in 1 2 3 4 5 6 7 8 9 10; do printf '%09999d\\n' $k >&2; done");
    EXPECT_TRUE(child.finish());
    const std::string all = child.last_words(1000);
    EXPECT_THAT(all, testing::StartsWith("... earlier words left out\n000"));
    EXPECT_THAT(all, testing::EndsWith("\n" + std::string(9997, '0') + "10"));
    EXPECT_EQ(child.last_words(2).size(), 2u * 9999 + 1);
    ChildProcess few = shell("echo a >&2; echo b >&2");
    EXPECT_TRUE(few.finish());
    EXPECT_EQ(few.last_words(1000), "a\nb");
}

} // namespace
} // namespace isomotion::base
