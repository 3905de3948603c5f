#include "sequence/movies/movie.h"

#include <cstdio>
#include <memory>
#include <random>

#include "base/file.h"
#include "image/encode.h"
#include "unit/image/places.h"

namespace isomotion::sequence {
namespace {

/// What a command of the shell prints.
std::string output_of(const std::string& command) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(::popen(command.c_str(), "r"),
                                                               ::pclose);
    std::string text;
    for (int c; (c = std::fgetc(pipe.get())) != EOF;) text.push_back(char(c));
    return text;
}

class Movie : public testing::Test {
protected:
    /// PNGs of one colour each, getting brighter.
    void make_pictures(int count, int width, int height) {
        pictures_.clear();
        for (int i = 0; i < count; ++i) {
            const float light = float(i + 1) / float(count);
            pictures_.push_back(folder_ / ("p" + std::to_string(i) + ".png"));
            base::write_whole(
                pictures_.back(),
                image::encode(image::plain(width, height, light, 0.2f, 0.0f), image::Format::png8));
        }
    }
    /// "width,height,rate,frames" as ffprobe sees them.
    std::string probed(const std::string& name) const {
        return output_of("ffprobe -v error -count_frames -select_streams v:0 -show_entries "
                         "stream=width,height,r_frame_rate,nb_read_frames -of csv=p=0 " +
                         (folder_ / name).string());
    }
    void expect_nothing_made() const {
        for (const std::string& name : folder_.names())
            EXPECT_TRUE(name.ends_with(".png") || name == "ffmpeg") << name;
    }
    std::string message(const std::string& name, image::Rational rate = {30, 1}) {
        try {
            write_movie(folder_ / name, pictures_, rate);
        } catch (const Error& error) {
            return error.what();
        }
        return "no error";
    }
    /// A program named ffmpeg that does what the script says.
    void make_ffmpeg(const std::string& script) {
        std::ofstream(folder_ / "ffmpeg") << "#!/bin/sh\n" << script << "\n";
        std::filesystem::permissions(folder_ / "ffmpeg", std::filesystem::perms::owner_all);
    }

    base::TemporaryFolder folder_;
    std::vector<std::filesystem::path> pictures_;
};

/// The tests that need the true ffmpeg.
class RealMovie : public Movie {
protected:
    void SetUp() override {
        if (std::system("ffmpeg -version >/dev/null 2>&1 && ffprobe -version >/dev/null 2>&1"))
            GTEST_SKIP() << "ffmpeg and ffprobe are not installed";
    }
};

TEST_F(RealMovie, HasEveryFrameInEachFormat) {
    make_pictures(7, 64, 48);
    for (const std::string name : {"m.mp4", "m.webm", "m.gif"}) {
        write_movie(folder_ / name, pictures_, {25, 1});
        EXPECT_EQ(probed(name), "64,48,25/1,7\n") << name;
        EXPECT_FALSE(folder_.names().contains(".m.part" + name.substr(1)));
    }
}

TEST_F(RealMovie, OddSizesAreMadeEvenOnlyWhereNeeded) {
    make_pictures(2, 33, 17);
    for (const std::string name : {"m.mp4", "m.webm"}) {
        write_movie(folder_ / name, pictures_, {30000, 1001});
        EXPECT_EQ(probed(name), "34,18,30000/1001,2\n") << name;
    }
    write_movie(folder_ / "m.gif", pictures_, {10, 1});
    EXPECT_TRUE(probed("m.gif").starts_with("33,17,")) << probed("m.gif");
    EXPECT_TRUE(probed("m.gif").ends_with(",2\n")) << probed("m.gif");
}

TEST_F(RealMovie, TheSmallestPictureWorks) {
    make_pictures(1, 1, 1);
    for (const std::string name : {"m.mp4", "m.webm", "m.gif"})
        EXPECT_NO_THROW(write_movie(folder_ / name, pictures_, {30, 1})) << name;
}

TEST_F(RealMovie, ColoursComeBack) {
    make_pictures(1, 64, 64);
    base::write_whole(pictures_[0],
                      image::encode(image::plain(64, 64, 0.8f, 0.3f, 0.05f), image::Format::png16));
    // 0.8, 0.3 and 0.05 as sRGB bytes
    const int expected[] = {231, 149, 63};
    for (const std::string name : {"m.mp4", "m.webm", "m.gif"}) {
        write_movie(folder_ / name, pictures_, {30, 1});
        const std::string pixels = output_of("ffmpeg -v error -i " + (folder_ / name).string() +
                                             " -f rawvideo -pix_fmt rgb24 -");
        ASSERT_EQ(pixels.size(), 64u * 64u * 3u) << name;
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(int(static_cast<unsigned char>(pixels[c])), expected[c], 3) << name;
    }
}

TEST_F(RealMovie, SameBytesAgain) {
    make_pictures(5, 50, 40);
    for (const std::string name : {"m.mp4", "m.webm", "m.gif"}) {
        write_movie(folder_ / name, pictures_, {30, 1});
        const auto before = base::read_whole(folder_ / name);
        write_movie(folder_ / name, pictures_, {30, 1});
        EXPECT_EQ(base::read_whole(folder_ / name), before) << name;
    }
}

TEST_F(RealMovie, PicturesThatAreDrawnGiveTheBytesOfTheirFiles) {
    make_pictures(4, 20, 10);
    write_movie(folder_ / "files.mp4", pictures_, {30, 1});
    std::vector<std::size_t> asked;
    const MoviePictures drawn{
        pictures_.size(),
        [&](std::size_t i) {
            asked.push_back(i);
            return image::plain(20, 10, float(i + 1) / 4, 0.2f, 0.0f);
        },
        [](std::size_t i) { return "frame " + std::to_string(i); },
    };
    write_movie(folder_ / "drawn.mp4", drawn, {30, 1});
    EXPECT_EQ(asked, (std::vector<std::size_t>{0, 1, 2, 3}));
    EXPECT_EQ(base::read_whole(folder_ / "drawn.mp4"), base::read_whole(folder_ / "files.mp4"));
}

TEST_F(RealMovie, UnusualNamesAreNames) {
    make_pictures(1, 8, 8);
    for (const std::string name : {"-y.mp4", "a%03d:b c'd.mp4", "A.MP4"}) {
        write_movie(folder_ / name, pictures_, {30, 1});
        EXPECT_TRUE(folder_.names().contains(name));
    }
}

TEST_F(RealMovie, AFullDiskIsReportedAndLeavesNothing) {
    image::Frame noise = image::plain(320, 240, 0, 0, 0);
    std::minstd_rand random;
    for (image::Channel& channel : noise.channels)
        for (float& sample : channel.samples) sample = float(random() % 1000) / 1000.0f;
    pictures_.assign(5, folder_ / "noise.png");
    base::write_whole(pictures_[0], image::encode(noise, image::Format::png8));

    const base::TemporaryFolder small;
    const base::Disk disk(small, 0, "size=16k");
    if (!disk) GTEST_SKIP() << "no right to mount a small disk";
    for (const std::string name : {"m.mp4", "m.webm", "m.gif"}) {
        try {
            write_movie(small / name, pictures_, {30, 1});
            ADD_FAILURE() << name;
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find("No space left"), std::string::npos);
        }
        EXPECT_TRUE(small.names().empty()) << name;
    }
}

TEST_F(RealMovie, PicturesMustHaveOneSize) {
    make_pictures(2, 8, 8);
    base::write_whole(pictures_[1],
                      image::encode(image::plain(8, 9, 0, 0, 0), image::Format::png8));
    EXPECT_NE(message("m.mp4").find("is 8 x 9, but the movie's first picture is 8 x 8"),
              std::string::npos);
    expect_nothing_made();
}

TEST_F(RealMovie, ABrokenPictureStopsIt) {
    make_pictures(3, 8, 8);
    std::filesystem::resize_file(pictures_[2], 60);
    EXPECT_THROW(write_movie(folder_ / "m.mp4", pictures_, {30, 1}), image::ImageError);
    expect_nothing_made();
}

TEST_F(RealMovie, IsStopped) {
    make_pictures(3, 8, 8);
    for (int asked_before = 0; asked_before < 6; ++asked_before) {
        int asked = 0;
        const bool done = write_movie(folder_ / "m.mp4", pictures_, {30, 1},
                                      [&] { return asked++ >= asked_before; });
        EXPECT_FALSE(done) << asked_before;
        expect_nothing_made();
    }
    EXPECT_TRUE(write_movie(folder_ / "m.mp4", pictures_, {30, 1}, [] { return false; }));
}

TEST_F(RealMovie, AMissingFolderIsReported) {
    make_pictures(1, 8, 8);
    EXPECT_THROW(write_movie(folder_ / "none/m.mp4", pictures_, {30, 1}), base::FileError);
}

TEST_F(Movie, UnknownExtensionListsTheKnownOnes) {
    make_pictures(1, 8, 8);
    for (const std::string name : {"m.avi", "m"})
        EXPECT_NE(message(name).find(".mp4, .webm or .gif"), std::string::npos);
}

TEST_F(Movie, RatesAndListsMustMakeSense) {
    make_pictures(1, 8, 8);
    for (const image::Rational rate :
         {image::Rational{0, 1}, {-30, 1}, {30, 0}, {30, -1}, {2'000, 1}})
        EXPECT_NE(message("m.mp4", rate).find("frames per second"), std::string::npos);
    EXPECT_NE(message("m.gif", {60, 1}).find("up to 50"), std::string::npos);
    pictures_.clear();
    EXPECT_NE(message("m.mp4").find("at least one picture"), std::string::npos);
}

TEST_F(Movie, AMissingFfmpegIsNamed) {
    make_pictures(1, 8, 8);
    for (const std::string& path : {std::string(), folder_.path().string()}) {
        const base::Environment environment("PATH", path);
        EXPECT_EQ(message("m.mp4"),
                  "ffmpeg is not on PATH: install it with apt-get install ffmpeg");
    }
    expect_nothing_made();
}

TEST_F(Movie, AFailingFfmpegHasTheLastWord) {
    make_pictures(1, 8, 8);
    make_ffmpeg("cat >/dev/null; for i in 1 2 3 4 5 6 7; do echo line $i >&2; done; exit 3");
    const base::Environment environment("PATH", folder_.path().string() + ":/usr/bin:/bin");
    const std::string text = message("m.mp4");
    EXPECT_NE(text.find("exit status 3"), std::string::npos) << text;
    EXPECT_TRUE(text.ends_with(": line 3\nline 4\nline 5\nline 6\nline 7")) << text;
    expect_nothing_made();
}

TEST_F(Movie, AnFfmpegThatDiesDoesNotTakeUsWithIt) {
    make_pictures(3, 1024, 1024); // more than the socket holds
    for (const std::string script : {"exit 0", "exit 1", "kill -9 $$"}) {
        make_ffmpeg(script);
        const base::Environment environment("PATH", folder_.path().string());
        EXPECT_NE(message("m.mp4").find("ffmpeg failed"), std::string::npos) << script;
        expect_nothing_made();
    }
}

} // namespace
} // namespace isomotion::sequence
