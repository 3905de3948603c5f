#include "app/progress.h"

#include <algorithm>

#include <fmt/format.h>
#include <unistd.h>

#include "app/console.h"
#include "base/printable.h"

namespace isomotion::app {

std::string duration(double seconds) {
    if (seconds < 100) return fmt::format("{:.0f} s", seconds);
    if (seconds < 6000) return fmt::format("{:.0f} minutes", seconds / 60);
    return fmt::format("{:.0f} hours", seconds / 3600);
}

Progress::Progress(std::string what, int total, bool quiet)
    : what_(std::move(what))
    , total_(total)
    , terminal_(!quiet && isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
    if (drawn_) control_terminal("\r\033[K");
}

void Progress::show(double done, const std::string& note) {
    if (!terminal_) return;
    constexpr int width = 30;
    const int filled = total_ > 0 ? int(std::clamp(width * done / total_, 0.0, double(width))) : 0;
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin_;
    std::string left;
    if (done > 0 && done < total_) {
        left = fmt::format(", {} left", duration(passed.count() / done * (total_ - done)));
    }
    control_terminal(fmt::format("\r\033[K{} [{:=<{}}{: <{}}] {}/{}{} {}", what_, "", filled, "",
                                 width - filled, int(done), total_, left,
                                 base::printable_line(note)));
    drawn_ = true;
}

void Progress::tell(const std::string& text) {
    if (drawn_) control_terminal("\r\033[K");
    drawn_ = false;
    message("{}\n", text);
}

} // namespace isomotion::app
