// An X server of our own, where nobody looks: Xvfb, on a display that was free.
#pragma once

#include <filesystem>
#include <string>

#include <sys/types.h>

namespace isomotion::display {

class XServer {
public:
    // Keeps its screen in a file of `folder`, or in memory without one. Throws std::runtime_error
    // where Xvfb is not installed or does not start.
    XServer(int width, int height, const std::filesystem::path& folder = {});
    ~XServer();
    XServer(const XServer&) = delete;
    XServer& operator=(const XServer&) = delete;

    const std::string& name() const { return name_; } // ":7"
    void end();                                       // as when the machine is shut down

private:
    pid_t server_ = -1;
    std::string name_;
};

} // namespace isomotion::display
