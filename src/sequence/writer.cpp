#include "sequence/writer.h"

#include <stdexcept>
#include <utility>

#include "base/content_hash.h"
#include "base/file.h"
#include "base/partial_file.h"

namespace isomotion::sequence {

SequenceWriter::SequenceWriter(SequenceName name, image::Format format)
    : name_(std::move(name))
    , format_(format)
    , worker_([this] { work(); }) {}

SequenceWriter::~SequenceWriter() {
    cancel();
    join();
}

bool SequenceWriter::submit(int frame, image::Frame image,
                            std::function<void(const WrittenFile&)> then) {
    std::unique_lock lock(mutex_);
    name_.check_holds(submitted_ + 1);
    changed_.wait(lock, [this] { return state_ != State::open || waiting_.size() < most_waiting; });
    if (error_) std::rethrow_exception(error_);
    if (state_ == State::finishing)
        throw std::logic_error("a frame was submitted to a sequence that is finished");
    if (state_ == State::stopped) return false;
    waiting_.push_back({frame, std::move(image), std::move(then)});
    ++submitted_;
    changed_.notify_all();
    return true;
}

void SequenceWriter::finish() {
    {
        const std::lock_guard lock(mutex_);
        if (state_ == State::open) state_ = State::finishing;
        changed_.notify_all();
    }
    join();
    if (error_) std::rethrow_exception(error_);
}

void SequenceWriter::cancel() { stop(nullptr); }

void SequenceWriter::work() {
    for (;;) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return state_ != State::open || !waiting_.empty(); });
        if (waiting_.empty()) return;
        Job job = std::move(waiting_.front());
        waiting_.pop_front();
        changed_.notify_all();
        lock.unlock();
        try {
            write(std::move(job));
        } catch (...) {
            stop(std::current_exception());
        }
    }
}

void SequenceWriter::write(Job job) const {
    const std::filesystem::path file = name_.path(job.frame);
    const image::Encoded encoded = image::encode_with_hash(job.image, format_);
    job.image = {}; // its memory is free for the next frame while this one goes to the disk
    // A lone picture may go into a pipe or a device. In the place of one of many, a pipe would
    // swallow the picture.
    if (name_.holds_many()) {
        base::PartialFile partial(file);
        partial.write(encoded.bytes);
        partial.publish();
    } else {
        base::write_whole(file, encoded.bytes);
    }
    if (!job.then) return;
    job.then({file, encoded.bytes.size(), base::content_hash(encoded.bytes), encoded.pixels});
}

void SequenceWriter::stop(std::exception_ptr error) {
    const std::lock_guard lock(mutex_);
    if (!error_) error_ = std::move(error);
    state_ = State::stopped;
    waiting_.clear();
    changed_.notify_all();
}

void SequenceWriter::join() {
    if (worker_.joinable()) worker_.join();
}

} // namespace isomotion::sequence
