#include "base/last_words.h"

#include <csignal>
#include <cstdlib>
#include <thread>

#include <gtest/gtest.h>

namespace isomotion::base {
namespace {

TEST(LastWordsDeathTest, ACrashEndsInWords) {
    for (const int signal : {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT}) {
        EXPECT_EXIT(
            {
                const LastWords words("it crashed\n", 3);
                std::raise(signal);
            },
            testing::ExitedWithCode(3), "^it crashed\n$")
            << signal;
    }
}

TEST(LastWordsDeathTest, AnotherThreadsCrashDoesToo) {
    EXPECT_EXIT(
        {
            const LastWords words("it crashed\n", 5);
            std::thread([] { std::abort(); }).join();
        },
        testing::ExitedWithCode(5), "^it crashed\n$");
}

// What was there before comes back: a later crash keeps its signal.
TEST(LastWordsDeathTest, TheyAreSaidOnlyWhileTheyLive) {
    EXPECT_EXIT(
        {
            std::signal(SIGABRT, SIG_DFL);
            { const LastWords words("it crashed\n", 3); }
            std::abort();
        },
        testing::KilledBySignal(SIGABRT), "^$");
}

} // namespace
} // namespace isomotion::base
