// Several exports into one folder at once.
#include "export.h"

#include <atomic>
#include <csignal>
#include <future>

namespace isomotion::faults {
namespace {

using Several = Export;

TEST_F(Several, OfTheSameFrames) {
    std::vector<std::future<Ending>> all;
    for (int k = 0; k < 3; ++k) {
        all.push_back(std::async(std::launch::async, [this] { return run(command("out")); }));
    }
    for (auto& one : all) {
        const Ending ending = one.get();
        EXPECT_EQ(ending.code, 0) << ending;
        EXPECT_THAT(ending.err, IsEmpty());
    }
    expect_frames_of("out");
    expect_verified("out");
    expect_only_whole_files();
}

TEST_F(Several, OfChunksThatMakeOneSequence) {
    std::vector<std::future<Ending>> all;
    for (const char* chunk : {"1-20", "21-40", "41-60"}) {
        all.push_back(std::async(std::launch::async, [this, chunk] {
            return run(command("out", {"--frames", chunk, "--resume"}));
        }));
    }
    for (auto& one : all) EXPECT_EQ(one.get().code, 0);
    expect_frames_of("out");
    expect_verified("out");
    EXPECT_THAT(bytes("out/a.manifest/sequence.json"), HasSubstr("\"frames\": \"1-60\""));
    const Ending last = run(command("out", {"--resume"}));
    EXPECT_THAT(last.out, HasSubstr("\n60 frames kept from an earlier run\n"));
    EXPECT_THAT(last.out, Not(HasSubstr("drawn")));
}

TEST_F(Several, OfDifferentScenesIsRefused) {
    std::atomic<bool> tried = false;
    auto long_one = std::async(std::launch::async, [&] {
        return run_until(command("out", {"--frames", "1-100000"}), SIGINT,
                         [&](auto) { return tried.load(); });
    });
    while (finished("out") < 2) std::this_thread::yield();
    const std::pair<Words, std::string> others[] = {
        {{"--size", "32x32"}, "size 48x48, not 32x32"},
        {{"--set", "r=0.9"}, "the same scene with other settings"},
    };
    for (const auto& [change, difference] : others) {
        const Ending ending = run(command("out", change));
        EXPECT_EQ(ending.code, 2) << ending;
        EXPECT_THAT(ending.err, HasSubstr("out/a.manifest: somebody is rendering these frames"));
        EXPECT_THAT(ending.err, HasSubstr(difference));
    }
    std::string other_title = sphere_scene();
    write("sphere.toml", other_title.replace(other_title.find("Sphere"), 6, "Globe"));
    EXPECT_THAT(run(command("out", {"--resume"})).err,
                HasSubstr("scene \"Sphere\", not \"Globe\""));
    write("sphere.toml", sphere_scene());
    tried = true;
    EXPECT_EQ(long_one.get().code, 130);
    expect_frames_of("out", false);

    // One after the other they may: the last one has the frames, and the rest is told.
    const Ending smaller = run(command("out", {"--size", "32x32", "--frames", "1-3"}));
    EXPECT_EQ(smaller.code, 0) << smaller;
    const Ending mixed = run({"verify", "out"});
    EXPECT_EQ(mixed.code, 1) << mixed;
    EXPECT_THAT(mixed.out, HasSubstr("of an earlier scene or from elsewhere, never asked for: "));
}

} // namespace
} // namespace isomotion::faults
