#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <exception>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "image/encode.h"
#include "image/frame.h"

namespace isomotion::image {

/// The name of a sequence of files: `out/name.####.exr` or `out/name.%04d.exr`, with one place for
/// the frame's number in the last part; or a name without a place, which holds one frame.
class SequenceName {
public:
    /// Throws an ImageError for more than one place.
    static SequenceName parse(std::string_view text);

    /// The file of a frame: the number padded with zeros, with more digits where it needs them.
    std::filesystem::path path(int frame) const;

    /// The frame whose path() has that last part, or none.
    std::optional<int> frame_of(const std::string& file) const;

    const std::filesystem::path& folder() const { return folder_; }
    /// The last part as `name.####.exr`, however the place was written.
    std::string pattern() const;
    /// The last part without the place and the extension, and the point before either: `name`;
    /// empty if nothing is left.
    std::string stem() const;

    bool holds_many() const { return has_place_; }

    /// Throws an ImageError if the name has no place for the numbers of that many frames.
    void check_holds(std::size_t frames) const;

private:
    std::filesystem::path folder_;
    std::string before_;
    std::string after_;
    int digits_ = 0;
    bool has_place_ = false;
};

/// A frame's file, when it is there.
struct Written {
    std::filesystem::path file;
    std::uintmax_t bytes = 0;
    std::string hash;   ///< content_hash() of the bytes
    std::string pixels; ///< pixel_hash() of the file
};

struct SequenceOptions {
    int threads = 1;
    std::size_t capacity = 4; ///< frames that may wait; submit() blocks when there are as many
    /// Called after each file is complete, from a writing thread, never twice at once.
    std::function<void(int frame, const std::filesystem::path& file)> on_written = {};
};

/// Encodes and writes frames while the next ones are rendered. The first error drops what waits and
/// comes out of the next submit() or finish().
class SequenceWriter {
public:
    SequenceWriter(SequenceName name, Format format, SequenceOptions options = {});
    /// As after cancel(): frames that still wait are dropped. Call finish() to have them written.
    ~SequenceWriter();
    SequenceWriter(const SequenceWriter&) = delete;
    SequenceWriter& operator=(const SequenceWriter&) = delete;

    /// Takes a frame to be written; false if the writer was cancelled and the frame dropped. `then`
    /// is called from a writing thread once the file has its name; what it throws stops the writer.
    bool submit(int frame, Frame image, std::function<void(const Written&)> then = {});

    /// Waits until everything submitted is on the disk. Nothing may be submitted after.
    void finish();

    /// Drops the frames that wait and lets those being written come to their end, for which
    /// finish() waits. Returns at once, from any thread, but must not be called in a signal
    /// handler.
    void cancel();

    /// Frames on the disk so far.
    std::size_t written() const;

private:
    struct Job {
        int frame;
        Frame image;
        std::function<void(const Written&)> then;
    };
    enum class State { open, finishing, stopped };

    void work();
    void write(Job job);
    void stop(std::exception_ptr error);
    void join();

    const SequenceName name_;
    const Format format_;
    const SequenceOptions options_;

    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Job> waiting_;
    State state_ = State::open;
    std::exception_ptr error_;
    std::size_t submitted_ = 0;
    std::size_t written_ = 0;
    std::mutex reporting_;
    std::vector<std::jthread> workers_; // last: they use all the above
};

} // namespace isomotion::image
