#include "program.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <thread>

#include <sys/wait.h>
#include <unistd.h>

namespace isomotion::cli {
namespace {

using namespace std::chrono_literals;
using std::chrono::steady_clock;

constexpr auto longest = 240s;
constexpr auto glance = 200us; // files come and go within milliseconds

// A file without a name: unlike a pipe it takes any amount while nobody reads.
class Capture {
public:
    Capture()
        : file_(std::tmpfile(), &std::fclose) {
        if (!file_) throw std::runtime_error("tmpfile");
    }
    int descriptor() const { return ::fileno(file_.get()); }
    std::string text() const {
        std::rewind(file_.get());
        std::string text;
        for (int c; (c = std::fgetc(file_.get())) != EOF;) text.push_back(char(c));
        return text;
    }

private:
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

std::vector<std::string>
changed_environment(const std::map<std::string, std::optional<std::string>>& changes) {
    std::vector<std::string> all;
    for (char** entry = environ; *entry; ++entry) {
        const std::string text = *entry;
        if (!changes.contains(text.substr(0, text.find('=')))) all.push_back(text);
    }
    for (const auto& [name, value] : changes) {
        if (value) all.push_back(name + "=" + *value);
    }
    return all;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
    std::vector<char*> all;
    for (std::string& text : texts) all.push_back(text.data());
    all.push_back(nullptr);
    return all;
}

int wait_for(pid_t child, const Circumstances& circumstances) {
    const auto begin = steady_clock::now();
    bool interrupted = !circumstances.interrupt_when;
    for (;;) {
        int status = 0;
        if (::waitpid(child, &status, WNOHANG) == child) return status;
        const auto running = steady_clock::now() - begin;
        if (running > longest) ::kill(child, SIGKILL);
        if (!interrupted && circumstances.interrupt_when(
                                std::chrono::duration_cast<std::chrono::milliseconds>(running))) {
            ::kill(child, circumstances.interrupt_signal);
            interrupted = true;
        }
        std::this_thread::sleep_for(interrupted ? 2ms : glance);
    }
}

} // namespace

std::string tested_program(const char* built) {
    const char* other = std::getenv("ISOMOTION_PROGRAM");
    return other ? other : built;
}

std::ostream& operator<<(std::ostream& to, const Ending& ending) {
    return to << "code " << ending.code << ", signal " << ending.signal << "\nstdout:\n"
              << ending.out << "stderr:\n"
              << ending.err;
}

Ending run(const std::vector<std::string>& arguments, const Circumstances& circumstances) {
    const Capture out, err;
    std::vector<std::string> words = arguments;
    std::vector<std::string> environment = changed_environment(circumstances.environment);
    const std::vector<char*> argv = pointers(words), envp = pointers(environment);
    const pid_t child = ::fork();
    if (child < 0) throw std::runtime_error("fork");
    if (child == 0) {
        ::dup2(out.descriptor(), STDOUT_FILENO);
        ::dup2(err.descriptor(), STDERR_FILENO);
        if (::chdir(circumstances.folder.c_str()) == 0) {
            ::execve(argv.front(), argv.data(), envp.data());
        }
        ::_exit(127);
    }
    const int status = wait_for(child, circumstances);
    Ending ending;
    if (WIFEXITED(status)) ending.code = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) ending.signal = WTERMSIG(status);
    ending.out = out.text();
    ending.err = err.text();
    return ending;
}

} // namespace isomotion::cli
