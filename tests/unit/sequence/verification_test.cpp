#include "sequence/verification.h"

#include <fstream>
#include <numeric>
#include <span>

#include "animation/frame_range.h"
#include "records.h"
#include "sequence/manifest_json.h"

namespace isomotion::sequence {
namespace {

namespace fs = std::filesystem;

class VerificationTest : public Recorded {
protected:
    VerificationTest() { write_all(recording_, 3); }

    const ManifestWriter recording_{name(), some_sequence()};
};

TEST_F(VerificationTest, AWholeSequence) {
    const Verification found = verify(manifest(), {.pixels = true});
    EXPECT_TRUE(found.is_whole());
    EXPECT_EQ(found.whole, (std::vector{1, 2, 3}));
    EXPECT_EQ(found.verdicts[0], 21);
    EXPECT_EQ(found.verdicts[1], 15);
    EXPECT_EQ(found.evaluations, 300);
    EXPECT_EQ(found.drawing, 0.75);
}

TEST_F(VerificationTest, FindsWhatIsWrong) {
    fs::remove(name().path(1));
    EXPECT_EQ(verify(manifest()).missing, std::vector{1});
    fs::resize_file(name().path(2), 20);
    EXPECT_EQ(verify(manifest()).changed, std::vector{2});
    fs::remove(frame_file(manifest(), 3));
    EXPECT_EQ(verify(manifest()).unrecorded, std::vector{3});
    EXPECT_FALSE(verify(manifest()).is_whole());
    EXPECT_TRUE(verify(manifest()).whole.empty());
}

TEST_F(VerificationTest, ARecordOfAnotherFile) {
    FrameRecord record = write(2);
    record.file = "a.0003.png";
    recording_.record(record);
    EXPECT_EQ(verify(manifest()).unrecorded, std::vector{2});
    EXPECT_FALSE(verify(manifest()).is_whole());
}

TEST_F(VerificationTest, NothingWasAskedFor) {
    for (int frame = 1; frame <= 3; ++frame) fs::remove(name().path(frame));
    const std::string text = to_json(some_sequence({}));
    base::write_whole(sequence_file(manifest()), std::as_bytes(std::span(text)));
    EXPECT_FALSE(verify(manifest()).is_whole());
}

// A few hundred bytes may ask for millions of frames. Only what is there is looked at.
TEST_F(VerificationTest, MillionsOfFramesThatAreNotThere) {
    std::vector<int> asked(10'000'000);
    std::iota(asked.begin(), asked.end(), 1);
    const std::string text = to_json(some_sequence(asked));
    base::write_whole(sequence_file(manifest()), std::as_bytes(std::span(text)));
    int looks = 0;
    const Verification found = verify(manifest(), {.progress = [&](int, int of) {
                                          ++looks;
                                          EXPECT_EQ(of, 3);
                                      }});
    EXPECT_EQ(looks, 3);
    EXPECT_EQ(found.whole, (std::vector{1, 2, 3}));
    EXPECT_EQ(animation::frame_range(found.missing), "4-10000000");
}

TEST_F(VerificationTest, ALinkThatLeadsNowhereIsMissing) {
    fs::remove(name().path(1));
    fs::create_symlink("nowhere", name().path(1));
    fs::remove(name().path(2));
    EXPECT_EQ(verify(manifest()).missing, (std::vector{1, 2}));
}

TEST_F(VerificationTest, FilesThatLookLikeFramesAndAreNone) {
    for (const char* file : {"a.0004.png", "a.12345.png"}) std::ofstream(folder_ / file) << "x";
    EXPECT_EQ(verify(manifest()).foreign, (std::vector{4, 12345}));
    EXPECT_FALSE(verify(manifest()).is_whole());
    for (const char* file : {"a.0004.png", "a.12345.png"}) fs::remove(folder_ / file);
    for (const char* file : {"a.png", "a.4.png", "a.00004.png", "a.0004.exr", "b.0004.png",
                             "a.0004x.png", "a.0004.png.txt", ".a.0004.part.png"}) {
        std::ofstream(folder_ / file) << "x";
    }
    EXPECT_TRUE(verify(manifest()).is_whole());
}

TEST_F(VerificationTest, FramesOfAnotherMaking) {
    FrameRecord record = write(2);
    record.provenance.renderer = "another";
    record.provenance.version = "0.0.9";
    recording_.record(record);
    const Verification found = verify(manifest());
    EXPECT_FALSE(found.is_whole());
    EXPECT_EQ(found.whole.size(), 3u);
    ASSERT_EQ(found.differing.size(), 2u);
    EXPECT_EQ(found.differing.at("renderer"), std::vector{2});
    EXPECT_EQ(found.differing.at("version"), std::vector{2});
}

// A file that was recorded as it is, with other pixels than were drawn.
TEST_F(VerificationTest, OtherPixelsThanRecorded) {
    FrameRecord record = write(2);
    record.pixels.front() = record.pixels.front() == '0' ? '1' : '0';
    recording_.record(record);
    EXPECT_TRUE(verify(manifest()).is_whole());
    const Verification found = verify(manifest(), {.pixels = true});
    EXPECT_FALSE(found.is_whole());
    EXPECT_EQ(found.repainted, std::vector{2});
}

TEST_F(VerificationTest, WithoutAManifestThereIsNothingToVerify) {
    EXPECT_THROW(verify(folder_ / "none.manifest"), base::FileError);
}

} // namespace
} // namespace isomotion::sequence
