#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <sys/types.h>

#include "base/file_descriptor.h"

namespace isomotion::base {

/// Finds the program of that name in the folders of PATH.
std::optional<std::filesystem::path> find_program(const std::string& name);

/// Whether a program's standard output is kept.
enum class Output { discard, keep };

/// A running program that gets its input through its standard input, started without a shell. The
/// destructor kills it if it still runs.
class ChildProcess {
public:
    /// Throws a std::system_error if the program cannot be started.
    ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                 Output output = Output::discard);
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// Called now and then while this class waits; true ends the waiting.
    using Stop = std::function<bool()>;

    /// Passes bytes to the program. Returns false if the program no longer takes any, or if
    /// stopped.
    bool feed(std::span<const std::byte> bytes, const Stop& stop = {});

    /// Closes the input and waits for the program. Returns true if it ended with exit status 0.
    bool finish();

    /// The same, but once `stop` returns true the program is killed and the result is false.
    bool finish_unless(const Stop& stop);

    /// Closes the input and waits for the program; kills it if it still runs at the deadline.
    /// Returns true if it ended by itself, with any status.
    bool finish_by(std::chrono::steady_clock::time_point deadline);

    /// Whether it has ended. Does not wait.
    bool ended();

    /// Sends SIGINT, as Ctrl-C does.
    void interrupt();

    /// Sends SIGTERM. Ctrl-C at a terminal reaches the program too, and a second interrupt would
    /// leave it no time to put its files in order. Then call wait(), with its input still open.
    void terminate();

    /// Waits for the program without closing its input. A worker of a farm takes a closed input as
    /// its farm's end, and so as a second SIGTERM.
    void wait();

    /// Only after finish() or wait(), or once it has ended().
    bool succeeded() const;
    /// How it ended: "exit status 1", "signal 9".
    std::string ending() const;
    /// Its exit status; empty if a signal ended it.
    std::optional<int> exit_status() const;

    /// Its standard output so far, if that is kept.
    std::string output() const;

    /// The last lines of its standard error.
    std::string last_words(std::size_t lines) const;

private:
    bool ends_before(const Stop& stop);

    FileDescriptor input_;
    FileDescriptor output_;
    FileDescriptor errors_;
    pid_t id_ = -1;
    int status_ = 0;
};

} // namespace isomotion::base
