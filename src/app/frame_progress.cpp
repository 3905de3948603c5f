#include "app/frame_progress.h"

#include <fmt/format.h>

namespace isomotion::app {
namespace {

constexpr std::chrono::duration<double> is_known{10}, is_long{60};
constexpr std::chrono::milliseconds shown_every{200};

std::string duration(double seconds) {
    if (seconds < 100) return fmt::format("{:.0f} s", seconds);
    if (seconds < 6000) return fmt::format("{:.0f} minutes", seconds / 60);
    return fmt::format("{:.0f} hours", seconds / 3600);
}

} // namespace

std::optional<std::string> long_frame(int frame, std::chrono::duration<double> passed,
                                      double part) {
    if (passed < is_known) return std::nullopt;
    if (part <= 0) {
        if (passed < is_long) return std::nullopt;
        return fmt::format("frame {}: nothing of it is drawn after {}", frame,
                           duration(passed.count()));
    }
    const double all = passed.count() / part;
    if (all < is_long.count()) return std::nullopt;
    return fmt::format("frame {} takes some {}: {:.0f} % are drawn after {}; fewer elements, a "
                       "shorter formula or a smaller --size take less",
                       frame, duration(all), 100 * part, duration(passed.count()));
}

void FrameProgress::show(const sequence::ExportProgress& now) {
    const auto time = Clock::now();
    const std::string name = now.file.filename().string();
    if (now.done != done_) {
        done_ = now.done;
        begin_ = shown_ = time;
        progress_.show(done_, name);
        return;
    }
    if (!told_) {
        if (const auto text = long_frame(now.frame, time - begin_, now.part)) {
            progress_.tell("warning: " + *text);
            told_ = true;
        }
    }
    if (time - shown_ < shown_every) return;
    shown_ = time;
    progress_.show(done_, fmt::format("{}, {:.0f} % of it", name, 100 * now.part));
}

} // namespace isomotion::app
