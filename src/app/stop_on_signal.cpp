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
#include "base/write_at_once.h"

namespace isomotion::app {
namespace {

std::atomic<bool> stop{false}, heard{false}, begun{false};
static_assert(std::atomic<bool>::is_always_lock_free, "written by a signal handler");

constexpr int signals[] = {SIGINT, SIGTERM, SIGHUP};

// Whoever starts the program may let it outlive the terminal (nohup).
bool is_ignored(int signal) {
    struct sigaction now {};
    return signal == SIGHUP && sigaction(signal, nullptr, &now) == 0 &&
           now.sa_handler == SIG_IGN; // NOLINT: the standard's macro casts
}

void handle(int signal, void (*handler)(int)) {
    if (is_ignored(signal)) return;
    struct sigaction action {};
    action.sa_handler = handler;
    sigaction(signal, &action, nullptr);
}

void end_at_once(int) {
    base::write_at_once(STDERR_FILENO, "stopped\n");
    ::_exit(exit_interrupted);
}

// The second time the program ends at once. A terminal that closes is told of by the system and by
// the shell, so that two hangups are one.
void ask_to_stop(int signal) {
    if (stop.exchange(true) && signal != SIGHUP) end_at_once(signal);
}

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

void end_on_signal() {
    for (const int signal : signals) handle(signal, end_at_once);
}

StopOnSignal::StopOnSignal() {
    stop = heard = begun = false;
    for (const int signal : signals) handle(signal, ask_to_stop);
    watch_ = std::jthread(watch);
}

StopOnSignal::~StopOnSignal() { end_on_signal(); }

void StopOnSignal::work_has_begun() const { begun = true; }

bool StopOnSignal::asked() const {
    if (stop) heard = true;
    return stop;
}

} // namespace isomotion::app
