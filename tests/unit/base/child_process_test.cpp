// Programs that are run for what they say, and for as long as they may take.
#include "base/child_process.h"

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

} // namespace
} // namespace isomotion::base
