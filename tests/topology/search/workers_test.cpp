// Loops shared by threads: each turn once, told in order, and what goes wrong is told.
#include "base/workers.h"

#include <chrono>
#include <numeric>
#include <stdexcept>

#include <gtest/gtest.h>

#include "topology/analyse.h"
#include "topology/moving.h"

namespace isomotion::topology {
namespace {

void pause() { std::this_thread::sleep_for(std::chrono::milliseconds(1)); }

// Fails where it is called by two threads at once, and where the part falls.
class Listener {
public:
    void hear(const std::string& what, double part) {
        EXPECT_FALSE(is_busy_.exchange(true));
        pause(); // time for others to come
        if (what == what_) {
            EXPECT_GE(part, part_) << what;
        }
        what_ = what;
        part_ = part;
        ++times_;
        is_busy_ = false;
    }
    int times() const { return times_; }
    double part() const { return part_; }

private:
    std::atomic<bool> is_busy_ = false;
    std::string what_;
    double part_ = 0;
    int times_ = 0;
};

TEST(Workers, DoEachTurnOnce) {
    for (const int threads : {1, 2, 5, 200}) {
        std::vector<int> turns(100, 0);
        Listener listener;
        base::share({.count = turns.size(),
                     .threads = threads,
                     .progress = [&](double part) { listener.hear("turns", part); }},
                    [&] { return [&](std::size_t k) { ++turns[k]; }; });
        EXPECT_EQ(turns, std::vector<int>(100, 1));
        EXPECT_EQ(listener.times(), 100);
        EXPECT_EQ(listener.part(), 1);
    }
    base::share({}, [] { return [](std::size_t) { FAIL(); }; });
}

TEST(Workers, ThrowWhatOneOfThemThrows) {
    for (const int threads : {1, 4}) {
        std::atomic<int> turns{0};
        const auto worker = [&] {
            return [&](std::size_t k) {
                ++turns;
                pause();
                if (k % 10 == 9) throw std::runtime_error("turn");
            };
        };
        EXPECT_THROW(base::share({.count = 1000, .threads = threads}, worker), std::runtime_error);
        EXPECT_LT(turns, 1000);
    }
    // Nor does a worker that cannot be made end the process.
    const auto none = [&]() -> std::function<void(std::size_t)> { throw std::bad_alloc(); };
    EXPECT_THROW(base::share({.count = 3, .threads = 3}, none), std::bad_alloc);
}

TEST(Workers, StopWhenAsked) {
    std::atomic<int> turns{0};
    const auto stopped = [&] { return turns >= 5; };
    base::share({.count = 1000, .threads = 2, .stopped = stopped},
                [&] { return [&](std::size_t) { ++turns; }; });
    EXPECT_GE(turns, 5);
    EXPECT_LE(turns, 6);
}

// All that analyses tell, they tell in order.
TEST(Analyse, TellsFromOneThreadAtATime) {
    const Moving sphere{"x^2 + y^2 + z^2 + x*y/8 - c", "{ box = [[-1, -1, -1], [1, 1, 1]] }",
                        "c = \"t - 0.5\"", "[time]\nfps = 10\nframes = 11\n"};
    for (const Certify certify : {Certify::fast, Certify::full}) {
        Listener listener;
        AnalyseOptions how;
        how.certify = certify;
        how.threads = 4;
        how.progress = [&](const std::string& what, double part) { listener.hear(what, part); };
        analyse(sphere.scene(), how);
        EXPECT_GT(listener.times(), 50);
    }
}

// An analysis is asked for its end within each task, not only between them.
TEST(Analyse, AsksOften) {
    const Moving sphere{"x^2 + y^2 + z^2 + x*y/8 - c", "{ sphere = 2 }", "c = \"t - 0.5\"",
                        "[time]\nfps = 10\nframes = 11\n"};
    int asked = 0, told = 0;
    AnalyseOptions how;
    how.threads = 1;
    how.stop = [&] { return ++asked < 0; };
    how.progress = [&](const std::string&, double) { ++told; };
    const Timeline whole = analyse(sphere.scene(), how);
    EXPECT_EQ(whole.events.size(), 1u);
    EXPECT_GT(asked, 3 * told);
    const int times = asked;
    for (const int part : {0, 1, 2, 3}) {
        asked = 0;
        how.stop = [&] { return ++asked > times * part / 4; };
        const Timeline some = analyse(sphere.scene(), how);
        EXPECT_FALSE(some.is_proved) << part;
        EXPECT_FALSE(some.is_complete()) << part;
        EXPECT_FALSE(some.doubts.empty()) << part;
    }
}

} // namespace
} // namespace isomotion::topology
