#include "image/sequence.h"

#include <algorithm>
#include <cerrno>
#include <future>
#include <latch>
#include <random>

#include "base/content_hash.h"
#include "base/file.h"
#include "image/decode.h"
#include "places.h"

namespace isomotion::image {
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
        EXPECT_THROW(name.check_holds(2), ImageError);
    }
}

TEST(SequenceName, SaysWhatWouldBeRight) {
    try {
        SequenceName::parse("out/name.exr").check_holds(120);
        FAIL();
    } catch (const ImageError& error) {
        EXPECT_STREQ(error.what(), "out/name.exr: names one file for 120 frames; put #### where "
                                   "their number goes, as in name.####.exr");
    }
}

TEST(SequenceName, RefusesTwoPlacesAndFolders) {
    for (const char* text : {"a##.##.exr", "a%d.%d.exr", "a##%04d.exr", "", "out/", ".."})
        EXPECT_THROW(SequenceName::parse(text), ImageError) << text;
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

class Sequence : public testing::Test {
protected:
    SequenceName name() const { return SequenceName::parse((folder_ / "a.####.exr").string()); }
    static Frame numbered(int number) { return {1, 1, {{"Z", {float(number)}}}, {}}; }

    TemporaryFolder folder_;
};

TEST_F(Sequence, WritesEveryFrameInOrder) {
    std::vector<int> order;
    SequenceWriter writer(name(), Format::exr,
                          {.on_written = [&](int frame, const auto&) { order.push_back(frame); }});
    for (int frame = 1; frame <= 20; ++frame) EXPECT_TRUE(writer.submit(frame, numbered(frame)));
    writer.finish();
    writer.finish();
    EXPECT_EQ(writer.written(), 20u);
    ASSERT_EQ(order.size(), 20u);
    EXPECT_TRUE(std::ranges::is_sorted(order));
    EXPECT_EQ(folder_.names().size(), 20u);
    for (int frame = 1; frame <= 20; ++frame)
        EXPECT_EQ(decode(name().path(frame)).find("Z")->samples[0], float(frame));
    EXPECT_THROW(writer.submit(21, numbered(21)), std::logic_error);
}

TEST_F(Sequence, TellsWhatWasWritten) {
    std::vector<Written> all;
    SequenceWriter writer(name(), Format::exr);
    for (int frame = 1; frame <= 3; ++frame)
        writer.submit(frame, numbered(frame), [&](const Written& file) {
            EXPECT_TRUE(std::filesystem::exists(file.file)); // it has its name already
            all.push_back(file);
        });
    writer.finish();
    ASSERT_EQ(all.size(), 3u);
    for (int frame = 1; frame <= 3; ++frame) {
        const Written& file = all[std::size_t(frame - 1)];
        EXPECT_EQ(file.file, name().path(frame));
        EXPECT_EQ(file.bytes, std::filesystem::file_size(file.file));
        EXPECT_EQ(file.hash, base::content_hash(base::read_whole(file.file)));
        EXPECT_EQ(file.pixels, pixel_hash(file.file));
    }
    EXPECT_NE(all[0].pixels, all[1].pixels);
}

TEST_F(Sequence, WhatIsThrownAfterAFrameStopsTheWriter) {
    SequenceWriter writer(name(), Format::exr);
    writer.submit(1, numbered(1), [](const Written&) { throw std::runtime_error("no"); });
    EXPECT_THROW(writer.finish(), std::runtime_error);
}

TEST_F(Sequence, WritesWithSeveralThreads) {
    int reports = 0; // no lock: reports never come two at once
    SequenceWriter writer(name(), Format::exr,
                          {.threads = 3, .on_written = [&](int, const auto&) { ++reports; }});
    for (int frame = 1; frame <= 40; ++frame) writer.submit(frame, numbered(frame));
    writer.finish();
    EXPECT_EQ(reports, 40);
    EXPECT_EQ(folder_.names().size(), 40u);
}

TEST_F(Sequence, QueueIsBounded) {
    std::latch released(1);
    SequenceWriter writer(name(), Format::exr, {.capacity = 2, .on_written = [&](int, const auto&) {
                                                    released.wait();
                                                }});
    writer.submit(1, numbered(1));
    while (writer.written() == 0) std::this_thread::yield(); // the only thread is now held up
    writer.submit(2, numbered(2));
    writer.submit(3, numbered(3));
    auto blocked = std::async(std::launch::async, [&] { return writer.submit(4, numbered(4)); });
    EXPECT_EQ(blocked.wait_for(std::chrono::milliseconds(100)), std::future_status::timeout);
    released.count_down();
    EXPECT_TRUE(blocked.get());
    writer.finish();
    EXPECT_EQ(writer.written(), 4u);
}

TEST_F(Sequence, FirstErrorStopsAndComesOut) {
    SequenceWriter writer(SequenceName::parse((folder_ / "none/a.####.exr").string()), Format::exr);
    const auto submit_until_refused = [&] {
        for (int frame = 1; frame <= 1000; ++frame) writer.submit(frame, numbered(frame));
    };
    EXPECT_THROW(submit_until_refused(), base::FileError);
    try {
        writer.finish();
        FAIL();
    } catch (const base::FileError& error) {
        EXPECT_EQ(error.code(), ENOENT);
        EXPECT_EQ(error.path(), folder_ / "none/a.0001.exr");
    }
    EXPECT_EQ(writer.written(), 0u);
}

TEST_F(Sequence, AFrameThatIsNoPictureIsAnError) {
    SequenceWriter writer(name(), Format::png8);
    writer.submit(1, numbered(1));
    EXPECT_THROW(writer.finish(), ImageError);
    EXPECT_TRUE(folder_.names().empty());
}

TEST_F(Sequence, AFullDiskComesOutAndLeavesWholeFilesOnly) {
    const Disk disk(folder_, 0, "size=256k");
    if (!disk) GTEST_SKIP() << "no right to mount a small disk";
    SequenceWriter writer(name(), Format::exr);
    Frame noise{100, 100, {{"Z", std::vector<float>(10'000)}}, {}};
    for (std::size_t i = 0; i < 10'000; ++i)
        noise.channels[0].samples[i] = float((i * 2654435761u) % 1000003u);
    try {
        for (int frame = 1; frame <= 100; ++frame) writer.submit(frame, noise);
        writer.finish();
        FAIL();
    } catch (const base::FileError& error) {
        EXPECT_EQ(error.code(), ENOSPC);
    }
    EXPECT_GT(writer.written(), 0u);
    EXPECT_EQ(folder_.names().size(), writer.written());
    for (const std::string& file : folder_.names()) EXPECT_NO_THROW(decode(folder_ / file));
}

TEST_F(Sequence, CancelDropsWhatWaits) {
    std::latch released(1);
    SequenceWriter writer(name(), Format::exr,
                          {.on_written = [&](int, const auto&) { released.wait(); }});
    writer.submit(1, numbered(1));
    while (writer.written() == 0) std::this_thread::yield();
    for (int frame = 2; frame <= 5; ++frame) writer.submit(frame, numbered(frame));
    auto blocked = std::async(std::launch::async, [&] { return writer.submit(6, numbered(6)); });
    writer.cancel();
    EXPECT_FALSE(blocked.get());
    EXPECT_FALSE(writer.submit(7, numbered(7)));
    released.count_down();
    writer.finish();
    EXPECT_EQ(folder_.names(), std::set<std::string>{"a.0001.exr"});
}

TEST_F(Sequence, DestructorLeavesNothingHalfDone) {
    for (int run = 0; run < 20; ++run) {
        SequenceWriter writer(name(), Format::exr, {.threads = 2});
        for (int frame = 1; frame <= 5; ++frame) writer.submit(frame, numbered(frame));
    }
    for (const std::string& file : folder_.names()) {
        EXPECT_FALSE(file.starts_with(".")) << file;
        EXPECT_NO_THROW(decode(folder_ / file));
    }
}

TEST_F(Sequence, OneFileTakesOneFrame) {
    SequenceWriter writer(SequenceName::parse((folder_ / "a.exr").string()), Format::exr);
    writer.submit(1, numbered(1));
    EXPECT_THROW(writer.submit(2, numbered(2)), ImageError);
    writer.finish();
    EXPECT_EQ(folder_.names(), std::set<std::string>{"a.exr"});
}

} // namespace
} // namespace isomotion::image
