#include "base/write_at_once.h"

#include <poll.h>
#include <unistd.h>

namespace isomotion::base {

void write_at_once(int descriptor, std::string_view words) {
    pollfd ready{descriptor, POLLOUT, 0};
    if (::poll(&ready, 1, 0) != 1 || !(ready.revents & POLLOUT)) return;
    // Nothing is left to do where the words cannot be written.
    [[maybe_unused]] const auto written = ::write(descriptor, words.data(), words.size());
}

} // namespace isomotion::base
