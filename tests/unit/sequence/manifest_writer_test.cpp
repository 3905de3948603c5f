#include "sequence/manifest_writer.h"

#include <atomic>
#include <latch>
#include <map>
#include <optional>
#include <thread>

#include "base/input_error.h"
#include "records.h"
#include "sequence/manifest_json.h"

namespace isomotion::sequence {
namespace {

namespace fs = std::filesystem;

TEST(ManifestFolder, StandsBesideTheFrames) {
    const auto folder = [](const char* name) {
        return manifest_folder(SequenceName::parse(name)).string();
    };
    EXPECT_EQ(folder("out/blob.####.png"), "out/blob.manifest");
    EXPECT_EQ(folder("out/blob.%04d.png"), "out/blob.manifest");
    EXPECT_EQ(folder("blob.####.png"), "blob.manifest");
    EXPECT_EQ(folder("blob.####.exr"), "blob.exr.manifest");
    EXPECT_EQ(folder("blob.v2.####.png"), "blob.v2.manifest");
    EXPECT_EQ(folder("blob_##.png"), "blob_##.png.manifest");
    EXPECT_EQ(folder("blob.####.left.png"), "blob.####.left.png.manifest");
    EXPECT_EQ(folder("out/####.png"), "out/####.png.manifest");
}

TEST(ManifestFolder, IsOfOneSequenceAlone) {
    std::map<std::string, std::string> pattern_of;
    const auto add = [&](const std::string& text) {
        const SequenceName name = SequenceName::parse(text);
        const auto [at, is_new] =
            pattern_of.emplace(manifest_folder(name).string(), name.pattern());
        EXPECT_EQ(at->second, name.pattern()) << at->first;
    };
    // All that can be put together from parts that folders' names have.
    const std::string parts[] = {"",          "a",     ".",  ".exr",  ".png", "_",  ".a",    "####",
                                 ".manifest", ".####", "##", "#####", "%04d", "%d", "frames"};
    for (const auto& one : parts) {
        for (const auto& two : parts) {
            for (const auto& three : parts) {
                for (const auto& four : parts) {
                    try {
                        if (SequenceName::parse(one + two + three + four).holds_many())
                            add(one + two + three + four);
                    } catch (const base::InputError&) { // two places, or a folder
                    }
                }
            }
        }
    }
    EXPECT_GT(pattern_of.size(), 5000u);
}

using RecordingTest = Recorded;

TEST_F(RecordingTest, UnitesWhatIsAskedFor) {
    ManifestWriter(name(), some_sequence({1, 2, 3}));
    ManifestWriter(name(), some_sequence({3, 4, 10}));
    EXPECT_EQ(read_sequence(manifest()).asked, (std::vector{1, 2, 3, 4, 10}));
}

TEST_F(RecordingTest, ManyWhoJoinAtOnceLoseNothing) {
    constexpr int many = 40;
    std::vector<std::jthread> all;
    for (int k = 0; k < many; ++k) {
        all.emplace_back([this, k] {
            ManifestWriter recording(name(), some_sequence({k + 1, 100 + k}));
            recording.record(write(k + 1));
        });
    }
    all.clear();
    EXPECT_EQ(read_sequence(manifest()).asked.size(), 2u * many);
    for (int k = 0; k < many; ++k) EXPECT_TRUE(find_record(name(), k + 1)) << k;
    // No hidden files are left.
    for (const auto& entry : fs::directory_iterator(manifest())) {
        EXPECT_NE(entry.path().filename().string().front(), '.');
    }
}

// A manifest that was moved here from elsewhere.
TEST_F(RecordingTest, TheManifestOfOtherFilesIsKept) {
    { const ManifestWriter recording(name(), some_sequence()); }
    Sequence other = some_sequence();
    other.format.pattern = "b.##.png";
    const std::string text = to_json(other);
    base::write_whole(sequence_file(manifest()), std::as_bytes(std::span(text)));
    EXPECT_THROW(ManifestWriter(name(), some_sequence()), Error);
    EXPECT_EQ(read_sequence(manifest()).format.pattern, "b.##.png");
}

TEST_F(RecordingTest, DoesNotWriteThroughALink) {
    { const ManifestWriter recording(name(), some_sequence()); }
    fs::remove(manifest() / "writers");
    fs::create_symlink(folder_ / "elsewhere", manifest() / "writers");
    EXPECT_THROW(ManifestWriter(name(), some_sequence()), base::FileError);
    EXPECT_FALSE(fs::exists(folder_ / "elsewhere"));
}

TEST_F(RecordingTest, AnotherSequenceIsRefusedWhileSomebodyIsAtWork) {
    Sequence other = some_sequence({5});
    other.format.width = 64;
    {
        const ManifestWriter at_work(name(), some_sequence());
        const std::string before = sequence_file(manifest()).string();
        try {
            ManifestWriter(name(), other);
            FAIL();
        } catch (const Error& clash) {
            EXPECT_NE(std::string(clash.what()).find("size 4x3, not 64x3"), std::string::npos)
                << clash.what();
        }
        EXPECT_EQ(read_sequence(manifest()).asked, (std::vector{1, 2, 3}));
        EXPECT_NO_THROW(ManifestWriter(name(), some_sequence({7})));
    }
    // Alone it takes the place of the one before.
    ManifestWriter(name(), other);
    EXPECT_EQ(read_sequence(manifest()).asked, std::vector{5});
    EXPECT_EQ(read_sequence(manifest()).format.width, 64);
}

// When many want different things at once, one kind has its way, and all others are told.
TEST_F(RecordingTest, OfManyDifferentOnesOneWins) {
    std::atomic<int> joined = 0, refused = 0;
    std::latch all_tried(16);
    std::vector<std::jthread> all;
    for (int k = 0; k < 16; ++k) {
        all.emplace_back([&, k] {
            Sequence mine = some_sequence();
            mine.provenance.scene = "scene " + std::to_string(k % 4);
            std::optional<ManifestWriter> recording;
            try {
                recording.emplace(name(), mine);
                ++joined;
            } catch (const Error&) {
                ++refused;
            }
            all_tried.arrive_and_wait(); // at work until all have tried
        });
    }
    all.clear();
    EXPECT_EQ(joined, 4);
    EXPECT_EQ(refused, 12);
}

TEST_F(RecordingTest, EveryDifferenceTells) {
    const auto told = [](auto&& change) {
        Sequence other = some_sequence();
        change(other);
        return difference(other, some_sequence());
    };
    EXPECT_EQ(told([](Sequence&) {}), "");
    EXPECT_EQ(told([](Sequence& s) { s.backend = "osmesa"; }), "");
    EXPECT_EQ(told([](Sequence& s) { s.asked = {9}; }), "");
    EXPECT_NE(told([](Sequence& s) { s.format.pattern = "a.##.png"; }), "");
    EXPECT_NE(told([](Sequence& s) { s.format.height = 1; }), "");
    EXPECT_NE(told([](Sequence& s) { s.format.encoding = "exr"; }), "");
    EXPECT_NE(told([](Sequence& s) { s.format.channels = {"R"}; }), "");
    EXPECT_NE(told([](Sequence& s) { s.format.fps = "30"; }), "");
    EXPECT_NE(told([](Sequence& s) { s.title = "Globe"; }), "");
    EXPECT_NE(told([](Sequence& s) { s.provenance.scene = "x"; }), "");
    EXPECT_NE(told([](Sequence& s) { s.provenance.shaders = "x"; }), "");
    EXPECT_NE(told([](Sequence& s) { s.provenance.version = "x"; }), "");
    EXPECT_NE(told([](Sequence& s) { s.provenance.renderer = "x"; }), "");
    EXPECT_NE(told([](Sequence& s) { s.provenance.stage = "x"; }), "");
}

// It may be somebody else's file.
TEST_F(RecordingTest, WhatIsNoManifestIsKept) {
    { const ManifestWriter first(name(), some_sequence()); }
    for (const std::string text : {"", "{", "{}", "\xff"}) {
        std::ofstream(sequence_file(manifest())) << text;
        EXPECT_THROW(ManifestWriter(name(), some_sequence({2})), base::FileError) << text;
        EXPECT_EQ(base::read_whole(sequence_file(manifest())).size(), text.size());
    }
    fs::remove(sequence_file(manifest()));
    ManifestWriter(name(), some_sequence({2}));
    EXPECT_EQ(read_sequence(manifest()).asked, std::vector{2});
}

TEST_F(RecordingTest, AManifestThatIsRemovedOrReplacedIsNoticed) {
    const ManifestWriter recording(name(), some_sequence());
    fs::remove_all(manifest());
    EXPECT_THROW(recording.record(write(1)), base::FileError);
    const ManifestWriter other(name(), some_sequence());
    EXPECT_THROW(recording.record(write(1)), base::FileError);
    EXPECT_NO_THROW(other.record(write(1)));
}

TEST_F(RecordingTest, AFileInTheManifestsPlaceIsNamed) {
    std::ofstream(manifest()) << "mine";
    try {
        ManifestWriter(name(), some_sequence());
        FAIL();
    } catch (const base::FileError& error) {
        EXPECT_EQ(error.path(), manifest());
    }
    EXPECT_EQ(fs::file_size(manifest()), 4u);
}

} // namespace
} // namespace isomotion::sequence
