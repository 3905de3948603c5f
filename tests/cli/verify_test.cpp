// `verify` tells whether rendered frames are all there, as they were written.
#include "cli.h"

#include <cstdlib>
#include <span>

#include "base/content_hash.h"

namespace isomotion::cli {
namespace {

namespace fs = std::filesystem;

class Verify : public Cli {
protected:
    Verify() {
        render({"sphere.toml", "--frames", "1-4", "--size", "10x10", "-o", "out/a.####.png"});
    }

    Ending verify(const std::string& what, Words more = {}) const {
        more.insert(more.begin(), {"verify", what});
        return run(more);
    }
};

TEST_F(Verify, AWholeSequenceByAnyOfItsNames) {
    for (const std::string name : {"out", "out/", "out/a.####.png", "out/a.%04d.png",
                                   "out/a.manifest", "out/a.manifest/.", "out/./", "out/a"}) {
        const Ending ending = verify(name);
        EXPECT_EQ(ending.code, 0) << name << ending;
        EXPECT_THAT(ending.out, StartsWith("out/a.####.png: Sphere, 4 frames, 10x10, "));
        EXPECT_THAT(ending.out, HasSubstr("\n  whole\n"));
        EXPECT_THAT(ending.err, IsEmpty());
    }
    int miss = 0, hit = 0;
    const std::string out = verify("out").out;
    const std::size_t rays = out.find("  rays: ");
    ASSERT_NE(rays, std::string::npos);
    ASSERT_EQ(std::sscanf(out.c_str() + rays, "  rays: %d miss, %d hit", &miss, &hit), 2);
    EXPECT_EQ(miss + hit, 4 * 10 * 10);
    EXPECT_THAT(verify("out", {"--quiet"}).out, IsEmpty());
}

TEST_F(Verify, EveryKindOfDamage) {
    fs::remove(*this / "out/a.0001.png");
    fs::resize_file(*this / "out/a.0002.png", 100);
    fs::remove(*this / "out/a.manifest/0003.json");
    write("out/a.0007.png", "x");
    const Ending ending = verify("out");
    EXPECT_EQ(ending.code, 1) << ending;
    for (const char* line : {"\n  missing: 1 (1)\n", "\n  truncated or changed: 1 (2)\n",
                             "\n  of an earlier scene or from elsewhere, without a record: 1 (3)\n",
                             "\n  of an earlier scene or from elsewhere, never asked for: 1 (7)\n",
                             "\n  not whole\n"}) {
        EXPECT_THAT(ending.out, HasSubstr(line));
    }
    EXPECT_EQ(verify("out", {"--quiet"}).code, 1);
    const Ending json = verify("out", {"--json"});
    EXPECT_EQ(json.code, 1);
    EXPECT_THAT(json.out, HasSubstr("\"is whole\": false"));
    EXPECT_THAT(json.out, HasSubstr("\"changed\": \"2\""));
}

TEST_F(Verify, FramesOfTwoScenes) {
    render({"sphere.toml", "--frames", "3-4", "--size", "10x10", "--set", "r=0.8", "-o",
            "out/a.####.png"});
    const Ending mixed = verify("out");
    EXPECT_EQ(mixed.code, 1) << mixed;
    EXPECT_THAT(mixed.out,
                HasSubstr("\n  of an earlier scene or from elsewhere, never asked for: 2 (1-2)\n"));
    // The other frames are asked for too, and rendered where they are not the scene's.
    const Words all{"sphere.toml", "--frames", "1-4", "--size",         "10x10",
                    "--set",       "r=0.8",    "-o",  "out/a.####.png", "--resume"};
    EXPECT_THAT(render(all).out, HasSubstr("\nnot kept: 2 of other settings (1-2)\n"));
    EXPECT_EQ(verify("out", {"--pixels"}).code, 0);
}

TEST_F(Verify, AllSequencesOfAFolder) {
    render({"sphere.toml", "--frames", "1-2", "--size", "10x10", "-o", "out/b.##.exr", "--channels",
            "z,n"});
    const Ending both = verify("out", {"--pixels"});
    EXPECT_EQ(both.code, 0) << both;
    EXPECT_THAT(both.out, HasSubstr("out/b.##.exr: Sphere, 2 frames"));
    fs::remove(*this / "out/b.01.exr");
    EXPECT_EQ(verify("out").code, 1);
    EXPECT_EQ(verify("out/a.####.png").code, 0);
}

TEST_F(Verify, SequencesOfLikeNamesDontMeet) {
    const std::string names[] = {"out/a####.png", "out/a.##.png", "out/a%06d.png",
                                 "out/a.#####.png"};
    for (const std::string& name : names)
        render({"sphere.toml", "--frames", "1-2", "--size", "8x8", "-o", name});
    EXPECT_EQ(verify("out").code, 0);
    for (const std::string& name : names) EXPECT_EQ(verify(name).code, 0) << name;
    for (const char* file : {"out/a0001.png", "out/a0002.png"}) fs::remove(*this / file);
    EXPECT_EQ(verify("out/a####.png").code, 1);
    EXPECT_EQ(verify("out/a.####.png").code, 0);
    // Nor where a manifest was put in another's place.
    fs::remove_all(*this / "out/a####.png.manifest");
    fs::rename(*this / "out/a.##.png.manifest", *this / "out/a####.png.manifest");
    const Ending moved = verify("out/a####.png");
    EXPECT_EQ(moved.code, 3) << moved;
    EXPECT_THAT(moved.err, HasSubstr("is the manifest of a.##.png"));
    const Ending all = verify("out");
    EXPECT_EQ(all.code, 3) << all;
    EXPECT_THAT(all.err, HasSubstr("a####.png.manifest: is a manifest of a.##.png, which belongs "
                                   "into a.##.png.manifest"));
}

TEST_F(Verify, AManifestOfFilesElsewhereIsNone) {
    std::string text = bytes("out/a.manifest/sequence.json");
    for (const char* files : {"../out/a.####.png", "/a.####.png", "a.png", "a.##.##.png", ""}) {
        std::string other = text;
        other.replace(other.find("a.####.png"), 10, files);
        write("out/a.manifest/sequence.json", other);
        const Ending ending = verify("out");
        EXPECT_EQ(ending.code, 3) << files << ending;
        EXPECT_THAT(ending.err, StartsWith("out/a.manifest/sequence.json: files: ")) << files;
    }
}

// A manifest that lost what its frames are is not passed over where others are whole.
TEST_F(Verify, AManifestWithoutItsSequence) {
    render({"sphere.toml", "--frames", "1-2", "--size", "10x10", "-o", "out/b.####.png"});
    fs::remove(*this / "out/b.manifest/sequence.json");
    const Ending ending = verify("out");
    EXPECT_EQ(ending.code, 3) << ending;
    EXPECT_THAT(ending.err, HasSubstr("out/b.manifest/sequence.json"));
    fs::remove(*this / "out/b.manifest/writers");
    EXPECT_EQ(verify("out").code, 3); // by its records
    fs::remove_all(*this / "out/b.manifest");
    fs::create_directory(*this / "out/b.manifest");
    write("out/b.manifest/notes.json", "{}");
    EXPECT_EQ(verify("out").code, 0); // never was one
}

std::string line_of(const std::string& text, const std::string& key) {
    const std::size_t at = text.find("  \"" + key + "\": ");
    return at == text.npos ? "" : text.substr(at, text.find('\n', at) - at);
}

TEST_F(Verify, HoldsLittleOfAFrameInMemory) {
    const std::string record = "out/a.manifest/0001.json";
    std::string text = bytes(record);
    const std::string size = line_of(text, "bytes");
    ASSERT_FALSE(size.empty());
    text.replace(text.find(size), size.size(), "  \"bytes\": 2147483648,");
    write(record, text);
    fs::resize_file(*this / "out/a.0001.png", std::uintmax_t(2) << 30); // sparse
    const Ending ending = cli::run({"/bin/sh", "-c", R"(ulimit -v 500000; exec "$0" "$@")",
                                    ISOMOTION_PROGRAM, "verify", "out"},
                                   circumstances());
    EXPECT_EQ(ending.code, 1) << ending;
    EXPECT_THAT(ending.out, HasSubstr("not whole"));
}

// docs/security.md says so: a manifest proves that files are what it says, not who drew them.
TEST_F(Verify, DoesNotTellWhoDrewAFrame) {
    render({"sphere.toml", "--frames", "1-4", "--size", "10x10", "--set", "r=0.3", "-o",
            "other/a.####.png"});
    const std::string name = "a.manifest/0001.json";
    std::string record = bytes("out/" + name);
    for (const char* key : {"bytes", "hash", "pixels"}) {
        const std::string mine = line_of(record, key);
        record.replace(record.find(mine), mine.size(), line_of(bytes("other/" + name), key));
    }
    fs::copy_file(*this / "other/a.0001.png", *this / "out/a.0001.png",
                  fs::copy_options::overwrite_existing);
    write("out/" + name, record);
    EXPECT_EQ(verify("out", {"--pixels"}).code, 0);
    render(
        {"sphere.toml", "--frames", "1-4", "--size", "10x10", "--resume", "-o", "out/a.####.png"});
    EXPECT_EQ(bytes("out/a.0001.png"), bytes("other/a.0001.png"));
}

// Every frame of ours has one.
TEST_F(Verify, ARecordWithoutAFingerprintIsNone) {
    const std::string name = "out/a.manifest/0002.json";
    std::string record = bytes(name);
    const std::string print = line_of(record, "fingerprint");
    record.replace(record.find(print), print.size(), "  \"fingerprint\": \"\",");
    write(name, record);
    const Ending ending = verify("out");
    EXPECT_EQ(ending.code, 1) << ending;
    EXPECT_THAT(ending.out, HasSubstr("without a record: 1 (2)\n"));
}

// The scene is not to blame.
TEST_F(Verify, AFrameThatIsNoPictureEndsAMovie) {
    if (std::system("command -v ffmpeg >/dev/null")) GTEST_SKIP() << "ffmpeg is not installed";
    const std::string name = "out/a.manifest/0002.json", garbage = "no picture";
    std::string record = bytes(name);
    const std::string size = line_of(record, "bytes"), hash = line_of(record, "hash");
    record.replace(record.find(size), size.size(), "  \"bytes\": 10,");
    const auto garbage_hash = base::content_hash(std::as_bytes(std::span(garbage)));
    record.replace(record.find(hash), hash.size(), "  \"hash\": \"" + garbage_hash + "\",");
    write(name, record);
    write("out/a.0002.png", garbage);
    const Ending ending = run({"render", "sphere.toml", "--frames", "1-4", "--size", "10x10",
                               "--resume", "-o", "out/a.####.png", "--movie", "a.gif"});
    EXPECT_EQ(ending.code, 3) << ending;
    EXPECT_THAT(ending.err, HasSubstr("a.0002.png: no picture that is read"));
}

TEST_F(Verify, WhatCannotBeRead) {
    for (const std::string name : {"nowhere", "nowhere/a.####.png", "sphere.toml", "."}) {
        const Ending ending = verify(name);
        EXPECT_EQ(ending.code, 3) << name << ending;
        EXPECT_THAT(ending.err, Not(IsEmpty()));
        EXPECT_THAT(ending.out, IsEmpty());
    }
    for (const std::string frames : {"a\\r\\nforged", "1-\\u001b[2J"}) {
        std::string other = bytes("out/a.manifest/sequence.json");
        const auto at = other.find("\"frames\": \"") + 11;
        other.replace(at, other.find('"', at) - at, frames);
        write("out/a.manifest/sequence.json", other);
        const Ending forged = verify("out");
        EXPECT_EQ(forged.code, 3) << forged;
        EXPECT_THAT(forged.err,
                    Not(AnyOf(HasSubstr("\r"), HasSubstr("\nforged"), HasSubstr("\x1b"))));
    }
    write("out/a.manifest/sequence.json", "{");
    const Ending ending = verify("out");
    EXPECT_EQ(ending.code, 3) << ending;
    EXPECT_THAT(ending.err, AllOf(StartsWith("out/a.manifest/sequence.json: not valid JSON: "),
                                  HasSubstr("; this is no manifest")));
    EXPECT_EQ(run({"verify"}).code, 2);
    EXPECT_EQ(run({"verify", "a##.##.png"}).code, 2);
}

} // namespace
} // namespace isomotion::cli
