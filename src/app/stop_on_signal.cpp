#include "app/stop_on_signal.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <cstdio>
#include <mutex>

#include <unistd.h>

#include "app/commands.h"
#include "app/console.h"

namespace isomotion::app {
namespace {

std::atomic<bool> stop{false}, heard{false}, begun{false};
static_assert(std::atomic<bool>::is_always_lock_free, "written by a signal handler");

constexpr int signals[] = {SIGINT, SIGTERM};

// Ends the process in place of a thread that is in a driver's hands.
void watch(const std::stop_token& over) {
    using namespace std::chrono_literals;
    constexpr auto glance = 100ms, patience = 2000ms;
    std::mutex mutex;
    std::condition_variable_any waiting;
    std::unique_lock lock(mutex);
    for (auto waited = 0ms; waited < patience; waited += stop ? glance : 0ms) {
        waiting.wait_for(lock, over, glance, [] { return false; }); // at once when it is over
        if (over.stop_requested() || heard || begun) return;
    }
    write_message("stopped\n");
    std::fflush(stdout);
    ::_exit(exit_interrupted);
}

} // namespace

StopOnSignal::StopOnSignal() {
    stop = heard = begun = false;
    for (const int signal : signals) {
        struct sigaction action {};
        action.sa_handler = [](int) { stop = true; };
        action.sa_flags = static_cast<int>(SA_RESETHAND);
        sigaction(signal, &action, nullptr);
    }
    watch_ = std::jthread(watch);
}

StopOnSignal::~StopOnSignal() {
    for (const int signal : signals) std::signal(signal, SIG_DFL);
}

void StopOnSignal::work_has_begun() const { begun = true; }

bool StopOnSignal::asked() const {
    if (stop) heard = true;
    return stop;
}

} // namespace isomotion::app
