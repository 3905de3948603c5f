// However often an export is killed, what is left is whole frames, and --resume makes of them what
// an undisturbed run makes.
#include "export.h"

#include <csignal>
#include <random>
#include <thread>

namespace isomotion::faults {
namespace {

class Kills : public Export {
protected:
    // Kills a run when `more` further frames have their names and `after` went by.
    Ending kill(int more, std::chrono::microseconds after) const {
        const int before = finished("cut");
        return run_until(command("cut", {"--resume"}), SIGKILL, [=, this](auto) {
            if (finished("cut") < before + more) return false;
            std::this_thread::sleep_for(after);
            return true;
        });
    }
};

// Fifty kills in five parts, none of which is long.
class TenKills : public Kills, public testing::WithParamInterface<unsigned> {};

TEST_P(TenKills, AtRandomMoments) {
    const unsigned seed = std::random_device{}() + GetParam();
    SCOPED_TRACE(fmt::format("seed {}", seed));
    std::mt19937 random(seed);
    whole();

    constexpr int wanted = 10;
    int kills = 0, in_the_middle = 0, runs = 0;
    const auto expect_the_rest = [&] {
        const Ending rest = run(command("cut", {"--resume"}));
        EXPECT_EQ(rest.code, 0) << rest;
        expect_frames_of("cut");
        expect_verified("cut");
    };
    for (; kills < wanted && runs < 3 * wanted; ++runs) {
        const int before = finished("cut");
        // From none, while it starts or checks what is there, to many, while it renders.
        const int more = std::uniform_int_distribution(0, 9)(random);
        const int after = std::uniform_int_distribution(0, more == 0 ? 300'000 : 4000)(random);
        const bool killed = kill(more, std::chrono::microseconds(after)).signal == SIGKILL;
        const int now = finished("cut");
        kills += killed;
        in_the_middle += killed && now > before && now < frames;
        expect_frames_of("cut", false);
        if (now < frames) continue;
        expect_the_rest();
        fs::remove_all(*this / "cut");
    }
    expect_the_rest();
    expect_only_whole_files(); // hidden ones are used up
    EXPECT_EQ(kills, wanted) << runs;
    EXPECT_GE(in_the_middle, wanted / 3);
    fmt::print("seed {}: {} kills in {} runs, {} between the first and the last new frame\n", seed,
               kills, runs, in_the_middle);
}

INSTANTIATE_TEST_SUITE_P(Parts, TenKills, testing::Range(0u, 5u));

TEST_F(Kills, SignalsThatAskLeaveWholeRecordedFrames) {
    for (const int signal : {SIGINT, SIGTERM}) {
        fs::remove_all(*this / "cut");
        const Ending ending =
            run_until(command("cut"), signal, [this](auto) { return finished("cut") >= 3; });
        EXPECT_EQ(ending.code, 130) << ending;
        expect_only_whole_files();
        expect_frames_of("cut", false);
        const int left = finished("cut");
        ASSERT_LT(left, frames);
        // Each has its record: none is rendered again.
        const Ending rest = run(command("cut", {"--resume"}));
        EXPECT_THAT(rest.out, HasSubstr(fmt::format("\n{} frames kept from", left)));
        EXPECT_THAT(rest.out, HasSubstr(fmt::format("\nnot kept: {} missing (", frames - left)));
        expect_frames_of("cut");
        expect_verified("cut");
    }
}

} // namespace
} // namespace isomotion::faults
