#include "image/environment.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <sys/stat.h>

#include <gmock/gmock.h>

#include "base/file.h"
#include "base/input_error.h"
#include "image/encode.h"
#include "places.h"

namespace isomotion::image::environment_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

class EnvironmentFile : public testing::Test {
protected:
    std::filesystem::path write(const std::string& name, const Frame& frame,
                                Format format = Format::exr) const {
        base::write_whole(folder_ / name, encode(frame, format));
        return folder_ / name;
    }
    std::filesystem::path write(const std::string& name, const std::string& bytes) const {
        std::ofstream(folder_ / name, std::ios::binary) << bytes;
        return folder_ / name;
    }
    /// What is wrong with a file that is there.
    std::string mistake(const std::filesystem::path& file) const {
        try {
            read_environment(file);
        } catch (const ImageError& error) {
            return error.what();
        }
        return "nothing is wrong";
    }

    TemporaryFolder folder_;
};

std::array<float, 4> texel(const EnvironmentMap& map, int column, int row) {
    const float* at = &map.texels[std::size_t(4 * (row * map.width + column))];
    return {at[0], at[1], at[2], at[3]};
}

/// An uncompressed TIFF of 8-bit samples which names no colour space.
std::string tiff(std::uint16_t width, std::uint16_t height, std::uint16_t channels,
                 std::uint8_t value) {
    std::string bytes("II*\0", 4);
    const auto put = [&](std::uint32_t number, int size) {
        for (int k = 0; k < size; ++k) bytes += char(number >> 8 * k & 0xff);
    };
    const auto short_entry = [&](std::uint32_t tag, std::uint32_t number) {
        put(tag, 2), put(3, 2), put(1, 4), put(number, 4);
    };
    const auto long_entry = [&](std::uint32_t tag, std::uint32_t number) {
        put(tag, 2), put(4, 2), put(1, 4), put(number, 4);
    };
    constexpr std::uint32_t entries = 9, bits_at = 8 + 2 + entries * 12 + 4,
                            pixels_at = bits_at + 6;
    const std::uint32_t size = std::uint32_t(width) * height * channels;
    put(8, 4);
    put(entries, 2);
    short_entry(256, width);
    short_entry(257, height);
    put(258, 2), put(3, 2), put(channels, 4); // bits of a sample
    if (channels == 1)
        put(8, 4);
    else
        put(bits_at, 4);
    short_entry(259, 1);                     // not compressed
    short_entry(262, channels == 1 ? 1 : 2); // gray or RGB
    long_entry(273, pixels_at);
    short_entry(277, channels);
    short_entry(278, height);
    long_entry(279, size);
    put(0, 4);
    for (int k = 0; k < 3; ++k) put(8, 2);
    return bytes + std::string(size, char(value));
}

/// A TIFF of one tile, of which the header alone is there.
std::string tiff_of_tiles(std::uint32_t width, std::uint32_t tile_width, std::uint32_t tile_rows) {
    std::string bytes("II*\0", 4);
    const auto put = [&](std::uint32_t number, int size) {
        for (int k = 0; k < size; ++k) bytes += char(number >> 8 * k & 0xff);
    };
    const std::pair<std::uint32_t, std::uint32_t> entries[] = {
        {256, width}, {257, width / 2},  {258, 8},         {259, 1}, {262, 1},
        {277, 1},     {322, tile_width}, {323, tile_rows}, {324, 8}, {325, 1}};
    put(8, 4);
    put(std::uint32_t(std::size(entries)), 2);
    for (const auto& [tag, number] : entries) put(tag, 2), put(4, 2), put(1, 4), put(number, 4);
    put(0, 4);
    return bytes;
}

std::string little_endian(std::uint32_t value) {
    std::string bytes;
    for (int k = 0; k < 4; ++k) bytes += char(value >> 8 * k & 0xff);
    return bytes;
}

/// An attribute of an EXR, which says to have so many bytes.
std::string attribute_of_size(const std::string& name, const std::string& type,
                              const std::string& value, std::uint32_t size) {
    return name + '\0' + type + '\0' + little_endian(size) + value;
}
std::string attribute(const std::string& name, const std::string& type, const std::string& value) {
    return attribute_of_size(name, type, value, std::uint32_t(value.size()));
}

/// The header of an EXR of 4 x 2 pixels in tiles of this size, with further attributes.
std::string exr_of_tiles(std::uint32_t width, std::uint32_t height, const std::string& more = {}) {
    using namespace std::string_literals;
    const auto number = little_endian;
    std::string channels;
    for (const char* name : {"B", "G", "R"})
        channels += name + "\0"s + number(1) + number(0) + number(1) + number(1);
    const std::string box = number(0) + number(0) + number(3) + number(1);
    return "\x76\x2f\x31\x01"s + number(2 | 0x200) +
           attribute("channels", "chlist", channels + '\0') +
           attribute("compression", "compression", "\3") + attribute("dataWindow", "box2i", box) +
           attribute("displayWindow", "box2i", box) +
           attribute("lineOrder", "lineOrder", std::string(1, '\0')) +
           attribute("pixelAspectRatio", "float", number(0x3f800000)) +
           attribute("screenWindowCenter", "v2f", number(0) + number(0)) +
           attribute("screenWindowWidth", "float", number(0x3f800000)) +
           attribute("tiles", "tiledesc", number(width) + number(height) + '\0') + more +
           std::string(1 + 8 + 32, '\0');
}

/// Gray, 16 x 8, all coefficients 0: one scan of the mean, then scans of all others.
std::string progressive_jpeg(int scans) {
    using namespace std::string_literals;
    const auto segment = [](int marker, const std::string& bytes) {
        const std::size_t size = bytes.size() + 2;
        return "\xff"s + char(marker) + char(size >> 8) + char(size & 0xff) + bytes;
    };
    const auto one_code = [](int table, int symbol) { // of the bit 0
        return std::string(1, char(table)) + '\1' + std::string(15, '\0') + char(symbol);
    };
    std::string jpeg = "\xff\xd8" + segment(0xDB, '\0' + std::string(64, '\1')) +
                       segment(0xC2, "\x08\0\x08\0\x10\x01\x01\x11\0"s) +
                       segment(0xC4, one_code(0x00, 0)) + segment(0xC4, one_code(0x10, 0)) +
                       segment(0xDA, "\x01\x01\0\0\0\0"s) + "\x3f";
    for (int k = 1; k < scans; ++k) jpeg += segment(0xDA, "\x01\x01\0\x01\x3f\0"s) + "\x3f";
    return jpeg + "\xff\xd9";
}

std::string radiance_header(int width, int height) {
    return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) + " +X " +
           std::to_string(width) + "\n";
}

/// A Radiance picture of one colour: three mantissas over 256 and an exponent above 128.
std::string radiance(int width, int height, const std::string& rgbe) {
    std::string bytes = radiance_header(width, height);
    for (int k = 0; k < width * height; ++k) bytes += rgbe;
    return bytes;
}

/// A PNG of the gray samples 128 and 255, with one more chunk before them.
std::string png(const std::vector<unsigned char>& chunk) {
    static constexpr unsigned char head[] = {0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00,
                                             0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52, 0x00, 0x00,
                                             0x00, 0x02, 0x00, 0x00, 0x00, 0x01, 0x08, 0x00, 0x00,
                                             0x00, 0x00, 0xd1, 0x49, 0x20, 0x56};
    static constexpr unsigned char rest[] = {0x00, 0x00, 0x00, 0x0b, 0x49, 0x44, 0x41, 0x54, 0x78,
                                             0x9c, 0x63, 0x68, 0xf8, 0x0f, 0x00, 0x02, 0x02, 0x01,
                                             0x80, 0x6e, 0x56, 0x8b, 0x13, 0x00, 0x00, 0x00, 0x00,
                                             0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};
    std::string bytes(std::begin(head), std::end(head));
    bytes.append(chunk.begin(), chunk.end());
    return bytes.append(std::begin(rest), std::end(rest));
}

TEST_F(EnvironmentFile, RowsComeFromTheTop) {
    Frame frame = plain(4, 2, 0, 0, 0);
    for (std::size_t i = 0; i < 8; ++i)
        for (std::size_t c = 0; c < 3; ++c) frame.channels[c].samples[i] = float(10 * i + c);
    const EnvironmentMap map = read_environment(write("a.exr", frame));
    ASSERT_EQ(map.width, 4);
    ASSERT_EQ(map.height, 2);
    ASSERT_EQ(map.texels.size(), 32u);
    for (int i = 0; i < 8; ++i)
        EXPECT_EQ(texel(map, i % 4, i / 4),
                  (std::array{10.0f * float(i), 10.0f * float(i) + 1, 10.0f * float(i) + 2, 1.0f}));
    EXPECT_EQ(map.mended, 0);
}

TEST_F(EnvironmentFile, GrayIsWidened) {
    Frame frame{2, 1, {{"Y", {0.25f, 4.0f}}}, {}};
    const EnvironmentMap map = read_environment(write("a.exr", frame));
    EXPECT_EQ(map.texels, (std::vector{0.25f, 0.25f, 0.25f, 1.0f, 4.0f, 4.0f, 4.0f, 1.0f}));
}

TEST_F(EnvironmentFile, LargeMapsComeInBands) {
    // More than the 64 MB of rows that are decoded at once.
    constexpr int width = 4000, height = 2000;
    Frame frame = plain(width, height, 1, 2, 3);
    std::vector<float>& red = frame.channels[0].samples;
    for (std::size_t i = 0; i < red.size(); ++i) red[i] = float(i / width);
    red[0] = infinity; // becomes the largest, which is in the last row
    int bands = 0, next = 0, begun = 0;
    EnvironmentSink sink;
    sink.begin = [&](int w, int h) { begun += w == width && h == height; };
    sink.rows = [&](int first, std::span<const float> texels) {
        EXPECT_EQ(first, next);
        ASSERT_EQ(texels.size() % (4 * width), 0u);
        for (std::size_t i = 0; i < texels.size(); i += 4) {
            const auto pixel = std::size_t(first) * width + i / 4;
            const float wanted = pixel == 0 ? float(height - 1) : float(pixel / width);
            ASSERT_EQ(texels[i], wanted) << pixel;
            ASSERT_EQ(texels[i + 1], 2.0f) << pixel;
        }
        next += int(texels.size() / (4 * width));
        ++bands;
    };
    EXPECT_EQ(read_environment(write("a.exr", frame), sink, {}), 1);
    EXPECT_EQ(begun, 1);
    EXPECT_GT(bands, 1);
    EXPECT_EQ(next, height);
}

TEST_F(EnvironmentFile, OtherChannelsAreLeftOut) {
    Frame frame = plain(2, 1, 1, 2, 3);
    frame.channels.push_back({"Z", {nan, infinity}});
    frame.channels.push_back({"Y", {9, 9}});
    frame.channels.push_back({"A", {0, 0.5f}});
    const EnvironmentMap map = read_environment(write("a.exr", frame));
    EXPECT_EQ(map.texels, (std::vector<float>{1, 2, 3, 1, 1, 2, 3, 1}));
    EXPECT_EQ(map.mended, 0);
}

TEST_F(EnvironmentFile, ScreenColoursBecomeLinear) {
    const Frame frame = plain(2, 1, 0.5f, 0.002f, 1.0f);
    for (const Format format : {Format::png8, Format::png16}) {
        const EnvironmentMap map = read_environment(write("a.png", frame, format));
        const double half_code = format == Format::png8 ? 0.0045 : 0.00002;
        EXPECT_NEAR(map.texels[0], 0.5f, half_code);
        EXPECT_NEAR(map.texels[1], 0.002f, half_code);
        EXPECT_EQ(map.texels[2], 1.0f);
    }
}

TEST_F(EnvironmentFile, IntegersThatNameNoColourSpaceAreScreenColours) {
    const double linear = std::pow((188 / 255.0 + 0.055) / 1.055, 2.4);
    for (const std::uint16_t channels : {1, 3}) {
        const EnvironmentMap map = read_environment(write("a.tif", tiff(4, 2, channels, 188)));
        ASSERT_EQ(map.texels.size(), 32u);
        for (std::size_t i = 0; i < 32; ++i)
            EXPECT_NEAR(map.texels[i], i % 4 == 3 ? 1.0 : linear, 1e-6) << channels << " " << i;
    }
}

TEST_F(EnvironmentFile, AGammaIsUndone) {
    const auto read = [&](const std::vector<unsigned char>& gamma_chunk) {
        return read_environment(write("a.png", png(gamma_chunk)));
    };
    const EnvironmentMap screen = read({0x00, 0x00, 0x00, 0x04, 0x67, 0x41, 0x4d, 0x41, 0x00, 0x00,
                                        0xb1, 0x8f, 0x0b, 0xfc, 0x61, 0x05}); // 1/2.2
    EXPECT_NEAR(screen.texels[0], std::pow(128 / 255.0, 2.2), 1e-6);
    EXPECT_EQ(screen.texels[4], 1.0f);
    const EnvironmentMap linear = read({0x00, 0x00, 0x00, 0x04, 0x67, 0x41, 0x4d, 0x41, 0x00, 0x01,
                                        0x86, 0xa0, 0x31, 0xe8, 0x96, 0x5f}); // 1
    EXPECT_NEAR(linear.texels[0], 128 / 255.0, 1e-6);
}

TEST_F(EnvironmentFile, RadianceIsLinear) {
    const EnvironmentMap map =
        read_environment(write("a.hdr", radiance(4, 2, "\x80\x40\x20\x84"))); // 2^4
    EXPECT_EQ(texel(map, 3, 1), (std::array{8.0f, 4.0f, 2.0f, 1.0f}));
}

TEST_F(EnvironmentFile, WhatIsNotLightIsMendedAndCounted) {
    Frame frame = plain(4, 2, 1, 1, 1);
    const auto set = [&](std::size_t texel, float red, float green, float blue) {
        frame.channels[0].samples[texel] = red;
        frame.channels[1].samples[texel] = green;
        frame.channels[2].samples[texel] = blue;
    };
    set(0, nan, 1, 1);
    set(1, nan, -1, infinity); // one texel, however many of its samples
    set(2, 1, 1, infinity);
    set(3, -infinity, 1, 1);
    set(4, 1, -0.0f, 100);
    set(5, -nan, -nan, -nan);
    const EnvironmentMap map = read_environment(write("a.exr", frame));
    EXPECT_EQ(map.mended, 5);
    EXPECT_EQ(texel(map, 0, 0), (std::array{0.0f, 1.0f, 1.0f, 1.0f}));
    EXPECT_EQ(texel(map, 1, 0), (std::array{0.0f, 0.0f, 100.0f, 1.0f}));
    EXPECT_EQ(texel(map, 2, 0), (std::array{1.0f, 1.0f, 100.0f, 1.0f}));
    EXPECT_EQ(texel(map, 3, 0), (std::array{0.0f, 1.0f, 1.0f, 1.0f}));
    EXPECT_EQ(texel(map, 0, 1), (std::array{1.0f, 0.0f, 100.0f, 1.0f}));
    EXPECT_EQ(texel(map, 1, 1), (std::array{0.0f, 0.0f, 0.0f, 1.0f}));
    EXPECT_EQ(texel(map, 2, 1), (std::array{1.0f, 1.0f, 1.0f, 1.0f}));
}

TEST_F(EnvironmentFile, InfinityAloneBecomesTheLargestHalf) {
    for (const float other : {0.0f, -3.0f, nan}) {
        Frame frame = plain(2, 1, other, other, other);
        frame.channels[1].samples[0] = infinity;
        const EnvironmentMap map = read_environment(write("a.exr", frame));
        EXPECT_EQ(map.texels, (std::vector{0.0f, 65504.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f}));
        EXPECT_EQ(map.mended, other == 0.0f ? 1 : 2);
    }
}

TEST_F(EnvironmentFile, MendingTellsHowMany) {
    EXPECT_THAT(mending("a.exr", 12), StartsWith("environment a.exr: 12 texels were not finite"));
    EXPECT_THAT(mending("a.exr", 1), StartsWith("environment a.exr: 1 texel was not finite"));
}

TEST_F(EnvironmentFile, MissingFilesAndFoldersAreTheFileSystems) {
    EXPECT_THROW(read_environment(folder_ / "none.exr"), base::FileError);
    EXPECT_THROW(read_environment(folder_.path()), base::FileError);
}

/// Whatever the file is: it is asked before a byte of it is read.
TEST_F(EnvironmentFile, LiesInItsConfines) {
    const auto file = write("a.exr", plain(2, 1, 1, 2, 3));
    const auto read = [&](const std::filesystem::path& folder) {
        int width = 0;
        const EnvironmentSink sink{[&](int is, int) { width = is; },
                                   [](int, std::span<const float>) {}};
        read_environment(file, sink, base::Confines({folder}, "lies outside"));
        return width;
    };
    EXPECT_EQ(read(*base::place_of(base::open_folder(folder_.path()))), 2);
    const auto refusal = file.string() + " lies outside";
    EXPECT_THAT([&] { read(folder_ / "below"); },
                testing::ThrowsMessage<base::InputError>(testing::StrEq(refusal)));
    write("a.exr", std::string("no picture"));
    EXPECT_THROW(read(folder_ / "below"), base::InputError);
}

TEST_F(EnvironmentFile, WhatIsNoPictureIsRefused) {
    for (const char* name : {"a.exr", "a.hdr", "a.png", "a.jpg", "a.tif", "a", "a.xyz"}) {
        for (const char* text : {"", "this is text\n"}) {
            const auto file = write(name, std::string(text));
            EXPECT_THAT(mistake(file),
                        AllOf(StartsWith("environment " + file.string() + ": not a picture"),
                              HasSubstr("EXR, HDR, TIFF, PNG or JPEG")))
                << name;
        }
    }
}

/// Readers of video and of playlists open what a file names, and others read no file at all.
TEST_F(EnvironmentFile, OnlyFiveFormatsAreOpened) {
    const std::string texts[] = {
        "#EXTM3U\n#EXTINF:1,\n/tmp/other.mp4\n",
        "ffconcat version 1.0\nfile /tmp/other.mp4\n",
        std::string("\0\0\0\x18"
                    "ftypmp42",
                    12),
        "SDPX" + std::string(8188, '\0'),
        "\x01\xda" + std::string(510, '\0'),
        "GIF89a" + std::string(100, '\0'),
        "",
    };
    for (const char* name : {"a.mp4", "a.mov", "a.avi", "a.mpg", "a.3gp", "a.exr", "a.png", "a.gif",
                             "a.dpx", "a.sgi", "a.null?RES=8192x4096&CHANNELS=8"})
        for (const std::string& text : texts)
            EXPECT_THAT(mistake(write(name, text)), HasSubstr("EXR, HDR, TIFF, PNG and JPEG are"))
                << name << ": " << text.substr(0, 8);
}

TEST_F(EnvironmentFile, TheNameSaysNothing) {
    const Frame frame = plain(2, 1, 1, 2, 3);
    for (const char* name : {"a.mp4", "a.png", "a.null?RES=8192x4096", "a"})
        EXPECT_EQ(read_environment(write(name, frame)).texels[1], 2.0f) << name;
}

TEST_F(EnvironmentFile, LimitsAreToldBeforeAnythingIsDecoded) {
    const auto sparse = write("a.exr", std::string("\x76\x2f\x31\x01"));
    std::filesystem::resize_file(sparse, std::uintmax_t(3) << 30);
    EXPECT_THAT(mistake(sparse), HasSubstr("has more than 256 MB"));
    EXPECT_THAT(mistake(write("a.tif", tiff_of_tiles(8192, 8192, 16384))),
                HasSubstr("tiles of 8192 x 16384 pixels in a picture 8192 wide"));
    // Readers take memory for whole tiles, that of EXR as it opens a file.
    EXPECT_THAT(mistake(write("a.tif", tiff_of_tiles(4, 65536, 16384))),
                HasSubstr("tiles of 65536 x 16384 pixels; sides of 1 to 16384"));
    EXPECT_THAT(mistake(write("a.tif", tiff_of_tiles(4, 16384, 16384))),
                HasSubstr("tiles of 16384 x 16384 pixels in a picture 4 wide; a row of tiles may "
                          "take 256 MB"));
    EXPECT_THAT(mistake(write("a.exr", exr_of_tiles(65536, 4096))),
                HasSubstr("tiles of 65536 x 4096 pixels; sides of 1 to 16384"));
    EXPECT_THAT(mistake(write("a.exr", exr_of_tiles(16384, 16384))),
                HasSubstr("tiles of 16384 x 16384 pixels in a picture 4 wide"));
    Frame many = plain(2, 1, 0, 0, 0);
    for (int k = 3; k < 17; ++k) many.channels.push_back({std::to_string(k), {0, 0}});
    EXPECT_THAT(mistake(write("a.exr", many)), HasSubstr("17 channels; 1 to 16"));
}

// OpenEXR takes the memory first, and OpenImageIO a time that grows with the attributes' square.
TEST_F(EnvironmentFile, AttributesOfAnExrAreFollowedBeforeItIsOpened) {
    const auto told = [&](const std::string& more) {
        return mistake(write("a.exr", exr_of_tiles(4, 2, more)));
    };
    EXPECT_THAT(told(attribute_of_size("comments", "string", "few", 0x7fffffff)),
                HasSubstr("its header's attribute 'comments' says 2147483647 bytes, and the file "
                          "has 44 more"));
    EXPECT_THAT(told(attribute_of_size("who", "else", "", 0xffffffff)),
                HasSubstr("'who' says 4294967295 bytes"));
    // A preview of 2^31 pixels, and values that would hide what comes behind them.
    EXPECT_THAT(told(attribute("preview", "preview",
                               little_endian(0x10000) + little_endian(0x8000) + "12345678")),
                HasSubstr("'preview' says 16 bytes, which is no size of its type"));
    EXPECT_THAT(told(attribute("extent", "float", "12345678")),
                HasSubstr("'extent' says 8 bytes, which is no size of its type"));
    EXPECT_THAT(told(attribute("more", "chlist", std::string(30, '\0'))),
                HasSubstr("'more' says 30 bytes, which is no size of its type"));
    EXPECT_THAT(told(std::string(300, 'x')), HasSubstr("its header is broken or cut short"));

    std::string many;
    for (int k = 0; k < 1500; ++k) many += attribute("a" + std::to_string(k), "int", "1234");
    EXPECT_THAT(told(many), testing::Not(HasSubstr("its header")));
    for (int k = 1500; k < 2000; ++k) many += attribute("a" + std::to_string(k), "int", "1234");
    EXPECT_THAT(told(many), HasSubstr("more than 2000 attributes in its header"));
    EXPECT_THAT(told(attribute("long", "string", std::string((16 << 20) + 1, 'x'))),
                HasSubstr("a header of more than 16 MB"));
}

// libpng unpacks each of them before the first row, up to 8 MB.
TEST_F(EnvironmentFile, PackedChunksAreCounted) {
    const auto with = [&](int count, const std::string& type) {
        const std::string one = std::string("\0\0\0\4", 4) + type + "text" + "csum";
        std::vector<unsigned char> chunks;
        for (int k = 0; k < count; ++k) chunks.insert(chunks.end(), one.begin(), one.end());
        return mistake(write("a.png", png(chunks)));
    };
    for (const char* type : {"zTXt", "iTXt", "iCCP"}) {
        EXPECT_THAT(with(65, type),
                    HasSubstr("65 chunks of packed text or profiles in a PNG; at most 64"));
        EXPECT_THAT(with(64, type), testing::Not(HasSubstr("chunks")));
    }
    EXPECT_THAT(with(500, "tEXt"), testing::Not(HasSubstr("chunks")));
}

// libjpeg goes over all scans before it gives the first row.
TEST_F(EnvironmentFile, ScansAreCounted) {
    EXPECT_THAT(mistake(write("a.jpg", progressive_jpeg(101))),
                HasSubstr("101 scans of a progressive JPEG; at most 100 are read"));
    for (const int scans : {1, 10, 100}) {
        EXPECT_EQ(read_environment(write("a.jpg", progressive_jpeg(scans))).width, 16) << scans;
    }
}

TEST_F(EnvironmentFile, APipeIsNotWaitedFor) {
    const auto pipe = folder_ / "a.exr";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_THROW(read_environment(pipe), base::FileError);
    EXPECT_THROW(read_environment("/dev/zero"), base::FileError);
}

TEST_F(EnvironmentFile, EveryCutIsNoticed) {
    const std::vector<std::byte> whole = encode(plain(8, 4, 1, 2, 3), Format::exr);
    for (std::size_t size = 0; size < whole.size(); ++size) {
        base::write_whole(folder_ / "a.exr", std::span(whole).first(size));
        EXPECT_THROW(read_environment(folder_ / "a.exr"), ImageError) << size;
    }
}

TEST_F(EnvironmentFile, NoColour) {
    const auto file = write("a.exr", Frame{2, 1, {{"R", {0, 0}}, {"Z", {0, 0}}}, {}});
    EXPECT_THAT(mistake(file), AllOf(StartsWith("environment " + file.string() + ": no colour"),
                                     HasSubstr("and has R, Z")));
}

TEST_F(EnvironmentFile, OtherShapesAreOtherProjections) {
    for (const auto& [width, height] :
         {std::pair{2, 2}, {3, 1}, {1, 1}, {1, 2}, {5, 2}, {4, 1}, {16, 12}, {8193, 1}}) {
        const auto file = write("a.exr", plain(width, height, 0, 0, 0));
        EXPECT_THAT(mistake(file),
                    HasSubstr(std::to_string(width) + " x " + std::to_string(height) + " pixels; "))
            << width << " x " << height;
    }
    EXPECT_THAT(mistake(write("a.exr", plain(9, 4, 0, 0, 0))), HasSubstr("--resize 8x4"));
    EXPECT_THAT(mistake(write("a.exr", plain(1, 1, 0, 0, 0))), HasSubstr("--resize 2x1"));
}

/// A header alone: a map of this size is refused before its pixels are looked for.
TEST_F(EnvironmentFile, TooWide) {
    const auto file = write("a.hdr", radiance_header(16384, 8192));
    EXPECT_THAT(mistake(file),
                AllOf(HasSubstr("16384 pixels wide; at most 8192"),
                      HasSubstr("oiiotool " + file.string() + " --resize 8192x4096 smaller.hdr")));
}

/// The map that comes with the program. A pixel that mirrors all of it is not white: its mean is
/// below what is shown as white.
TEST(Studio, IsAMapWithBrightLights) {
    const EnvironmentMap map = read_environment(ISOMOTION_SOURCE_DIR "/media/studio.exr");
    EXPECT_EQ(map.width, 256);
    EXPECT_EQ(map.mended, 0);
    const float brightest = *std::ranges::max_element(map.texels);
    EXPECT_GT(brightest, 5.0f);
    EXPECT_LT(brightest, 10.0f);
    // Rows are as wide as the cosine of their latitude.
    double sum = 0, weights = 0;
    for (int row = 0; row < map.height; ++row) {
        const double weight = std::sin((row + 0.5) * std::numbers::pi / map.height);
        for (int column = 0; column < map.width; ++column) {
            const auto light = texel(map, column, row);
            sum += weight * (light[0] + light[1] + light[2]) / 3;
            weights += weight;
        }
    }
    EXPECT_LT(sum / weights, 0.95);
    EXPECT_GT(sum / weights, 0.5);
    EXPECT_LT(std::filesystem::file_size(ISOMOTION_SOURCE_DIR "/media/studio.exr"), 150'000u);
    const auto floor = texel(map, 10, 120), ceiling = texel(map, 10, 5);
    EXPECT_GT(floor[0], floor[2]);
    EXPECT_LT(ceiling[0], ceiling[2]);
}

} // namespace
} // namespace isomotion::image::environment_test
