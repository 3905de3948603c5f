#include "app/stop_on_signal.h"

#include <atomic>
#include <csignal>

namespace isomotion::app {
namespace {

std::atomic<bool> stop{false};
static_assert(std::atomic<bool>::is_always_lock_free, "written by a signal handler");

constexpr int signals[] = {SIGINT, SIGTERM};

} // namespace

StopOnSignal::StopOnSignal() {
    stop = false;
    for (const int signal : signals) {
        struct sigaction action {};
        action.sa_handler = [](int) { stop = true; };
        action.sa_flags = static_cast<int>(SA_RESETHAND);
        sigaction(signal, &action, nullptr);
    }
}

StopOnSignal::~StopOnSignal() {
    for (const int signal : signals) std::signal(signal, SIG_DFL);
}

bool StopOnSignal::asked() const { return stop; }

} // namespace isomotion::app
