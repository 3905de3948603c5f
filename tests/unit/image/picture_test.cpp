#include <array>
#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

#include "base/file.h"
#include "image/decode.h"
#include "image/encode.h"
#include "places.h"
#include "unit/image/compare.h"

namespace isomotion::image {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

/// A picture in which no two samples of a channel and no two channels are alike.
Frame varied(int width, int height, std::initializer_list<const char*> names) {
    Frame frame{width, height, {}, {}};
    int number = 0;
    for (const char* name : names) {
        Channel channel{name, {}};
        const std::size_t area = std::size_t(width) * std::size_t(height);
        for (std::size_t i = 0; i < area; ++i)
            channel.samples.push_back(std::fmod(0.37f * float(++number), 1.0f));
        frame.channels.push_back(std::move(channel));
    }
    return frame;
}

Frame with_coverage(Frame frame) {
    const std::vector<float> coverage = frame.find("A")->samples;
    for (Channel& channel : frame.channels)
        if (channel.name != "A")
            for (std::size_t i = 0; i < coverage.size(); ++i) channel.samples[i] *= coverage[i];
    return frame;
}

Metadata of_every_type() {
    return {{"isomotion:scene", "h\u00e9llo \"x\"\nnext line"},
            {"frame", 812},
            {"time", 27.033333333333335},
            {"FramesPerSecond", Rational{30000, 1001}},
            {"isomotion:parameters", std::vector{0.1, -2.0, 1.0 / 3.0, 1e-300}}};
}

class Picture : public testing::Test {
protected:
    Frame there_and_back(const Frame& frame, Format format) {
        const auto file = folder_ / (format == Format::exr ? "a.exr" : "a.png");
        base::write_whole(file, encode(frame, format));
        return decode(file);
    }
    void expect_close(const Frame& frame, Format format, double tolerance) {
        const Comparison result = compare(frame, there_and_back(frame, format), tolerance);
        EXPECT_TRUE(result.within_tolerance());
        for (const ChannelDifference& channel : result.channels)
            EXPECT_LE(channel.largest, tolerance) << channel.name;
    }

    TemporaryFolder folder_;
};

TEST(FormatOf, FollowsTheExtension) {
    EXPECT_EQ(format_of("out/a.0001.png"), Format::png8);
    EXPECT_EQ(format_of("a.PNG", PngDepth::bits16), Format::png16);
    EXPECT_EQ(format_of("a.exr", PngDepth::bits16), Format::exr);
}

TEST(FormatOf, SaysWhatWouldBeRight) {
    for (const char* name : {"a.jpg", "a", "png", ".exr", "a.exr.bak"}) {
        try {
            format_of(name);
            ADD_FAILURE() << name;
        } catch (const ImageError& error) {
            EXPECT_NE(std::string(error.what()).find(".png or .exr"), std::string::npos);
        }
    }
}

TEST_F(Picture, ExrKeepsEveryChannelByName) {
    const Frame frame = varied(7, 5,
                               {"R", "G", "B", "A", "Z", "N.X", "N.Y", "N.Z", "P.X", "P.Y", "P.Z",
                                "velocity.X", "velocity.Y", "verdict", "evaluations"});
    const Comparison result = compare(frame, there_and_back(frame, Format::exr));
    EXPECT_TRUE(result.same_size);
    EXPECT_TRUE(result.only_in_first.empty());
    EXPECT_TRUE(result.only_in_second.empty());
    ASSERT_EQ(result.channels.size(), frame.channels.size());
    for (const ChannelDifference& channel : result.channels)
        EXPECT_LE(channel.largest, channel.name.size() == 1 && channel.name != "Z" ? 0x1p-11 : 0)
            << channel.name;
}

TEST_F(Picture, ExrNeedsNoColour) { expect_close(varied(3, 2, {"Z"}), Format::exr, 0); }

TEST_F(Picture, ExrKeepsWhatIsNotFinite) {
    Frame frame = plain(2, 2, nan, infinity, -infinity);
    frame.channels.push_back({"Z", {nan, infinity, -infinity, 1e30f}});
    expect_close(frame, Format::exr, 0);
}

TEST_F(Picture, ExrDoesNotMakeABrightLightInfinite) {
    const Frame back = there_and_back(plain(1, 1, 1e6f, -1e6f, 65504.0f), Format::exr);
    EXPECT_EQ(back.find("R")->samples[0], 65504.0f);
    EXPECT_EQ(back.find("G")->samples[0], -65504.0f);
    EXPECT_EQ(back.find("B")->samples[0], 65504.0f);
}

TEST_F(Picture, PngKeepsColour) {
    const Frame frame = varied(37, 19, {"R", "G", "B"});
    expect_close(frame, Format::png8, 0.0045); // half a code where the curve is steepest
    expect_close(frame, Format::png16, 0.00002);
}

TEST_F(Picture, PngKeepsColourUnderCoverage) {
    const Frame frame = with_coverage(varied(37, 19, {"R", "G", "B", "A"}));
    expect_close(frame, Format::png8, 0.0066);
    expect_close(frame, Format::png16, 0.00003);
}

TEST_F(Picture, PngStoresColourThatIsNotMultiplied) {
    Frame frame = plain(1, 1, 0.25f, 0.25f, 0.0f);
    frame.channels.push_back({"A", {0.25f}});
    const Frame back = there_and_back(frame, Format::png16);
    EXPECT_NEAR(back.find("R")->samples[0], 0.25f, 1e-5);
    EXPECT_NEAR(back.find("A")->samples[0], 0.25f, 1e-5);
    EXPECT_EQ(back.find("B")->samples[0], 0.0f);
}

TEST_F(Picture, Png8GivesTheNearestCodeForEveryCode) {
    Frame frame{256, 1, {{"R", {}}, {"G", {}}, {"B", {}}}, {}};
    for (int code = 0; code < 256; ++code) {
        const double signal = code / 255.0;
        const double light =
            signal <= 0.04045 ? signal / 12.92 : std::pow((signal + 0.055) / 1.055, 2.4);
        for (Channel& channel : frame.channels) channel.samples.push_back(float(light));
    }
    expect_close(frame, Format::png8, 1e-6);
}

TEST_F(Picture, PngClampsWhatItCannotHold) {
    const Frame back = there_and_back(plain(1, 1, nan, infinity, -infinity), Format::png8);
    EXPECT_EQ(back.find("R")->samples[0], 0.0f);
    EXPECT_EQ(back.find("G")->samples[0], 1.0f);
    EXPECT_EQ(back.find("B")->samples[0], 0.0f);
    Frame frame = plain(3, 1, 0.5f, 0.5f, 0.5f);
    frame.channels.push_back({"A", {nan, 0.0f, 2.0f}});
    for (const Format format : {Format::png8, Format::png16}) {
        const Frame covered = there_and_back(frame, format);
        EXPECT_EQ(covered.find("A")->samples, (std::vector{0.0f, 0.0f, 1.0f}));
        EXPECT_EQ(covered.find("R")->samples[0], 0.0f);
        EXPECT_EQ(covered.find("R")->samples[1], 0.0f);
        EXPECT_NEAR(covered.find("R")->samples[2], 0.5f, 0.003);
    }
}

TEST_F(Picture, PngNeedsColour) {
    EXPECT_THROW(encode(varied(3, 2, {"Z"}), Format::png8), ImageError);
    EXPECT_THROW(encode(varied(3, 2, {"R", "G"}), Format::png16), ImageError);
}

TEST_F(Picture, PngLeavesOtherChannelsOut) {
    const Frame back = there_and_back(varied(3, 2, {"Z", "B", "G", "R"}), Format::png8);
    EXPECT_EQ(back.channels.size(), 3u);
}

TEST_F(Picture, ExrKeepsMetadataWithItsTypes) {
    Frame frame = plain(2, 2, 0, 0, 0);
    frame.metadata = of_every_type();
    const Metadata back = there_and_back(frame, Format::exr).metadata;
    EXPECT_EQ(back.size(), frame.metadata.size());
    for (const Entry& entry : frame.metadata) {
        ASSERT_NE(find(back, entry.name), nullptr) << entry.name;
        EXPECT_EQ(*find(back, entry.name), entry.value) << entry.name;
    }
}

TEST_F(Picture, PngKeepsMetadataAsText) {
    Frame frame = plain(2, 2, 0, 0, 0);
    frame.metadata = of_every_type();
    const Metadata back = there_and_back(frame, Format::png8).metadata;
    EXPECT_EQ(back.size(), frame.metadata.size());
    for (const Entry& entry : frame.metadata) {
        ASSERT_NE(find(back, entry.name), nullptr) << entry.name;
        EXPECT_EQ(to_text(*find(back, entry.name)), to_text(entry.value)) << entry.name;
    }
}

TEST_F(Picture, MetadataInUtf8IsKept) {
    Frame frame = plain(2, 2, 0, 0, 0);
    frame.metadata = {{"isomotion:title", "Flächen, die sich bewegen: x² + y² = 1"}};
    for (const Format format : {Format::png8, Format::exr})
        EXPECT_EQ(there_and_back(frame, format).metadata, frame.metadata);
}

TEST_F(Picture, LongMetadataIsKept) {
    Frame frame = plain(2, 2, 0, 0, 0);
    frame.metadata = {{"isomotion:scene", std::string(200'000, 'x')}};
    for (const Format format : {Format::png8, Format::exr})
        EXPECT_EQ(there_and_back(frame, format).metadata, frame.metadata);
}

TEST_F(Picture, NoMetadataIsAdded) {
    for (const Format format : {Format::png8, Format::png16, Format::exr}) {
        const Metadata metadata = there_and_back(plain(2, 2, 0, 0, 0), format).metadata;
        EXPECT_TRUE(metadata.empty()) << metadata.front().name;
    }
}

TEST_F(Picture, MetadataThatAFormatCannotHoldIsRefused) {
    Frame frame = plain(2, 2, 0, 0, 0);
    frame.metadata = {{std::string(80, 'n'), 1}};
    EXPECT_THROW(encode(frame, Format::png8), ImageError) << "libpng would cut the name";
    EXPECT_NO_THROW(encode(frame, Format::exr));
    frame.metadata = {{"FramesPerSecond", Rational{std::int64_t(1) << 40, 1}}};
    EXPECT_THROW(encode(frame, Format::exr), ImageError);
    frame.metadata = {{"", 1}};
    EXPECT_THROW(encode(frame, Format::exr), ImageError);
}

TEST_F(Picture, ADateInTheMetadataIsKept) {
    Frame frame = plain(2, 2, 0, 0, 0);
    frame.metadata = {{"DateTime", "2001:02:03 04:05:06"}};
    EXPECT_EQ(there_and_back(frame, Format::exr).metadata, frame.metadata);
}

TEST_F(Picture, BytesDoNotDependOnTheTime) {
    Frame frame = varied(40, 30, {"R", "G", "B", "A", "Z"});
    frame.metadata = of_every_type();
    const std::array formats{Format::png8, Format::png16, Format::exr};
    std::vector<std::vector<std::byte>> before;
    for (const Format format : formats) before.push_back(encode(frame, format));
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    for (std::size_t i = 0; i < formats.size(); ++i)
        EXPECT_EQ(encode(frame, formats[i]), before[i]) << "format " << i;
}

TEST_F(Picture, WideFramesAreWhole) {
    const Frame frame = varied(16384, 300, {"R", "G", "B"}); // several bands of rows
    expect_close(frame, Format::exr, 0x1p-11);
    expect_close(frame, Format::png8, 0.0045);
}

TEST_F(Picture, EveryCutIsNoticed) {
    Frame frame = varied(9, 20, {"R", "G", "B", "A"}); // EXR packs 16 rows at once
    frame.metadata = {{"frame", 1}};
    for (const Format format : {Format::png8, Format::exr}) {
        const auto file = folder_ / (format == Format::exr ? "a.exr" : "a.png");
        const std::vector<std::byte> whole = encode(frame, format);
        for (std::size_t size = 0; size < whole.size(); ++size) {
            std::ofstream(file, std::ios::binary)
                .write(reinterpret_cast<const char*>(whole.data()), std::streamsize(size));
            EXPECT_THROW(decode(file), ImageError) << size << " of " << whole.size();
        }
        base::write_whole(file, whole);
        EXPECT_NO_THROW(decode(file));
    }
}

TEST_F(Picture, WhatIsNoPictureIsNotDecoded) {
    std::ofstream(folder_ / "a.png") << "this is text";
    EXPECT_THROW(decode(folder_ / "a.png"), ImageError);
    EXPECT_THROW(decode(folder_ / "none.png"), base::FileError);
}

} // namespace
} // namespace isomotion::image
