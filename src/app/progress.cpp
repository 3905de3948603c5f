#include "app/progress.h"

#include <algorithm>

#include <fmt/format.h>
#include <unistd.h>

#include "app/console.h"
#include "base/printable.h"

namespace isomotion::app {

Progress::Progress(std::string what, int total, bool quiet)
    : what_(std::move(what))
    , total_(total)
    , terminal_(!quiet && isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
    if (drawn_) control_terminal("\r\033[K");
}

void Progress::show(int done, const std::string& note) {
    if (!terminal_) return;
    constexpr int width = 30;
    const int filled = total_ > 0 ? std::clamp(width * done / total_, 0, width) : 0;
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin_;
    std::string left;
    if (done > 0 && done < total_) {
        left = fmt::format(", {:.0f} s left", passed.count() / done * (total_ - done));
    }
    control_terminal(fmt::format("\r\033[K{} [{:=<{}}{: <{}}] {}/{}{} {}", what_, "", filled, "",
                                 width - filled, done, total_, left, base::printable_line(note)));
    drawn_ = true;
}

void Progress::tell(const std::string& text) {
    if (drawn_) control_terminal("\r\033[K");
    drawn_ = false;
    message("{}\n", text);
}

} // namespace isomotion::app
