// Places that refuse, vanish or are taken.
#include "export.h"

#include <chrono>

#include <sys/mount.h>

namespace isomotion::faults {
namespace {

class Places : public Export {
protected:
    // A shell's limits hold for what it becomes.
    Ending limited(const std::string& limits, const Words& words) const {
        Words all{"/bin/sh", "-c", limits + R"(; exec "$0" "$@")",
                  cli::tested_program(ISOMOTION_PROGRAM)};
        all.insert(all.end(), words.begin(), words.end());
        return cli::run(all, circumstances());
    }
    static Words many(const std::string& output) {
        return command(output, {"--frames", "1-100000"});
    }
};

TEST_F(Places, TheFolderIsRemovedMeanwhile) {
    const Ending ending =
        run_with(many("out"), "out", 3, [this] { fs::rename(*this / "out", *this / "gone"); });
    EXPECT_EQ(ending.code, 3) << ending;
    EXPECT_THAT(ending.err, HasSubstr("out/a."));
    EXPECT_THAT(ending.err, HasSubstr("No such file or directory"));
    EXPECT_FALSE(fs::exists(*this / "out"));
    expect_frames_of("gone", false);
}

TEST_F(Places, TheManifestIsRemovedMeanwhile) {
    const Ending ending = run_with(
        many("out"), "out", 3, [this] { fs::rename(*this / "out/a.manifest", *this / "gone"); });
    EXPECT_EQ(ending.code, 3) << ending;
    EXPECT_THAT(ending.err, HasSubstr("out/a.manifest"));
    expect_frames_of("out", false);
    // Without records nothing is trusted.
    const Ending rest = run(command("out", {"--resume", "--frames", "1-3"}));
    EXPECT_THAT(rest.out, HasSubstr("\nnot kept: 3 of an earlier scene (1-3)\n"));
    EXPECT_EQ(run({"verify", "gone/none"}).code, 3);
}

TEST_F(Places, AFileIsWhereTheManifestBelongs) {
    fs::create_directory(*this / "out");
    write("out/a.manifest", "mine");
    const Ending ending = run(command("out"));
    EXPECT_EQ(ending.code, 3) << ending;
    EXPECT_THAT(ending.err, HasSubstr("out/a.manifest: the folder cannot be created"));
    EXPECT_EQ(bytes("out/a.manifest"), "mine");
    EXPECT_EQ(finished("out"), 0);
}

TEST_F(Places, AnOutputsPathIsTooLong) {
    for (const std::string& name : {std::string(300, 'a'), std::string(100, 'a') + '/'}) {
        std::string folder;
        while (folder.size() < 5000) folder += name;
        const Ending ending = run(command(folder, {"--frames", "1-2"}));
        EXPECT_EQ(ending.code, 3) << ending;
        EXPECT_THAT(ending.err, HasSubstr(name.substr(0, 100))); // long names are shortened
        EXPECT_THAT(ending.err, HasSubstr("File name too long"));
        EXPECT_THAT(ending.err, Not(HasSubstr("filesystem error")));
    }
}

TEST_F(Places, AFolderIsWhereARecordBelongs) {
    fs::create_directories(*this / "out/a.manifest/0002.json");
    const Ending ending = run(command("out", {"--frames", "1-3"}));
    EXPECT_EQ(ending.code, 3) << ending;
    EXPECT_THAT(ending.err, HasSubstr("0002.json: cannot be replaced: Is a directory"));
    const Ending found = run({"verify", "out"});
    EXPECT_EQ(found.code, 1) << found;
    EXPECT_THAT(found.out,
                HasSubstr("of an earlier scene or from elsewhere, without a record: 1 (2)"));
}

TEST_F(Places, AFolderIsWhereAFrameBelongs) {
    fs::create_directories(*this / "out/a.0002.png");
    for (const char* resume : {"--quiet", "--resume"}) {
        const Ending ending = run(command("out", {"--frames", "1-3", resume}));
        EXPECT_EQ(ending.code, 3) << ending;
        EXPECT_THAT(ending.err, HasSubstr("a.0002.png: cannot be replaced: Is a directory"));
    }
    EXPECT_EQ(run({"verify", "out"}).code, 1);
}

// A link is replaced; what it leads to stays as it is.
TEST_F(Places, ALinkIsWhereAFrameBelongs) {
    fs::create_directory(*this / "out");
    write("precious.png", "mine");
    fs::create_symlink("../precious.png", *this / "out/a.0001.png");
    fs::create_symlink("nowhere", *this / "out/a.0002.png");
    fs::create_symlink("a.0003.png", *this / "out/a.0003.png"); // to itself
    const Ending ending = run(command("out"));
    EXPECT_EQ(ending.code, 0) << ending;
    EXPECT_EQ(bytes("precious.png"), "mine");
    expect_frames_of("out");
    for (const char* name : {"out/a.0001.png", "out/a.0002.png", "out/a.0003.png"}) {
        EXPECT_FALSE(fs::is_symlink(*this / name)) << name;
    }
    expect_verified("out");
}

TEST_F(Places, AFullDisk) {
    const image::TemporaryFolder place;
    const image::Disk disk(place, 0, "size=256k");
    if (!disk) GTEST_SKIP() << "mounting a file system is not allowed here";
    const std::string out = place / "out";
    const Ending ending = run(many(out));
    EXPECT_EQ(ending.code, 3) << ending;
    EXPECT_THAT(ending.err, HasSubstr("No space left on device"));
    EXPECT_GT(finished(out), 3);
    for (const auto& entry : fs::recursive_directory_iterator(out)) {
        EXPECT_THAT(entry.path().filename().string(), Not(StartsWith(".")));
    }
    const Ending found = run({"verify", out, "--pixels"});
    EXPECT_EQ(found.code, 1) << found; // of so many frames most are missing
    EXPECT_THAT(found.out, Not(HasSubstr("changed")));
    EXPECT_THAT(found.out, Not(HasSubstr("other pixels")));
}

TEST_F(Places, ALimitOnFiles) { // as quotas are
    const Ending ending = limited("ulimit -f 8", command("out", {"--size", "512x512"}));
    EXPECT_EQ(ending.code, 3) << ending;
    EXPECT_THAT(ending.err, HasSubstr("out/a.0001.png: cannot be written: File too large"));
    EXPECT_EQ(finished("out"), 0);
    expect_only_whole_files();
}

TEST_F(Places, AReadOnlyDisk) {
    const image::TemporaryFolder place;
    const image::Disk disk(place, 0, "size=8m");
    if (!disk) GTEST_SKIP() << "mounting a file system is not allowed here";
    const std::string out = place / "out";
    ASSERT_EQ(run(command(out, {"--frames", "1-5"})).code, 0);
    ASSERT_EQ(::mount("tmpfs", place.path().c_str(), "tmpfs", MS_REMOUNT | MS_RDONLY, ""), 0);
    const Ending ending = run(command(out, {"--frames", "1-6", "--resume"}));
    EXPECT_EQ(ending.code, 3) << ending;
    EXPECT_THAT(ending.err, HasSubstr("Read-only file system"));
    expect_verified(out);
}

// Clocks that were wrong, or jump, change nothing.
TEST_F(Places, DatesDoNotCount) {
    whole();
    const auto now = fs::file_time_type::clock::now();
    int k = 0;
    for (const auto& entry : fs::recursive_directory_iterator(*this / whole())) {
        fs::last_write_time(entry.path(), now + std::chrono::years(k++ % 2 ? 60 : -40));
    }
    const Ending ending = run(command(whole(), {"--resume"}));
    EXPECT_THAT(ending.out, HasSubstr("\n60 frames kept from an earlier run\n"));
    expect_verified(whole());
}

} // namespace
} // namespace isomotion::faults
