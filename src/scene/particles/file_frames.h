// The elements of an array from one file per time.
//
// A file is read when its time is asked for. While frames come in order, a thread reads the next
// files ahead. At most frames_kept() files are in memory, each with only the columns that were ever
// asked for. So the values are the same whether a file was read ahead, read again or read alone.
#pragma once

#include <filesystem>
#include <future>
#include <list>
#include <mutex>
#include <string>
#include <vector>

#include "animation/sample_source.h"
#include "base/file_stamp.h"
#include "scene/particles/particle_table.h"

namespace isomotion::scene {

struct FrameFiles {
    std::vector<std::filesystem::path> files;           // at least one
    std::vector<double> times;                          // ascending, of each
    std::vector<std::string> columns;                   // names in the files
    std::vector<std::optional<std::size_t>> velocities; // of each column: its column of velocities
    std::size_t most = 0;                               // the largest number of particles in a file
    base::Confines within{};                            // where files must lie when they are opened
};

class FileFrames final : public animation::SampleSource {
public:
    explicit FileFrames(FrameFiles files);
    ~FileFrames() override;

    const std::vector<double>& times() const override { return files_.times; }
    std::size_t columns() const override { return files_.columns.size(); }
    // Throws SceneError that names the file's line or byte for a value that is not a number or a
    // column that is missing, and for a file that changed since this object was made.
    Sample sample(std::size_t k, const std::vector<bool>& columns) const override;
    Successors successors(std::size_t k) const override;
    int most() const override { return int(files_.most); }
    std::optional<std::size_t> velocity_of(std::size_t column) const override {
        return files_.velocities[column];
    }
    void add_column(base::Fingerprint& print, std::size_t column) const override;
    // Includes the content of all files. If they exceed a GiB together, includes only the beginning
    // and the end of each.
    void add_rows(base::Fingerprint& print) const override;
    std::string origin(std::size_t k) const override;
    std::vector<std::string> names() const override { return files_.columns; }
    std::vector<std::filesystem::path> files() const override { return files_.files; }
    void expect_unchanged() const override;

    // For tests: the number of frames in memory or being read, and the number of files read so far.
    std::size_t frames_now() const;
    std::size_t files_read() const;

private:
    struct Frame {
        std::string format;
        std::size_t count = 0;
        std::vector<std::vector<double>> columns; // empty for columns that were not asked for
        std::vector<std::int64_t> ids;            // empty where the file has none
    };
    using FramePointer = std::shared_ptr<const Frame>;
    struct Entry {
        std::size_t frame = 0;
        std::vector<bool> columns;
        std::shared_future<FramePointer> read;
    };

    void expect_unchanged(std::size_t k) const;
    FramePointer read(std::size_t k, const std::vector<bool>& columns) const;
    FramePointer frame(std::size_t k, const std::vector<bool>& columns) const;
    // Call these while holding the lock.
    Entry* find(std::size_t k) const;
    void read_ahead(std::size_t k) const;
    bool make_room(std::size_t k) const;
    // Six, or fewer for large frames: as many as fit in 256 MiB, but at least three.
    std::size_t frames_kept() const;

    FrameFiles files_;
    std::vector<std::optional<base::FileStamp>> stamps_; // of the files when the scene was read
    mutable std::mutex mutex_;                           // guards the members below
    mutable std::list<Entry> entries_;                   // most recently used first
    mutable std::vector<bool> wanted_;
    mutable std::size_t asked_ = std::size_t(-2);
    mutable std::size_t files_read_ = 0;
    mutable std::string print_;
    struct Matched {
        std::size_t frame = 0;
        std::shared_ptr<const std::vector<std::uint32_t>> rows;
    };
    mutable Matched matched_;
};

} // namespace isomotion::scene
