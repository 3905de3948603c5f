#include "base/child_process.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <memory>
#include <string_view>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <fmt/format.h>

namespace isomotion::base {
namespace {

class SpawnActions {
public:
    SpawnActions() { ::posix_spawn_file_actions_init(&actions_); }
    ~SpawnActions() { ::posix_spawn_file_actions_destroy(&actions_); }
    SpawnActions(const SpawnActions&) = delete;
    SpawnActions& operator=(const SpawnActions&) = delete;

    void duplicate(const FileDescriptor& from, int to) {
        ::posix_spawn_file_actions_adddup2(&actions_, from.number(), to);
    }
    void discard(int descriptor) {
        ::posix_spawn_file_actions_addopen(&actions_, descriptor, "/dev/null", O_WRONLY, 0);
    }
    const posix_spawn_file_actions_t* get() const { return &actions_; }

private:
    posix_spawn_file_actions_t actions_;
};

// Signals that this program ignores, so that writes fail instead, are not ignored by the programs
// that it starts: many count on SIGPIPE to end.
class SpawnAttributes {
public:
    SpawnAttributes() {
        ::posix_spawnattr_init(&attributes_);
        sigset_t signals;
        ::sigemptyset(&signals);
        ::sigaddset(&signals, SIGPIPE);
        ::posix_spawnattr_setsigdefault(&attributes_, &signals);
        ::posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGDEF);
    }
    ~SpawnAttributes() { ::posix_spawnattr_destroy(&attributes_); }
    SpawnAttributes(const SpawnAttributes&) = delete;
    SpawnAttributes& operator=(const SpawnAttributes&) = delete;

    const posix_spawnattr_t* get() const { return &attributes_; }

private:
    posix_spawnattr_t attributes_;
};

// The status of a process whose end nobody can tell, as where the kernel was told to forget how
// processes end (SIGCHLD ignored): exit status 255, no success.
constexpr int unknown_ending = 255 << 8;

[[noreturn]] void fail(const char* attempt, int code) {
    throw std::system_error(code, std::generic_category(), attempt);
}

FileDescriptor memory_file() {
    FileDescriptor file(::memfd_create("messages", MFD_CLOEXEC));
    if (!file) fail("memfd_create", errno);
    return file;
}

struct Ending {
    std::string text;
    bool is_whole = true; // nothing came before it
};

// The last bytes of a file, at most so many.
Ending end_of(const FileDescriptor& file, off_t most) {
    struct stat found = {};
    if (!file || ::fstat(file.number(), &found) != 0) return {};
    std::string text(std::size_t(std::min(found.st_size, most)), '\0');
    const ssize_t count =
        ::pread(file.number(), text.data(), text.size(), std::max<off_t>(found.st_size - most, 0));
    text.resize(std::size_t(std::max<ssize_t>(count, 0)));
    return {std::move(text), found.st_size <= most};
}

bool is_executable(const std::filesystem::path& file) {
    struct stat found = {};
    return ::stat(file.c_str(), &found) == 0 && S_ISREG(found.st_mode) &&
           ::access(file.c_str(), X_OK) == 0;
}

} // namespace

std::optional<std::filesystem::path> find_program(const std::string& name) {
    // Not posix_spawnp(), which looks in /usr/bin too when there is no PATH.
    const char* variable = std::getenv("PATH");
    std::string_view folders = variable ? variable : "";
    while (!folders.empty()) {
        const std::string_view folder = folders.substr(0, folders.find(':'));
        folders.remove_prefix(std::min(folder.size() + 1, folders.size()));
        if (folder.empty()) continue;
        const std::filesystem::path file = std::filesystem::path(folder) / name;
        if (is_executable(file)) return file;
    }
    return std::nullopt;
}

ChildProcess::ChildProcess(const std::filesystem::path& program,
                           const std::vector<std::string>& arguments, Output output) {
    // A socket instead of a pipe: only send() can be told not to raise SIGPIPE.
    int ends[2];
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) fail("socketpair", errno);
    input_ = FileDescriptor(ends[0]);
    const FileDescriptor child_end(ends[1]);
    // Its messages go to memory, which cannot fill up and block it as a pipe nobody reads would.
    errors_ = memory_file();
    if (output == Output::keep) output_ = memory_file();

    SpawnActions actions;
    actions.duplicate(child_end, STDIN_FILENO);
    if (output == Output::keep) {
        actions.duplicate(output_, STDOUT_FILENO);
    } else {
        actions.discard(STDOUT_FILENO);
    }
    actions.duplicate(errors_, STDERR_FILENO);

    std::vector<std::string> words{program.string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> vector;
    vector.reserve(words.size() + 1);
    for (std::string& word : words) vector.push_back(word.data());
    vector.push_back(nullptr);
    const SpawnAttributes attributes;
    const int code = ::posix_spawn(&id_, program.c_str(), actions.get(), attributes.get(),
                                   vector.data(), environ);
    if (code != 0) {
        id_ = -1;
        fail(program.c_str(), code);
    }
}

ChildProcess::~ChildProcess() {
    if (id_ < 0) return;
    ::kill(id_, SIGKILL);
    finish();
}

bool ChildProcess::feed(std::span<const std::byte> bytes, const Stop& stop) {
    constexpr int glance = 50; // ms
    while (!bytes.empty()) {
        pollfd waiting{input_.number(), POLLOUT, 0};
        while (stop && ::poll(&waiting, 1, glance) <= 0) {
            if (stop()) return false;
        }
        const int how = MSG_NOSIGNAL | (stop ? MSG_DONTWAIT : 0); // some room is not room for all
        const ssize_t sent = ::send(input_.number(), bytes.data(), bytes.size(), how);
        if (sent < 0 && (errno == EINTR || errno == EAGAIN)) continue;
        if (sent < 0) return false;
        bytes = bytes.subspan(std::size_t(sent));
    }
    return true;
}

bool ChildProcess::finish() {
    input_.close();
    wait();
    return succeeded();
}

void ChildProcess::wait() {
    if (id_ < 0) return;
    pid_t waited = -1;
    while ((waited = ::waitpid(id_, &status_, 0)) < 0 && errno == EINTR) {
    }
    if (waited != id_) status_ = unknown_ending;
    input_.close();
    id_ = -1;
}

bool ChildProcess::ends_before(const Stop& stop) {
    using namespace std::chrono_literals;
    input_.close();
    while (!ended()) {
        if (stop && stop()) {
            ::kill(id_, SIGKILL);
            finish();
            return false;
        }
        std::this_thread::sleep_for(2ms);
    }
    return true;
}

bool ChildProcess::finish_unless(const Stop& stop) { return ends_before(stop) && succeeded(); }

bool ChildProcess::finish_by(std::chrono::steady_clock::time_point deadline) {
    return ends_before([deadline] { return std::chrono::steady_clock::now() > deadline; });
}

bool ChildProcess::ended() {
    if (id_ < 0) return true;
    const pid_t waited = ::waitpid(id_, &status_, WNOHANG);
    if (waited < 0 && errno == ECHILD) {
        status_ = unknown_ending;
    } else if (waited != id_) {
        return false;
    }
    input_.close();
    id_ = -1;
    return true;
}

void ChildProcess::interrupt() {
    if (id_ >= 0) ::kill(id_, SIGINT);
}

void ChildProcess::terminate() {
    if (id_ >= 0) ::kill(id_, SIGTERM);
}

bool ChildProcess::succeeded() const { return WIFEXITED(status_) && WEXITSTATUS(status_) == 0; }

std::optional<int> ChildProcess::exit_status() const {
    if (!WIFEXITED(status_)) return std::nullopt;
    return WEXITSTATUS(status_);
}

std::string ChildProcess::ending() const {
    return WIFSIGNALED(status_) ? fmt::format("signal {}", WTERMSIG(status_))
                                : fmt::format("exit status {}", WEXITSTATUS(status_));
}

std::string ChildProcess::output() const { return end_of(output_, 1 << 24).text; }

std::string ChildProcess::last_words(std::size_t lines) const {
    constexpr off_t most = 64 << 10;
    auto [text, is_whole] = end_of(errors_, most);
    if (!is_whole) text.erase(0, text.find('\n') + 1); // what is left of a line
    while (text.ends_with('\n')) text.pop_back();

    std::size_t begin = text.size();
    for (; lines > 0 && begin > 0; --lines) {
        const std::size_t newline = text.rfind('\n', begin - 1);
        begin = newline == std::string::npos ? 0 : newline;
    }
    // It is said that words are left out only if fewer lines are here than were asked for.
    const bool lacks_some = !is_whole && begin == 0 && lines > 0;
    text.erase(0, text[begin] == '\n' ? begin + 1 : begin);
    return lacks_some ? "... earlier words left out\n" + text : text;
}

} // namespace isomotion::base
