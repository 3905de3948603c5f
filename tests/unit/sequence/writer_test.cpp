#include "sequence/writer.h"

#include <algorithm>
#include <cerrno>
#include <future>
#include <latch>

#include "base/content_hash.h"
#include "base/file.h"
#include "base/input_error.h"
#include "image/decode.h"
#include "unit/image/places.h"

namespace isomotion::sequence {
namespace {

class Writer : public testing::Test {
protected:
    SequenceName name() const { return SequenceName::parse((folder_ / "a.####.exr").string()); }
    static image::Frame numbered(int number) { return {1, 1, {{"Z", {float(number)}}}, {}}; }

    base::TemporaryFolder folder_;
};

TEST_F(Writer, WritesEveryFrameInOrder) {
    std::vector<int> order;
    SequenceWriter writer(name(), image::Format::exr);
    for (int frame = 1; frame <= 20; ++frame) {
        EXPECT_TRUE(writer.submit(frame, numbered(frame),
                                  [&order, frame](const auto&) { order.push_back(frame); }));
    }
    writer.finish();
    writer.finish();
    ASSERT_EQ(order.size(), 20u);
    EXPECT_TRUE(std::ranges::is_sorted(order));
    EXPECT_EQ(folder_.names().size(), 20u);
    for (int frame = 1; frame <= 20; ++frame)
        EXPECT_EQ(image::decode(name().path(frame)).find("Z")->samples[0], float(frame));
    EXPECT_THROW(writer.submit(21, numbered(21)), std::logic_error);
}

TEST_F(Writer, TellsWhatWasWritten) {
    std::vector<WrittenFile> all;
    SequenceWriter writer(name(), image::Format::exr);
    for (int frame = 1; frame <= 3; ++frame)
        writer.submit(frame, numbered(frame), [&](const WrittenFile& file) {
            EXPECT_TRUE(std::filesystem::exists(file.file)); // it has its name already
            all.push_back(file);
        });
    writer.finish();
    ASSERT_EQ(all.size(), 3u);
    for (int frame = 1; frame <= 3; ++frame) {
        const WrittenFile& file = all[std::size_t(frame - 1)];
        EXPECT_EQ(file.file, name().path(frame));
        EXPECT_EQ(file.bytes, std::filesystem::file_size(file.file));
        EXPECT_EQ(file.hash, base::content_hash(base::read_whole(file.file)));
        EXPECT_EQ(file.pixels, image::pixel_hash(file.file));
    }
    EXPECT_NE(all[0].pixels, all[1].pixels);
}

TEST_F(Writer, WhatIsThrownAfterAFrameStopsTheWriter) {
    SequenceWriter writer(name(), image::Format::exr);
    writer.submit(1, numbered(1), [](const WrittenFile&) { throw std::runtime_error("no"); });
    EXPECT_THROW(writer.finish(), std::runtime_error);
}

TEST_F(Writer, QueueIsBounded) {
    std::latch writing(1), released(1);
    SequenceWriter writer(name(), image::Format::exr);
    writer.submit(1, numbered(1), [&](const auto&) {
        writing.count_down();
        released.wait();
    });
    writing.wait();
    const int last = int(SequenceWriter::most_waiting) + 2;
    for (int frame = 2; frame < last; ++frame) writer.submit(frame, numbered(frame));
    auto blocked =
        std::async(std::launch::async, [&] { return writer.submit(last, numbered(last)); });
    EXPECT_EQ(blocked.wait_for(std::chrono::milliseconds(100)), std::future_status::timeout);
    released.count_down();
    EXPECT_TRUE(blocked.get());
    writer.finish();
    EXPECT_EQ(folder_.names().size(), std::size_t(last));
}

TEST_F(Writer, FirstErrorStopsAndComesOut) {
    SequenceWriter writer(SequenceName::parse((folder_ / "none/a.####.exr").string()),
                          image::Format::exr);
    const auto submit_until_refused = [&] {
        for (int frame = 1; frame <= 1000; ++frame) writer.submit(frame, numbered(frame));
    };
    EXPECT_THROW(submit_until_refused(), base::FileError);
    try {
        writer.finish();
        FAIL();
    } catch (const base::FileError& error) {
        EXPECT_EQ(error.system_code(), ENOENT);
        EXPECT_EQ(error.path(), folder_ / "none/a.0001.exr");
    }
}

TEST_F(Writer, AFrameThatIsNoPictureIsAnError) {
    SequenceWriter writer(name(), image::Format::png8);
    writer.submit(1, numbered(1));
    EXPECT_THROW(writer.finish(), image::ImageError);
    EXPECT_TRUE(folder_.names().empty());
}

TEST_F(Writer, AFullDiskComesOutAndLeavesWholeFilesOnly) {
    const base::Disk disk(folder_, 0, "size=256k");
    if (!disk) GTEST_SKIP() << "no right to mount a small disk";
    SequenceWriter writer(name(), image::Format::exr);
    image::Frame noise{100, 100, {{"Z", std::vector<float>(10'000)}}, {}};
    for (std::size_t i = 0; i < 10'000; ++i)
        noise.channels[0].samples[i] = float((i * 2654435761u) % 1000003u);
    try {
        for (int frame = 1; frame <= 100; ++frame) writer.submit(frame, noise);
        writer.finish();
        FAIL();
    } catch (const base::FileError& error) {
        EXPECT_EQ(error.system_code(), ENOSPC);
    }
    EXPECT_FALSE(folder_.names().empty());
    for (const std::string& file : folder_.names()) EXPECT_NO_THROW(image::decode(folder_ / file));
}

TEST_F(Writer, CancelDropsWhatWaits) {
    std::latch writing(1), released(1);
    SequenceWriter writer(name(), image::Format::exr);
    writer.submit(1, numbered(1), [&](const auto&) {
        writing.count_down();
        released.wait();
    });
    writing.wait();
    for (int frame = 2; frame <= 5; ++frame) writer.submit(frame, numbered(frame));
    auto blocked = std::async(std::launch::async, [&] { return writer.submit(6, numbered(6)); });
    writer.cancel();
    EXPECT_FALSE(blocked.get());
    EXPECT_FALSE(writer.submit(7, numbered(7)));
    released.count_down();
    writer.finish();
    EXPECT_EQ(folder_.names(), std::set<std::string>{"a.0001.exr"});
}

TEST_F(Writer, DestructorLeavesNothingHalfDone) {
    for (int run = 0; run < 20; ++run) {
        SequenceWriter writer(name(), image::Format::exr);
        for (int frame = 1; frame <= 5; ++frame) writer.submit(frame, numbered(frame));
    }
    for (const std::string& file : folder_.names()) {
        EXPECT_FALSE(file.starts_with(".")) << file;
        EXPECT_NO_THROW(image::decode(folder_ / file));
    }
}

TEST_F(Writer, OneFileTakesOneFrame) {
    SequenceWriter writer(SequenceName::parse((folder_ / "a.exr").string()), image::Format::exr);
    writer.submit(1, numbered(1));
    EXPECT_THROW(writer.submit(2, numbered(2)), base::InputError);
    writer.finish();
    EXPECT_EQ(folder_.names(), std::set<std::string>{"a.exr"});
}

} // namespace
} // namespace isomotion::sequence
