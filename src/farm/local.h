// Chunks rendered by several processes of this machine. On Mesa's software renderer that is what
// scales: several contexts of one process wait for each other, processes of one thread each don't.
#pragma once

#include <chrono>
#include <functional>
#include <span>
#include <string>

#include "farm/chunks.h"
#include "farm/job.h"

namespace isomotion::farm {

struct Workforce {
    std::size_t workers = 1;
    int tries = 3; // of a chunk, before it is given up
};

// Who waits for the work, and may end it.
struct Watcher {
    std::function<bool()> stop = [] { return false; };
    std::function<void(int frames_done)> progress = [](int) {};
    // What workers had to say, and why chunks failed.
    std::function<void(const std::string& text)> tell = [](const std::string&) {};
};

struct Ending {
    int code = 0;        // 0, or that of the chunk that failed last; 3 for one ended by a signal
    int failed = 0;      // chunks
    int tried_again = 0; // how often
    bool stopped = false;
};

// A worker takes the next chunk when it has done one. A chunk that fails waits behind the others to
// be tried again, and keeps the frames that it finished; one given up doesn't end the rest. Exit
// code 2, a wrong scene, is no better a second time nor for other chunks: then no more are begun.
// Throws std::system_error if no process can be started.
Ending render_locally(const Job& job, std::span<const Chunk> chunks, const Workforce& workforce,
                      const Watcher& watcher);

// One such process for the words, watched in the same way: joins the movie.
Ending run_locally(const std::vector<std::string>& words, const Watcher& watcher);

} // namespace isomotion::farm
