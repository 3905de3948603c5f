#include "base/file.h"

#include <atomic>
#include <cerrno>
#include <thread>

#include <fcntl.h>
#include <sys/stat.h>

#include "base/content_hash.h"
#include "base/file_descriptor.h"
#include "base/file_text.h"
#include "base/input_error.h"
#include "base/loading.h"
#include "unit/base/places.h"

namespace isomotion::base {
namespace {

std::vector<std::byte> bytes(std::size_t size, int value = 7) {
    return std::vector<std::byte>(size, std::byte(value));
}

int code_of_writing(const std::filesystem::path& path, std::size_t size) {
    try {
        write_whole(path, bytes(size));
    } catch (const FileError& error) {
        EXPECT_NE(std::string(error.what()).find(path.string()), std::string::npos) << error.what();
        return error.system_code();
    }
    return 0;
}

TEST(WriteWhole, WritesAndReplaces) {
    const TemporaryFolder folder;
    for (const std::size_t size : {0u, 1u, 1000u, 3'000'000u, 5u}) {
        write_whole(folder / "a.png", bytes(size));
        EXPECT_EQ(read_whole(folder / "a.png"), bytes(size));
        EXPECT_EQ(folder.names(), std::set<std::string>{"a.png"});
    }
}

TEST(WriteWhole, ReusesWhatAKilledRunLeft) {
    const TemporaryFolder folder;
    std::ofstream(folder / ".a.0001.part.png") << "half of a longer picture";
    write_whole(folder / "a.0001.png", bytes(3));
    EXPECT_EQ(read_whole(folder / "a.0001.png"), bytes(3));
    EXPECT_EQ(folder.names(), std::set<std::string>{"a.0001.png"});
}

TEST(WriteWhole, FollowsNoLinkUnderTheHiddenName) {
    const TemporaryFolder folder;
    std::ofstream(folder / "precious") << "precious";
    std::filesystem::create_symlink("precious", folder / ".a.part.png");
    EXPECT_EQ(code_of_writing(folder / "a.png", 3), ELOOP);
    EXPECT_EQ(std::filesystem::file_size(folder / "precious"), 8u);
}

// A pipe there would keep the writer waiting for ever.
TEST(WriteWhole, WaitsForNoPipeUnderTheHiddenName) {
    const TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / ".a.part.png").c_str(), 0600), 0);
    EXPECT_THROW(write_whole(folder / "a.png", bytes(3)), FileError);
    const FileDescriptor reader(::open((folder / ".a.part.png").c_str(), O_RDONLY | O_NONBLOCK));
    EXPECT_THROW(write_whole(folder / "a.png", bytes(3)), FileError);
    EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
}

TEST(WriteWhole, EmptiesNoFileThatHasAnotherName) {
    const TemporaryFolder folder;
    std::ofstream(folder / "precious") << "precious";
    std::filesystem::create_hard_link(folder / "precious", folder / ".a.part.png");
    EXPECT_THROW(write_whole(folder / "a.png", bytes(3)), FileError);
    EXPECT_EQ(std::filesystem::file_size(folder / "precious"), 8u);
}

TEST(HashOfFile, IsThatOfItsBytes) {
    const TemporaryFolder folder;
    for (const std::size_t size : {0u, 1u, 1u << 20, 3'000'000u}) {
        write_whole(folder / "a", bytes(size));
        EXPECT_EQ(hash_of_file(folder / "a"), content_hash(bytes(size))) << size;
    }
    EXPECT_THROW(hash_of_file("/dev/zero"), FileError);
    EXPECT_THROW(hash_of_file(folder.path()), FileError);
}

TEST(FileText, IsOfARegularFile) {
    const TemporaryFolder folder;
    std::ofstream(folder / "a\nb") << "text";
    EXPECT_EQ(file_text(folder / "a\nb", 4), "text");
    const auto mistake = [](const std::filesystem::path& file) {
        try {
            file_text(file, 3);
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("none");
    };
    EXPECT_EQ(mistake("/dev/zero"), "/dev/zero: is a pipe or a device; name a regular file");
    EXPECT_EQ(mistake("/dev"), "/dev: is a folder; name a regular file");
    EXPECT_EQ(mistake("/dev/null/a"), "/dev/null/a: no such file");
    EXPECT_EQ(mistake(folder / "a\nb").find('\n'), std::string::npos);
    EXPECT_NE(mistake(folder / "a\nb").find("is larger than 3 bytes"), std::string::npos);
}

TEST(WhyNotLoaded, TellsOfMemory) {
    EXPECT_EQ(why_not_loaded("a.so: cannot open shared object file"),
              "a.so: cannot open shared object file");
    for (const char* words : {"a.so: failed to map segment from shared object",
                              "a.so: cannot allocate memory in static TLS block"}) {
        EXPECT_EQ(why_not_loaded(words),
                  std::string("out of memory, or a disk mounted noexec: ") + words);
    }
}

TEST(WriteWhole, WritersOfOneFileTakeTurns) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder / "a.png";
    write_whole(file, bytes(100'000, 1));
    std::atomic<bool> done = false;
    std::vector<std::jthread> writers;
    for (int value = 1; value <= 3; ++value)
        writers.emplace_back([&file, &done, value] {
            while (!done) write_whole(file, bytes(100'000u * unsigned(value), value));
        });
    for (int i = 0; i < 200; ++i) {
        const auto seen = read_whole(file);
        ASSERT_FALSE(seen.empty());
        ASSERT_EQ(seen, bytes(100'000u * unsigned(seen[0]), int(seen[0])));
    }
    done = true;
    writers.clear();
    EXPECT_EQ(folder.names(), std::set<std::string>{"a.png"});
}

TEST(WriteWhole, ReportsAMissingFolder) {
    const TemporaryFolder folder;
    EXPECT_EQ(code_of_writing(folder / "none/a.png", 3), ENOENT);
}

TEST(WriteWhole, ReportsAFolderInItsPlace) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "a.png");
    EXPECT_EQ(code_of_writing(folder / "a.png", 3), EISDIR);
    EXPECT_EQ(folder.names(), std::set<std::string>{"a.png"});
}

TEST(WriteWhole, ReportsAnUnwritableFolder) {
    const TemporaryFolder folder;
    if (::geteuid() == 0) { // permissions do not stop root, a read-only disk does
        const Disk disk(folder, MS_RDONLY, "size=64k");
        if (!disk) GTEST_SKIP() << "root without the right to mount: nothing is unwritable";
        EXPECT_EQ(code_of_writing(folder / "a.png", 3), EROFS);
        return;
    }
    ::chmod(folder.path().c_str(), 0555);
    EXPECT_EQ(code_of_writing(folder / "a.png", 3), EACCES);
    ::chmod(folder.path().c_str(), 0755);
}

TEST(WriteWhole, LeavesNothingOnAFullDisk) {
    const TemporaryFolder folder;
    const Disk disk(folder, 0, "size=64k");
    if (!disk) GTEST_SKIP() << "no right to mount a small disk";
    EXPECT_EQ(code_of_writing(folder / "a.png", 200'000), ENOSPC);
    EXPECT_EQ(folder.names(), std::set<std::string>{});
    EXPECT_EQ(code_of_writing(folder / "a.png", 1'000), 0);
    EXPECT_EQ(code_of_writing(folder / "a.png", 200'000), ENOSPC);
    EXPECT_EQ(read_whole(folder / "a.png"), bytes(1'000)) << "the file before is untouched";
}

TEST(WriteWhole, WritesDevicesStraight) {
    const TemporaryFolder folder;
    std::filesystem::create_symlink("/dev/full", folder / "full.png");
    std::filesystem::create_symlink("/dev/null", folder / "null.png");
    EXPECT_EQ(code_of_writing(folder / "full.png", 3), ENOSPC);
    EXPECT_EQ(code_of_writing(folder / "null.png", 3), 0);
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
    EXPECT_EQ(folder.names(), (std::set<std::string>{"full.png", "null.png"}));
}

TEST(ReadWhole, ReportsWhatCannotBeRead) {
    const TemporaryFolder folder;
    EXPECT_THROW(read_whole(folder / "none"), FileError);
    EXPECT_THROW(read_whole(folder.path()), FileError);
}

TEST(ReadWhole, ReadsFilesThatDoNotTellTheirSize) {
    EXPECT_FALSE(read_whole("/proc/self/maps").empty());
}

} // namespace
} // namespace isomotion::base
