// Turns Ctrl-C into a request to stop.
#pragma once

#include <thread>

namespace isomotion::app {

// While it lives, SIGINT and SIGTERM set a flag and do not end the process, so that only whole
// files are left. A second signal of the same kind ends it at once, and so does the first where
// nobody asks for the flag within two seconds, as while a driver compiles a shader. Make one at a
// time.
class StopOnSignal {
public:
    StopOnSignal();
    ~StopOnSignal();
    StopOnSignal(const StopOnSignal&) = delete;
    StopOnSignal& operator=(const StopOnSignal&) = delete;

    bool asked() const;

private:
    std::jthread watch_;
};

} // namespace isomotion::app
