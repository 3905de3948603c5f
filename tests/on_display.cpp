#include "on_display.h"

#include <cstdlib>
#include <memory>
#include <stdexcept>

#include "x_server.h"

namespace isomotion::display {
namespace {

std::unique_ptr<XServer> start_if_installed() {
    try {
        return std::make_unique<XServer>(64, 64);
    } catch (const std::runtime_error&) {
        return nullptr;
    }
}

} // namespace

OnDisplay::OnDisplay() {
    const char* given = std::getenv("DISPLAY");
    if (given && *given) return;
    static const std::unique_ptr<XServer> server = start_if_installed();
    if (!server) return;
    is_ours_ = true;
    ::setenv("DISPLAY", server->name().c_str(), 1);
}

OnDisplay::~OnDisplay() {
    if (is_ours_) ::unsetenv("DISPLAY");
}

} // namespace isomotion::display
