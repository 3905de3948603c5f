#include "farm/local.h"

#include <algorithm>
#include <csignal>
#include <deque>
#include <memory>
#include <thread>

#include <fmt/format.h>

#include "animation/frame_range.h"
#include "base/child_process.h"
#include "sequence/names/sequence_name.h"

namespace isomotion::farm {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

constexpr std::chrono::milliseconds glance{10};
constexpr int code_of_usage = 2, code_of_machine = 3, code_of_stopping = 130; // the program's own

struct Task {
    std::size_t chunk;
    int attempt; // from 1
};

base::ChildProcess start(Words words) {
    words.push_back("--quiet"); // nobody reads its standard output
    return {words.front(), Words(words.begin() + 1, words.end())};
}

// `isomotion render` for one chunk.
class Worker {
public:
    Worker(const Job& job, Task given, const Chunk& frames)
        : task(given)
        , process(start(chunk_words(job, animation::frame_range(frames))))
        , frames_(frames) {}

    // Its frames written so far, by their files; those that were there before count at the end.
    int written(const sequence::SequenceName& name) {
        for (; written_ < int(frames_.size()); ++written_) {
            std::error_code error;
            const auto time = fs::last_write_time(name.path(frames_[std::size_t(written_)]), error);
            if (error || time < begin_) break;
        }
        return written_;
    }

    const Task task;
    base::ChildProcess process;

private:
    const Chunk& frames_;
    int written_ = 0;
    // File systems keep times more coarsely than clocks do.
    fs::file_time_type begin_ = fs::file_time_type::clock::now() - std::chrono::seconds(1);
};

class LocalFarm {
public:
    LocalFarm(const Job& job, std::span<const Chunk> chunks, const Workforce& workforce,
              const Watcher& watcher)
        : job_(job)
        , chunks_(chunks)
        , workforce_(workforce)
        , watcher_(watcher)
        , name_(sequence::SequenceName::parse(job.output.string())) {
        for (std::size_t k = 0; k < chunks.size(); ++k) waiting_.push_back({k, 1});
    }

    Ending run() {
        while (!watcher_.stop()) {
            collect();
            hand_out();
            if (working_.empty()) return ending_;
            watcher_.progress(frames_done());
            std::this_thread::sleep_for(glance);
        }
        for (const auto& worker : working_) worker->process.terminate();
        for (const auto& worker : working_) {
            worker->process.wait();
            if (!is_stopped(*worker)) tell_of_end(*worker, "asked to stop");
        }
        ending_.stopped = true;
        return ending_;
    }

private:
    void hand_out() {
        while (working_.size() < workforce_.workers && !waiting_.empty()) {
            const Task task = waiting_.front();
            waiting_.pop_front();
            working_.push_back(std::make_unique<Worker>(job_, task, chunks_[task.chunk]));
        }
    }

    void collect() {
        std::erase_if(working_, [this](const std::unique_ptr<Worker>& worker) {
            if (!worker->process.ended()) return false;
            worker->process.succeeded() ? done(*worker) : failed(*worker);
            return true;
        });
    }

    void done(const Worker& worker) {
        done_ += int(chunks_[worker.task.chunk].size());
        constexpr std::size_t all = 1000; // warnings of its frames
        if (const auto words = worker.process.last_words(all); !words.empty()) watcher_.tell(words);
    }

    void failed(const Worker& worker) {
        const base::ChildProcess& process = worker.process;
        const int code = process.exit_status().value_or(code_of_machine);
        const bool last = worker.task.attempt >= workforce_.tries || code == code_of_usage;
        tell_of_end(worker, fmt::format("try {} of {}{}", worker.task.attempt, workforce_.tries,
                                        last ? ": given up" : ""));
        if (!last) {
            waiting_.push_back({worker.task.chunk, worker.task.attempt + 1});
            ++ending_.tried_again;
            return;
        }
        ++ending_.failed;
        ending_.code = code;
        if (code == code_of_usage) waiting_.clear();
    }

    void tell_of_end(const Worker& worker, const std::string& when) {
        std::string text = fmt::format("frames {}: render ended with {}, {}",
                                       animation::frame_range(chunks_[worker.task.chunk]),
                                       worker.process.ending(), when);
        const std::string words = worker.process.last_words(6);
        if (!words.empty()) text += ":\n" + words;
        watcher_.tell(text);
    }

    // SIGTERM ends a process that has not begun, or is done; between frames it would leave one
    // half.
    bool is_stopped(Worker& worker) {
        if (const auto code = worker.process.exit_status()) {
            return *code == 0 || *code == code_of_stopping;
        }
        const int written = worker.written(name_);
        const bool is_between = 0 < written && written < int(chunks_[worker.task.chunk].size());
        return !is_between && worker.process.ending() == fmt::format("signal {}", SIGTERM);
    }

    int frames_done() {
        int frames = done_;
        for (const auto& worker : working_) frames += worker->written(name_);
        return frames;
    }

    const Job& job_;
    std::span<const Chunk> chunks_;
    const Workforce& workforce_;
    const Watcher& watcher_;
    sequence::SequenceName name_;
    std::deque<Task> waiting_;
    std::vector<std::unique_ptr<Worker>> working_;
    int done_ = 0; // frames of chunks that are done
    Ending ending_;
};

} // namespace

Ending render_locally(const Job& job, std::span<const Chunk> chunks, const Workforce& workforce,
                      const Watcher& watcher) {
    return LocalFarm(job, chunks, workforce, watcher).run();
}

Ending run_locally(const Words& words, const Watcher& watcher) {
    base::ChildProcess process = start(words);
    while (!process.ended()) {
        if (watcher.stop()) {
            process.terminate();
            process.wait();
            return {.stopped = true};
        }
        std::this_thread::sleep_for(glance);
    }
    if (const auto words_left = process.last_words(20); !words_left.empty()) {
        watcher.tell(words_left);
    }
    return {.code = process.exit_status().value_or(code_of_machine)};
}

} // namespace isomotion::farm
