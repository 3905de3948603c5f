#include "app/console.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include "base/printable_message.h"

namespace isomotion::app {

void keep_standard_descriptors() {
    for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(number, F_GETFD) >= 0 || errno != EBADF) continue;
        // open() gives the lowest number that is free, which is this one.
        ::open("/dev/null", number == STDERR_FILENO ? O_WRONLY : O_RDONLY);
    }
}

void end_with_input() {
    if (!std::getenv(ends_with_input)) return;
    std::thread([] {
        pollfd input{STDIN_FILENO, 0, 0}; // POLLHUP alone
        while (::poll(&input, 1, -1) < 0 && errno == EINTR) {
        }
        ::kill(::getpid(), SIGTERM);
    }).detach();
}

namespace {

int output_error = 0; // of the first result that could not be written

} // namespace

// Flushes stdout first, so that earlier results stand before the message in one terminal or file.
void write_message(std::string_view text) {
    errno = 0;
    if (std::fflush(stdout) != 0 && !output_error) output_error = errno ? errno : EIO;
    control_terminal(base::printable_message(text));
}

void control_terminal(std::string_view text) {
    std::fwrite(text.data(), 1, text.size(), stderr);
    std::fflush(stderr);
}

void write_result(std::string_view text) {
    errno = 0;
    if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() || output_error) return;
    output_error = errno ? errno : EIO;
}

bool finish_output() {
    errno = 0;
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return true;
    const int code = output_error ? output_error : errno ? errno : EIO;
    message("standard output cannot be written: {}\n", std::strerror(code));
    return false;
}

} // namespace isomotion::app
