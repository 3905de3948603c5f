// Turns Ctrl-C into a request to stop.
#pragma once

#include <thread>

namespace isomotion::app {

// From now on SIGINT, SIGTERM and SIGHUP end the process at once with exit_interrupted, outside of
// the lifetime of a StopOnSignal. A SIGHUP that is ignored stays so.
void end_on_signal();

// During its lifetime SIGINT, SIGTERM and SIGHUP set a flag instead of ending the process, so that
// only complete files are left. A second signal of the same kind ends the process at once. So does
// the first one before work has begun, if nobody reads the flag within two seconds, since a driver
// that compiles shaders can't be stopped otherwise. Make one at a time.
class StopOnSignal {
public:
    StopOnSignal();
    ~StopOnSignal();
    StopOnSignal(const StopOnSignal&) = delete;
    StopOnSignal& operator=(const StopOnSignal&) = delete;

    bool asked() const;
    // Work has produced something: from now on a signal only sets the flag.
    void work_has_begun() const;

private:
    std::jthread watch_;
};

} // namespace isomotion::app
