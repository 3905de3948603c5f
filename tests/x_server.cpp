#include "x_server.h"

#include <csignal>
#include <cstdio>
#include <stdexcept>
#include <vector>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace isomotion::display {

XServer::XServer(int width, int height, const std::filesystem::path& folder) {
    int told[2];
    if (::pipe(told) != 0) throw std::runtime_error("pipe");
    std::vector<std::string> words{"Xvfb", "-displayfd", std::to_string(told[1]), "-screen", "0"};
    words.push_back(std::to_string(width) + "x" + std::to_string(height) + "x24");
    // By itself it begins anew when a window was the last, and refuses the next meanwhile.
    words.insert(words.end(), {"-nolisten", "tcp", "-noreset"});
    if (!folder.empty()) words.insert(words.end(), {"-fbdir", folder.string()});
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    server_ = ::fork();
    if (server_ == 0) {
        ::prctl(PR_SET_PDEATHSIG, SIGTERM); // a test that crashes leaves none behind
        ::close(told[0]);
        const int nowhere = ::open("/dev/null", O_WRONLY);
        ::dup2(nowhere, STDERR_FILENO);
        ::execvp("Xvfb", arguments.data());
        ::_exit(127);
    }
    ::close(told[1]);
    std::string number;
    for (char c; ::read(told[0], &c, 1) == 1 && c != '\n';) number.push_back(c);
    ::close(told[0]);
    if (number.empty()) {
        end();
        throw std::runtime_error("Xvfb does not start");
    }
    name_ = ":" + number;
}

XServer::~XServer() { end(); }

void XServer::end() {
    if (server_ <= 0) return;
    ::kill(server_, SIGTERM);
    ::waitpid(server_, nullptr, 0);
    server_ = -1;
}

} // namespace isomotion::display
