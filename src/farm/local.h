// Renders chunks by several processes on this machine. With Mesa's software renderer only this
// scales: several contexts of one process wait for each other, single-threaded processes don't.
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
    int tries = 3; // attempts per chunk before it is given up
};

// Observes the work, and may stop it.
struct Watcher {
    std::function<bool()> stop = [] { return false; };
    std::function<void(int frames_done)> progress = [](int) {};
    // Receives messages of workers, and the reasons why chunks failed.
    std::function<void(const std::string& text)> tell = [](const std::string&) {};
};

struct Ending {
    int code = 0;        // 0, or the exit code of the last failed chunk; 3 if a signal ended it
    int failed = 0;      // chunks
    int tried_again = 0; // number of repeated attempts
    bool stopped = false;
};

// A worker takes the next chunk when it has finished one. A chunk that fails waits behind the
// others to be tried again, and keeps its finished frames; a chunk that is given up doesn't end the
// rest. After exit code 2, a wrong scene, no more chunks are begun, since neither a second attempt
// nor another chunk would succeed. Throws std::system_error if no process can be started.
Ending render_locally(const Job& job, std::span<const Chunk> chunks, const Workforce& workforce,
                      const Watcher& watcher);

// Runs one such process for the words, observed in the same way: joins the movie.
Ending run_locally(const std::vector<std::string>& words, const Watcher& watcher);

} // namespace isomotion::farm
