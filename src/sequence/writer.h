// Files of frames, written while the next ones are rendered.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <exception>
#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include "image/encode.h"
#include "image/frame.h"
#include "sequence/names/sequence_name.h"

namespace isomotion::sequence {

// A frame's file, when it is there.
struct WrittenFile {
    std::filesystem::path file;
    std::uintmax_t bytes = 0;
    std::string hash;   // base::content_hash() of the bytes
    std::string pixels; // image::pixel_hash() of the file
};

// Encodes and writes frames while the next ones are rendered. The first error drops what waits and
// comes out of the next submit() or finish().
class SequenceWriter {
public:
    SequenceWriter(SequenceName name, image::Format format);
    // As after cancel(): frames that still wait are dropped. Call finish() to have them written.
    ~SequenceWriter();
    SequenceWriter(const SequenceWriter&) = delete;
    SequenceWriter& operator=(const SequenceWriter&) = delete;

    static constexpr std::size_t most_waiting = 4; // frames; submit() blocks when there are as many

    // Takes a frame to be written; false if the writer was cancelled and the frame dropped. `then`
    // is called from the writing thread once the file has its name; what it throws stops the
    // writer.
    bool submit(int frame, image::Frame image, std::function<void(const WrittenFile&)> then = {});

    // Waits until everything submitted is on the disk. Nothing may be submitted after.
    void finish();

    // Drops the frames that wait and lets the one being written come to its end, for which
    // finish() waits. Returns at once, from any thread, but must not be called in a signal
    // handler.
    void cancel();

private:
    struct Job {
        int frame;
        image::Frame image;
        std::function<void(const WrittenFile&)> then;
    };
    enum class State { open, finishing, stopped };

    void work();
    void write(Job job) const;
    void stop(std::exception_ptr error);
    void join();

    const SequenceName name_;
    const image::Format format_;

    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Job> waiting_;
    State state_ = State::open;
    std::exception_ptr error_;
    std::size_t submitted_ = 0;
    std::jthread worker_; // last: it uses all the above
};

} // namespace isomotion::sequence
