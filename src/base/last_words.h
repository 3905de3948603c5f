#pragma once

#include <string>
#include <vector>

#include <csignal>

namespace isomotion::base {

/// While it lives, a crash of the process (SIGSEGV, SIGABRT and their kin, in any thread) writes
/// these words to the standard error and ends the process with this exit status, instead of with
/// the signal. It costs a few system calls, and no child process. One at a time.
///
/// For code of others that may crash, such as a driver that is loaded. Nothing of the process is
/// put in order, so it belongs where no file is half written.
class LastWords {
public:
    LastWords(std::string words, int exit_status);
    ~LastWords();
    LastWords(const LastWords&) = delete;
    LastWords& operator=(const LastWords&) = delete;

private:
    struct Saved {
        int signal;
        struct sigaction action;
    };
    std::string words_;
    std::vector<Saved> saved_;
};

} // namespace isomotion::base
