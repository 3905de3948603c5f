// Says in words that code of others crashed.
#pragma once

#include <string>
#include <vector>

#include <csignal>

namespace isomotion::base {

// While it lives, a crash of the process (SIGSEGV, SIGABRT and their kin, in any thread) writes
// these words to the standard error and ends the process with this exit status, instead of with the
// signal. It costs a few system calls, and no child process. Only one may live at a time.
//
// It serves code that may crash, such as a driver that is loaded. The process cleans up nothing
// before it ends: files must be whole at every moment, as those that are renamed into place are.
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
