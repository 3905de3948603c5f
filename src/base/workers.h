// A loop whose iterations are shared by threads.
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace isomotion::base {

struct SharedLoop {
    std::size_t count = 0;
    int threads = 1; // including the caller's
    // Called from any thread, before each iteration; once it returns true no more are started.
    std::function<bool()> stopped{};
    // The finished part of the iterations. It never decreases, and is called from one thread at a
    // time.
    std::function<void(double part)> progress{};
};

// Each thread makes its own worker; worker(k) is called for all k below the count. An exception of
// a worker ends the loop. The first one is rethrown once all threads have ended.
template<class MakeWorker> void share(const SharedLoop& loop, const MakeWorker& make_worker) {
    std::atomic<std::size_t> next{0};
    std::atomic<bool> ended{false};
    std::mutex telling;
    std::size_t done = 0;
    std::exception_ptr thrown;
    const auto work = [&] {
        try {
            auto worker = make_worker();
            for (std::size_t k = next++; k < loop.count && !ended; k = next++) {
                if (loop.stopped && loop.stopped()) break;
                worker(k);
                const std::lock_guard lock(telling);
                ++done;
                if (loop.progress) loop.progress(double(done) / double(loop.count));
            }
        } catch (...) {
            const std::lock_guard lock(telling);
            if (!thrown) thrown = std::current_exception();
            ended = true;
        }
    };
    {
        std::vector<std::jthread> others;
        try {
            for (int k = 1; k < loop.threads && std::size_t(k) < loop.count; ++k)
                others.emplace_back(work);
        } catch (const std::system_error&) { // no more threads are available; go on with fewer
        }
        work();
    }
    if (thrown) std::rethrow_exception(thrown);
}

} // namespace isomotion::base
