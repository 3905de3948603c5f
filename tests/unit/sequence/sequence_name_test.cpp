#include "sequence/names/sequence_name.h"

#include <random>

#include <gtest/gtest.h>

#include "base/input_error.h"

namespace isomotion::sequence {
namespace {

TEST(SequenceName, PutsTheNumberInItsPlace) {
    EXPECT_EQ(SequenceName::parse("out/name.####.exr").path(7), "out/name.0007.exr");
    EXPECT_EQ(SequenceName::parse("out/name.####.exr").path(123456), "out/name.123456.exr");
    EXPECT_EQ(SequenceName::parse("#.png").path(12), "12.png");
    EXPECT_EQ(SequenceName::parse("a_%04d.png").path(12), "a_0012.png");
    EXPECT_EQ(SequenceName::parse("a_%d.png").path(12), "a_12.png");
    EXPECT_EQ(SequenceName::parse("a_%012d.png").path(12), "a_000000000012.png");
    EXPECT_EQ(SequenceName::parse("a####.png").path(-3), "a-003.png");
    EXPECT_TRUE(SequenceName::parse("a####.png").holds_many());
}

TEST(SequenceName, WithoutAPlaceHoldsOneFrame) {
    for (const char* text : {"out/name.exr", "out##/name.exr", "100%.exr", "50%s.exr", "%x.exr"}) {
        const SequenceName name = SequenceName::parse(text);
        EXPECT_FALSE(name.holds_many());
        EXPECT_EQ(name.path(7), text);
        EXPECT_NO_THROW(name.check_holds(1));
        EXPECT_THROW(name.check_holds(2), base::InputError);
    }
}

TEST(SequenceName, SaysWhatWouldBeRight) {
    try {
        SequenceName::parse("out/name.exr").check_holds(120);
        FAIL();
    } catch (const base::InputError& error) {
        EXPECT_STREQ(error.what(), "out/name.exr: names one file for 120 frames; put #### where "
                                   "their number goes, as in name.####.exr");
    }
}

TEST(SequenceName, RefusesTwoPlacesAndFolders) {
    for (const char* text : {"a##.##.exr", "a%d.%d.exr", "a##%04d.exr", "", "out/", ".."})
        EXPECT_THROW(SequenceName::parse(text), base::InputError) << text;
}

TEST(SequenceName, RefusesWhatAManifestCannotHold) {
    const std::string refused[] = {"a\xff.##.png",
                                   "a\n.##.png",
                                   "a\x1b[2J.##.png",
                                   std::string(33, '#'),
                                   std::string(300'000, '#') + ".png",
                                   "a%033d.png",
                                   "a%018446744073709551620d.png"};
    for (const std::string& text : refused)
        EXPECT_THROW(SequenceName::parse(text), base::InputError) << text.substr(0, 60);
    // One picture has no manifest, and folders may have any name.
    EXPECT_EQ(SequenceName::parse("a\xff.png").path(1), "a\xff.png");
    EXPECT_EQ(SequenceName::parse("\xff/a.#.png").path(1), "\xff/a.1.png");
    EXPECT_EQ(SequenceName::parse("h\u00e9.#.png").path(1), "h\u00e9.1.png");
    EXPECT_EQ(SequenceName::parse(std::string(32, '#')).path(1), std::string(31, '0') + "1");
}

TEST(SequenceName, KnowsItsOwnFiles) {
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    for (const char* text : {"out/name.####.exr", "#.png", "a_%04d.png", "7####7.png", "a%d.png"}) {
        const SequenceName name = SequenceName::parse(text);
        for (int round = 0; round < 200; ++round) {
            const int frame = int(random() >> (random() % 31 + 1));
            EXPECT_EQ(name.frame_of(name.path(frame).filename().string()), frame) << text;
        }
    }
    const SequenceName name = SequenceName::parse("out/a.####.png");
    for (const char* file :
         {"", "a.png", "a..png", "a.1.png", "a.00001.png", "a.001x.png", "a.0001.exr", "b.0001.png",
          ".a.0001.part.png", "a.+001.png", "a. 001.png", "a.99999999999.png", "a.0001.png "}) {
        EXPECT_FALSE(name.frame_of(file)) << file;
    }
    EXPECT_FALSE(SequenceName::parse("a.png").frame_of("a.png"));
}

TEST(SequenceName, HasOnePatternAndAStem) {
    const auto expect = [](const char* text, const char* pattern, const char* stem) {
        EXPECT_EQ(SequenceName::parse(text).pattern(), pattern) << text;
        EXPECT_EQ(SequenceName::parse(text).stem(), stem) << text;
    };
    expect("out/name.####.exr", "name.####.exr", "name");
    expect("out/name.%04d.exr", "name.####.exr", "name");
    expect("%d.png", "#.png", "");
    expect("####", "####", "");
    expect("a.b.##.c.png", "a.b.##.c.png", "a.b.c");
    expect("a.png", "a.png", "a");
}

// Frames are told apart by their numbers alone, whatever a scene's file is called.
TEST(StemOfFrames, HasNoPlaceForANumber) {
    EXPECT_EQ(stem_of_frames("torus"), "torus");
    EXPECT_EQ(stem_of_frames("50%"), "50%");
    EXPECT_EQ(stem_of_frames("take#2 %3d %d"), "take_2 %3d _d");
    for (const std::string name : {"a#b", "%d", "50%04d", "##_#", "take %3d #2", "a\xff", "a\nb"}) {
        const std::string stem = stem_of_frames(name);
        const SequenceName frames = SequenceName::parse("out/" + stem + ".####.png");
        EXPECT_EQ(frames.path(7), "out/" + stem + ".0007.png");
    }
}

} // namespace
} // namespace isomotion::sequence
