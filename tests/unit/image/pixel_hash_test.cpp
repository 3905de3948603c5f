#include "image/pixel_hash.h"

#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "base/file.h"
#include "image/decode.h"
#include "image/encode.h"
#include "places.h"

namespace isomotion::image {
namespace {

std::span<const std::byte> bytes_of(std::string_view text) {
    return std::as_bytes(std::span(text));
}

// As xxh128sum prints them.
TEST(ContentHash, IsThatOfXxhash) {
    EXPECT_EQ(base::content_hash({}), "99aa06d3014798d86001c324468d497f");
    EXPECT_EQ(base::ContentHash().add(bytes_of("iso")).add(bytes_of("motion")).text(),
              base::content_hash(bytes_of("isomotion")));
    EXPECT_NE(base::ContentHash().add("iso").add("motion").text(),
              base::ContentHash().add("isom").add("otion").text());
}

/// Any bits at all: every NaN, infinities, values that lie between two halves.
float any_float(std::mt19937& random) {
    switch (random() % 4) {
    case 0:
        return std::bit_cast<float>(std::uint32_t(random()));
    case 1:
        return float(random() % 1000) / 999.0f;
    case 2: // half way between two halves, subnormal ones too
        return std::ldexp(float(random() % 4096), int(random() % 40) - 26);
    default:
        return std::numeric_limits<float>::quiet_NaN();
    }
}

Frame any_frame(std::mt19937& random, int width, int height, std::vector<std::string> names) {
    Frame frame{width, height, {}, {}};
    for (const std::string& name : names) {
        Channel channel{name, {}};
        for (int i = 0; i < width * height; ++i) channel.samples.push_back(any_float(random));
        frame.channels.push_back(std::move(channel));
    }
    return frame;
}

class PixelHashTest : public testing::Test {
protected:
    const unsigned seed_ = std::random_device{}();
    testing::ScopedTrace trace_{__FILE__, __LINE__, std::to_string(seed_)};
    std::mt19937 random_{seed_};
    TemporaryFolder folder_;
};

TEST_F(PixelHashTest, OfWhatIsWrittenIsThatOfWhatIsRead) {
    const std::vector<std::string> opaque{"R", "G", "B"}, covered{"R", "G", "B", "A"},
        all{"R", "G", "B", "A", "Z", "N.X", "N.Y", "verdict"};
    for (int round = 0; round < 12; ++round) {
        const int width = 1 + int(random_() % 40), height = 1 + int(random_() % 300);
        for (const auto& [format, names] : {std::pair{Format::png8, opaque},
                                            {Format::png8, covered},
                                            {Format::png16, covered},
                                            {Format::exr, all}}) {
            const Frame frame = any_frame(random_, width, height, names);
            const auto file = folder_ / (format == Format::exr ? "a.exr" : "a.png");
            const Encoded encoded = encode_with_hash(frame, format);
            EXPECT_EQ(encoded.bytes, encode(frame, format));
            base::write_whole(file, encoded.bytes);
            EXPECT_EQ(pixel_hash(file), encoded.pixels) << name(format) << names.size();
        }
    }
}

TEST_F(PixelHashTest, ForgetsMetadataAndSeesEveryPixel) {
    Frame frame = plain(5, 4, 0.2f, 0.4f, 0.6f);
    for (const Format format : {Format::png8, Format::png16, Format::exr}) {
        std::set<std::string> hashes;
        frame.metadata = {};
        const std::string first = encode_with_hash(frame, format).pixels;
        hashes.insert(first);
        frame.metadata = {{"isomotion:frame", 7}};
        EXPECT_EQ(encode_with_hash(frame, format).pixels, first);
        for (Channel& channel : frame.channels) {
            for (float& sample : channel.samples) {
                const float before = std::exchange(sample, 0.9f);
                EXPECT_TRUE(hashes.insert(encode_with_hash(frame, format).pixels).second);
                sample = before;
            }
        }
        EXPECT_TRUE(
            hashes.insert(encode_with_hash(plain(4, 5, 0.2f, 0.4f, 0.6f), format).pixels).second);
    }
}

} // namespace
} // namespace isomotion::image
