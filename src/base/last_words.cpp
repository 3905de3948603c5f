#include "base/last_words.h"

#include <array>
#include <cstddef>
#include <utility>

#include <unistd.h>

#include "base/write_at_once.h"

namespace isomotion::base {
namespace {

constexpr std::array crashes{SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT};

// What a handler may read: it must not take memory, nor a lock.
const char* text = nullptr;
std::size_t length = 0;
int status = 0;

extern "C" void end_with_words(int) {
    write_at_once(STDERR_FILENO, {text, length});
    ::_exit(status);
}

} // namespace

LastWords::LastWords(std::string words, int exit_status)
    : words_(std::move(words)) {
    text = words_.data();
    length = words_.size();
    status = exit_status;
    saved_.reserve(crashes.size());
    struct sigaction handling = {};
    handling.sa_handler = end_with_words;
    ::sigemptyset(&handling.sa_mask);
    for (const int signal : crashes) {
        Saved saved{signal, {}};
        if (::sigaction(signal, &handling, &saved.action) == 0) saved_.push_back(saved);
    }
}

LastWords::~LastWords() {
    for (const Saved& saved : saved_) ::sigaction(saved.signal, &saved.action, nullptr);
}

} // namespace isomotion::base
