// Writes files of frames while the next ones are rendered.
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

// A frame's finished file.
struct WrittenFile {
    std::filesystem::path file;
    std::uintmax_t bytes = 0;
    std::string hash;   // base::content_hash() of the bytes
    std::string pixels; // image::pixel_hash() of the file
};

// Encodes and writes frames while the next ones are rendered. After the first error waiting frames
// are dropped, and the next submit() or finish() throws it.
class SequenceWriter {
public:
    SequenceWriter(SequenceName name, image::Format format);
    // Drops waiting frames, like cancel(). Call finish() to have them written.
    ~SequenceWriter();
    SequenceWriter(const SequenceWriter&) = delete;
    SequenceWriter& operator=(const SequenceWriter&) = delete;

    static constexpr std::size_t most_waiting = 4; // frames; submit() blocks while so many wait

    // Takes a frame to be written. Returns false if the writer was cancelled and the frame dropped.
    // The writing thread calls `then` once the file has its name; an exception from it stops the
    // writer.
    bool submit(int frame, image::Frame image, std::function<void(const WrittenFile&)> then = {});

    // Waits until everything submitted is on the disk. Nothing may be submitted afterwards.
    void finish();

    // Drops waiting frames; the frame being written is completed, for which finish() waits. Returns
    // at once. May be called from any thread, but not in a signal handler.
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
    std::jthread worker_; // last: it uses all members above
};

} // namespace isomotion::sequence
