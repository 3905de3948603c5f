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

/// The program of that name in the folders of PATH.
std::optional<std::filesystem::path> find_program(const std::string& name);

/// What becomes of what a program writes to its standard output.
enum class Output { discard, keep };

/// A running program that is fed through its standard input, started without a shell. It is killed
/// if it still runs when this object goes.
class ChildProcess {
public:
    /// Throws a std::system_error if the program cannot be started.
    ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                 Output output = Output::discard);
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// Asked now and then while something is waited for; true ends the waiting.
    using Stop = std::function<bool()>;

    /// Hands the bytes over; false if the program no longer takes any, or if it was stopped.
    bool feed(std::span<const std::byte> bytes, const Stop& stop = {});

    /// Ends the input and waits for the program: true if it ended with exit status 0.
    bool finish();

    /// The same, but the program is killed, and this is false, once `stop` says so.
    bool finish_unless(const Stop& stop);

    /// Ends the input and waits for the program, which is killed if it still runs at this time:
    /// true if it ended by itself, however it did.
    bool finish_by(std::chrono::steady_clock::time_point deadline);

    /// Whether it has ended; does not wait for it.
    bool ended();

    /// Asks it to end, as Ctrl-C does.
    void interrupt();

    /// Asks it to end by SIGTERM: Ctrl-C at a terminal reaches it too, and a second interrupt would
    /// not leave it the time to put its files in order. wait() for it, with its input open.
    void terminate();

    /// Waits for the program without ending its input, which a worker of a farm takes for its
    /// farm's end, so for a second SIGTERM.
    void wait();

    /// Only after finish() or wait(), or once it has ended().
    bool succeeded() const;
    /// How it ended: "exit status 1", "signal 9".
    std::string ending() const;
    /// What it returned; nothing if a signal ended it.
    std::optional<int> exit_status() const;

    /// What it wrote to its standard output so far, where that is kept.
    std::string output() const;

    /// The last lines it wrote to its standard error.
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
