#include "sequence/movies/movie.h"

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/child_process.h"
#include "base/extension.h"
#include "base/partial_file.h"
#include "image/decode.h"
#include "image/srgb.h"

namespace isomotion::sequence {
namespace {

using Words = std::vector<std::string>;

struct Container {
    const char* name; // as ffmpeg calls it
    bool even_size;   // colour is stored for blocks of 2 x 2 pixels
    int most_frames_per_second;
    Words encoding;
};

// Left to itself, ffmpeg converts with the matrix of standard definition whatever the size, and
// players then show other colours for large movies. The tags say what was done.
const std::string to_yuv420 = "scale=out_color_matrix=bt709:out_range=tv:"
                              "flags=bicubic+accurate_rnd+full_chroma_int+bitexact,"
                              "format=yuv420p";
const Words yuv420 = {
    // clang-format off
    "-vf", to_yuv420, "-color_range", "tv", "-colorspace", "bt709",
    "-color_primaries", "bt709", "-color_trc", "iec61966-2-1",
    // clang-format on
};

// Encoders divide the work by their number of threads, and the bytes follow that division: a fixed
// number gives the same bytes whatever the number of cores.
const Words threads = {"-threads", "4"};

const Words h264 = {"-c:v", "libx264", "-crf", "16", "-movflags", "+faststart"};

const Words vp9 = {"-c:v",    "libvpx-vp9", "-crf",      "20",   "-b:v",      "0",
                   "-row-mt", "0",          "-deadline", "good", "-cpu-used", "2"};

const Words gif = {"-filter_complex", "split[a][b];[a]palettegen[p];[b][p]paletteuse", "-loop",
                   "0"};

Words joined(std::initializer_list<Words> parts) {
    Words words;
    for (const Words& part : parts) words.insert(words.end(), part.begin(), part.end());
    return words;
}

Container container_of(const std::filesystem::path& movie) {
    const std::string extension = base::lower_extension(movie);
    if (extension == ".mp4") return {"mp4", true, 1000, joined({yuv420, threads, h264})};
    if (extension == ".webm") return {"webm", true, 1000, joined({yuv420, threads, vp9})};
    // Delays count hundredths of a second, and browsers play a delay of 1 at a tenth of the speed.
    if (extension == ".gif") return {"gif", false, 50, gif};
    throw Error(Error::Code::input,
                fmt::format("{}: a movie's name ends in .mp4, .webm or .gif", movie.string()));
}

void check_rate(const std::filesystem::path& movie, const Container& container,
                image::Rational rate) {
    // In double: the product of two 64-bit integers may overflow.
    const double rounded = double(rate.numerator) / double(rate.denominator);
    if (rate.numerator < 1 || rate.denominator < 1 || rounded > container.most_frames_per_second)
        throw Error(Error::Code::input,
                    fmt::format("{}: {} frames per second; {} takes more than 0 and up to {}",
                                movie.string(), image::to_text(rate), container.name,
                                container.most_frames_per_second));
}

struct Size {
    int width;
    int height;

    bool operator==(const Size&) const = default;
};

int to_even(int length) { return length + length % 2; }

// The picture as the screen's red, green and blue bytes, at a size that may exceed its own by one.
std::vector<std::byte> screen_bytes(const image::Frame& frame, Size size) {
    const image::ColourPlanes planes = image::colour_planes(frame);
    std::vector<std::byte> bytes;
    bytes.reserve(3 * std::size_t(size.width) * std::size_t(size.height));
    for (int y = 0; y < size.height; ++y) {
        const std::size_t row =
            std::size_t(std::min(y, frame.height - 1)) * std::size_t(frame.width);
        for (int x = 0; x < size.width; ++x) {
            const std::size_t pixel = row + std::size_t(std::min(x, frame.width - 1));
            for (const float* plane : {planes.red, planes.green, planes.blue})
                bytes.push_back(std::byte{image::srgb8().code(plane[pixel])});
        }
    }
    return bytes;
}

Words command(const Container& container, Size size, image::Rational rate,
              const std::filesystem::path& file) {
    return joined({{"-hide_banner", "-nostats", "-loglevel", "error", "-y"},
                   {"-f", "rawvideo", "-pixel_format", "rgb24"},
                   {"-video_size", fmt::format("{}x{}", size.width, size.height)},
                   {"-framerate", image::to_text(rate)},
                   {"-i", "pipe:0"},
                   container.encoding,
                   {"-map_metadata", "-1", "-fflags", "+bitexact", "-flags:v", "+bitexact"},
                   // The prefix keeps ffmpeg from reading a protocol or a pattern into the name.
                   {"-f", container.name, "file:" + file.string()}});
}

std::filesystem::path ffmpeg() {
    const auto found = base::find_program("ffmpeg");
    if (!found)
        throw Error(Error::Code::device,
                    "ffmpeg is not on PATH: install it with apt-get install ffmpeg");
    return *found;
}

} // namespace

void check_movie(const std::filesystem::path& movie, image::Rational frames_per_second) {
    check_rate(movie, container_of(movie), frames_per_second);
}

void expect_ffmpeg() { ffmpeg(); }

bool write_movie(const std::filesystem::path& movie, const MoviePictures& pictures,
                 image::Rational frames_per_second, const std::function<bool()>& stop) {
    const Container container = container_of(movie);
    check_rate(movie, container, frames_per_second);
    if (pictures.count == 0)
        throw Error(Error::Code::input, movie.string() + ": a movie needs at least one picture");
    const std::filesystem::path program = ffmpeg();

    image::Frame frame = pictures.picture(0);
    const Size size{frame.width, frame.height};
    const Size shown = container.even_size ? Size{to_even(size.width), to_even(size.height)} : size;

    base::PartialFile partial(movie);
    base::ChildProcess encoder(program,
                               command(container, shown, frames_per_second, partial.path()));
    bool fed = true;
    const auto stopped = [&] { return stop && stop(); };
    for (std::size_t i = 0; fed && i < pictures.count; ++i) {
        if (stopped()) return false;
        if (i > 0) frame = pictures.picture(i);
        if (Size{frame.width, frame.height} != size)
            throw Error(Error::Code::input,
                        fmt::format("{}: is {} x {}, but the movie's first picture is {} x {}",
                                    pictures.name(i), frame.width, frame.height, size.width,
                                    size.height));
        fed = encoder.feed(screen_bytes(frame, shown), stopped);
    }
    // Words are an error even with status 0: ffmpeg 5.1 ends like this when the disk fills up while
    // it writes the last of a file. It is asked for errors only.
    const bool ended_well = encoder.finish_unless(stopped);
    if (stopped()) return false; // a terminal's Ctrl-C reaches ffmpeg too
    const std::string words = encoder.last_words(5);
    if (!ended_well || !fed || !words.empty())
        throw Error(Error::Code::file, fmt::format("{}: ffmpeg failed ({}): {}", movie.string(),
                                                   encoder.ending(), words));
    partial.publish();
    return true;
}

bool write_movie(const std::filesystem::path& movie,
                 std::span<const std::filesystem::path> pictures, image::Rational frames_per_second,
                 const std::function<bool()>& stop) {
    const MoviePictures files{
        pictures.size(),
        [pictures](std::size_t i) { return image::decode(pictures[i]); },
        [pictures](std::size_t i) { return pictures[i].string(); },
    };
    return write_movie(movie, files, frames_per_second, stop);
}

} // namespace isomotion::sequence
