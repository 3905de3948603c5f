// Turns Ctrl-C into a request to stop.
#pragma once

#include <thread>

namespace isomotion::app {

// While it lives, SIGINT and SIGTERM set a flag and do not end the process, so that only whole
// files are left. A second signal of the same kind ends it at once. So does the first before the
// work has begun, where nobody asks for the flag within two seconds: a driver that compiles shaders
// can't be stopped otherwise. Make one at a time.
class StopOnSignal {
public:
    StopOnSignal();
    ~StopOnSignal();
    StopOnSignal(const StopOnSignal&) = delete;
    StopOnSignal& operator=(const StopOnSignal&) = delete;

    bool asked() const;
    // Something was drawn or found: from now on a signal waits until it is asked for.
    void work_has_begun() const;

private:
    std::jthread watch_;
};

} // namespace isomotion::app
