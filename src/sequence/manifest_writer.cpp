#include "sequence/manifest_writer.h"

#include <algorithm>
#include <cerrno>
#include <optional>
#include <string_view>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <fmt/format.h>

#include "base/file.h"
#include "base/partial_file.h"
#include "base/printable.h"
#include "sequence/manifest.h"
#include "sequence/manifest_json.h"

namespace isomotion::sequence {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view about_writers =
    "Locked by every process that renders frames of this sequence.\n";

fs::path writers_file(const fs::path& manifest) { return manifest / "writers"; }

std::span<const std::byte> bytes_of(std::string_view text) {
    return std::as_bytes(std::span(text));
}

void make_folder(const fs::path& folder) {
    std::error_code error, unknown;
    // Through a link, records would take the names of files in a folder of somebody else.
    if (fs::is_symlink(fs::symlink_status(folder, unknown))) {
        throw base::FileError(folder, "is a link, and a manifest a folder of its own; remove it, "
                                      "or give these frames another name with -o");
    }
    fs::create_directory(folder, error);
    if (!error) return;
    if (fs::is_directory(folder, unknown)) return;
    const bool is_in_the_way = error == std::errc::file_exists;
    throw base::FileError(folder, "the folder cannot be created",
                          is_in_the_way && unknown ? unknown.value() : error.value());
}

base::FileDescriptor open_writers(const fs::path& manifest) {
    const fs::path file = writers_file(manifest);
    // Not through a link, which may lead to a file of somebody else.
    base::FileDescriptor writers(
        ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666));
    if (!writers) throw base::FileError(file, "cannot be created", errno);
    struct stat found = {};
    if (::fstat(writers.number(), &found) != 0)
        throw base::FileError(file, "cannot be read", errno);
    if (!S_ISREG(found.st_mode)) throw base::FileError(file, "is a pipe or a device; remove it");
    if (found.st_size == 0) {
        base::write_all(writers.number(), bytes_of(about_writers), file);
    }
    return writers;
}

// False if others hold a lock that stands against it.
bool lock(const base::FileDescriptor& writers, int how) {
    while (::flock(writers.number(), how | LOCK_NB) != 0) {
        if (errno == EINTR) continue;
        return errno != EWOULDBLOCK;
    }
    return true;
}

std::optional<Sequence> sequence_there(const fs::path& manifest) {
    try {
        return read_sequence(manifest);
    } catch (const base::FileError& error) {
        if (error.system_code() != ENOENT) throw;
        return {};
    } catch (const Error&) { // a file of somebody else's that has its name
        throw base::FileError(sequence_file(manifest),
                              "is no manifest that this version reads; move it away, or give "
                              "these frames another name with -o");
    }
}

std::vector<int> united(std::vector<int> frames, const std::vector<int>& more) {
    frames.insert(frames.end(), more.begin(), more.end());
    std::ranges::sort(frames);
    frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
    return frames;
}

} // namespace

ManifestWriter::ManifestWriter(const SequenceName& name, const Sequence& sequence)
    : folder_(manifest_folder(name)) {
    make_folder(folder_);
    writers_ = open_writers(folder_);
    join(parse_sequence(to_json(sequence), "sequence")); // names as a file gives them back
}

void ManifestWriter::join(const Sequence& wanted) {
    // Those who join at the same time have this file one after the other.
    base::PartialFile file(sequence_file(folder_));
    const std::optional<Sequence> there = sequence_there(folder_);
    if (there && there->format.pattern != wanted.format.pattern) {
        throw Error(Error::Code::input,
                    fmt::format("{}: is the manifest of {}, not of {}; move it away, or "
                                "give these frames another name with -o",
                                base::printable_line(folder_.string()), there->format.pattern,
                                wanted.format.pattern));
    }
    Sequence joined = there.value_or(wanted);
    const std::string other = difference(joined, wanted);
    if (!other.empty()) {
        if (!lock(writers_, LOCK_EX)) {
            throw Error(
                Error::Code::input,
                fmt::format("{}: somebody is rendering these frames from {}; wait for them, "
                            "or give these frames another name with -o",
                            folder_.string(), other));
        }
        joined = wanted;
    }
    lock(writers_, LOCK_SH); // before the next one may join
    const std::vector<int> asked = united(joined.asked, wanted.asked);
    if (there && other.empty() && asked == there->asked) return;
    joined.asked = asked;
    file.write(bytes_of(to_json(joined)));
    file.publish();
}

void ManifestWriter::expect_manifest() const {
    struct stat joined = {}, named = {};
    if (::fstat(writers_.number(), &joined) != 0)
        throw base::FileError(writers_file(folder_), "cannot be read", errno);
    const bool is_there = ::stat(writers_file(folder_).c_str(), &named) == 0;
    if (!is_there && errno != ENOENT && errno != ENOTDIR)
        throw base::FileError(writers_file(folder_), "cannot be read", errno);
    const bool same = is_there && joined.st_dev == named.st_dev && joined.st_ino == named.st_ino;
    if (!same) {
        throw base::FileError(folder_, "was removed or replaced while its frames were rendered",
                              ENOENT);
    }
}

void ManifestWriter::record(const FrameRecord& frame) const {
    expect_manifest();
    base::PartialFile file(frame_file(folder_, frame.frame));
    file.write(bytes_of(to_json(frame)));
    // A record that a power cut loses costs a frame to be rendered again, no more.
    file.publish(base::Durability::at_ease);
}

} // namespace isomotion::sequence
