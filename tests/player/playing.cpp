#include "playing.h"

#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <thread>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace isomotion::player {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr auto patience = 90s; // machines may be busy; nothing that works takes as long
constexpr auto glance = 20ms;

bool wait_for(const std::function<bool()>& holds) {
    for (const auto end = Clock::now() + patience; Clock::now() < end;) {
        if (holds()) return true;
        std::this_thread::sleep_for(glance);
    }
    return false;
}

std::string text_of(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

} // namespace

std::string growing_sphere(const std::string& formula) {
    return R"toml(title = "A sphere"
[time]
fps = 30
frames = 64
loop = true
[surface]
formula = ")toml" +
           formula + R"toml("
bounds = { sphere = 1.5 }
[parameters]
r = { keys = [[0, 0.2], [2.1, 1.2]] }
[camera]
position = [4, 1, 0.5]
fov = 40
[output]
size = [64, 64]
)toml";
}

void Playing::SetUp() {
    if (const auto missing = Display::missing()) GTEST_SKIP() << *missing << " is not installed";
    display_ = std::make_unique<Display>();
    write("sphere.toml", growing_sphere());
}

void Playing::TearDown() {
    if (player_ > 0) {
        ::kill(player_, SIGKILL);
        ::waitpid(player_, nullptr, 0);
    }
    if (HasFailure()) {
        std::string lines = text_of(*this / "log");
        if (lines.size() > 3000) lines = "..." + lines.substr(lines.size() - 3000);
        ADD_FAILURE() << "log:\n" << lines << "stderr:\n" << text_of(*this / "stderr");
    }
}

void Playing::write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
}

void Playing::play(std::vector<std::string> words,
                   const std::vector<std::pair<std::string, std::string>>& environment) {
    words.insert(words.begin(), {cli::tested_program(ISOMOTION_PROGRAM), "play", "--log", "log"});
    std::filesystem::remove(*this / "log");
    log_.clear();
    read_ = 0;
    mark_ = 0;
    player_ = ::fork();
    if (player_ == 0) {
        const std::string home = folder_.path().string();
        ::setenv("DISPLAY", display_->name().c_str(), 1);
        ::setenv("XDG_STATE_HOME", (home + "/state").c_str(), 1);
        ::setenv("XDG_CACHE_HOME", (home + "/cache").c_str(), 1);
        ::setenv("ISOMOTION_DATA", ISOMOTION_SOURCE_DIR, 1);
        for (const auto& [name, value] : environment) ::setenv(name.c_str(), value.c_str(), 1);
        const int err = ::open((home + "/stderr").c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600);
        ::dup2(err, STDERR_FILENO);
        std::vector<char*> argv;
        for (std::string& word : words) argv.push_back(word.data());
        argv.push_back(nullptr);
        if (::chdir(home.c_str()) == 0) ::execv(argv.front(), argv.data());
        ::_exit(127);
    }
    // Keys go where the focus is, and there is no window manager that would give it.
    ASSERT_TRUE(wait_for([&] { return !log().empty() || ::waitpid(player_, nullptr, WNOHANG); }));
    EXPECT_TRUE(wait_for([&] {
        return display_->drive({"search", "--onlyvisible", "--name", "isomotion", "windowsize",
                                std::to_string(Display::width), std::to_string(Display::height),
                                "windowmove", "0", "0", "windowfocus", "--sync"});
    }));
}

cli::Ending Playing::ending() {
    cli::Ending ending;
    int status = 0;
    const bool ended = wait_for([&] { return ::waitpid(player_, &status, WNOHANG) == player_; });
    EXPECT_TRUE(ended) << "the player does not end";
    if (!ended) return ending;
    player_ = -1;
    if (WIFEXITED(status)) ending.code = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) ending.signal = WTERMSIG(status);
    ending.err = text_of(*this / "stderr");
    return ending;
}

void Playing::quit() {
    key("q");
    const cli::Ending end = ending();
    EXPECT_EQ(end.code, 0) << end;
}

cli::Ending Playing::run(std::vector<std::string> words) const {
    words.insert(words.begin(), cli::tested_program(ISOMOTION_PROGRAM));
    return cli::run(words, {.folder = folder_.path(),
                            .environment = {{"ISOMOTION_DATA", ISOMOTION_SOURCE_DIR}}});
}

const std::vector<Json>& Playing::log() {
    std::ifstream stream(*this / "log", std::ios::binary);
    stream.seekg(read_);
    for (std::string line;
         std::getline(stream, line) && !stream.eof();) { // else still being written
        log_.push_back(Json::parse(line));
        read_ += std::streamoff(line.size()) + 1;
    }
    return log_;
}

Json Playing::await(const std::string& what, const std::function<bool(const Json&)>& holds) {
    Json found;
    const bool came = wait_for([&] {
        const std::vector<Json>& lines = log();
        for (std::size_t k = mark_; k < lines.size(); ++k) {
            if (!holds(lines[k])) continue;
            found = lines[k];
            return true;
        }
        return false;
    });
    if (!came) throw std::runtime_error("did not come: " + what);
    return found;
}

Json Playing::await_rest(const std::string& what, const std::function<bool(const Json&)>& holds) {
    return await(what, [&](const Json& line) {
        return line.contains("at_rest") && line["at_rest"] && (!holds || holds(line));
    });
}

void Playing::key(const std::string& name) const { EXPECT_TRUE(display_->drive({"key", name})); }

std::array<int, 2> Playing::place_of(const std::string& widget, double across) {
    Json box, before;
    const bool known = wait_for([&] {
        for (const Json& line : log()) {
            if (line.contains("widgets")) box = line["widgets"].value(widget, Json());
        }
        // A layout that stays: a window that is being resized makes several.
        const bool stays = !box.is_null() && box == before;
        before = box;
        if (!stays) std::this_thread::sleep_for(300ms);
        return stays;
    });
    if (!known) throw std::runtime_error("there is no widget " + widget);
    return {int(box[0].get<int>() + across * box[2].get<int>()),
            int(box[1].get<int>() + 0.5 * box[3].get<int>())};
}

void Playing::click(std::array<int, 2> at) const {
    EXPECT_TRUE(display_->drive({"mousemove", "--sync", std::to_string(at[0]),
                                 std::to_string(at[1]), "sleep", "0.1", "click", "1"}));
}

void Playing::drag(std::array<int, 2> from, std::array<int, 2> to) const {
    const std::array<int, 2> half{(from[0] + to[0]) / 2, (from[1] + to[1]) / 2};
    const auto x = [](std::array<int, 2> at) { return std::to_string(at[0]); };
    const auto y = [](std::array<int, 2> at) { return std::to_string(at[1]); };
    EXPECT_TRUE(
        display_->drive({"mousemove", x(from), y(from),     "sleep", "0.1",   "mousedown", "1",
                         "sleep",     "0.1",   "mousemove", x(half), y(half), "sleep",     "0.1",
                         "mousemove", x(to),   y(to),       "sleep", "0.1",   "mouseup",   "1"}));
}

std::vector<std::array<std::uint8_t, 3>> Playing::picture(const Json& line) const {
    return display_->screenshot(line["corner"][0], line["corner"][1], line["size"][0],
                                line["size"][1]);
}

bool Playing::screen_comes_to(const std::function<bool()>& holds) const { return wait_for(holds); }

double Playing::cpu_seconds() const {
    const std::string stat = text_of("/proc/" + std::to_string(player_) + "/stat");
    std::istringstream fields(stat.substr(stat.rfind(')') + 2));
    std::string skipped;
    long user = 0, system = 0;
    for (int k = 0; k < 11; ++k) fields >> skipped;
    fields >> user >> system;
    return double(user + system) / double(::sysconf(_SC_CLK_TCK));
}

} // namespace isomotion::player
