#include "app/frame_progress.h"

#include <fmt/format.h>

namespace isomotion::app {
namespace {

constexpr double is_known = 2, is_long = 10; // seconds
constexpr std::chrono::milliseconds shown_every{200};

} // namespace

std::optional<std::string> long_frame(const ExportProgress& now, const std::string& costs) {
    if (now.landing) {
        if (now.seconds < is_long) return std::nullopt;
        return fmt::format("frame {}: it is still drawn after {}; what costs: {}", *now.landing,
                           duration(now.seconds), costs);
    }
    if (now.seconds < is_known || now.part >= 1) return std::nullopt;
    if (!now.left) {
        if (now.seconds < is_long) return std::nullopt;
        const std::string drawn =
            now.part > 0 ? fmt::format("{:.0f} %", 100 * now.part) : "nothing";
        return fmt::format("frame {}: {} of it is drawn after {}; what costs: {}", now.frame, drawn,
                           duration(now.seconds), costs);
    }
    const double all = now.seconds + *now.left;
    if (all < is_long) return std::nullopt;
    return fmt::format("frame {} takes some {}: {:.0f} % are drawn after {}; what costs: {}",
                       now.frame, duration(all), 100 * now.part, duration(now.seconds), costs);
}

void FrameProgress::show(const ExportProgress& now) {
    const auto time = Clock::now();
    const std::string name = now.file.filename().string();
    if (now.done != done_) {
        done_ = now.done;
        shown_ = time;
        progress_.show(done_, name);
        return;
    }
    if (!told_) {
        if (const auto text = long_frame(now, costs_)) {
            progress_.tell(*text);
            told_ = true;
        }
    }
    if (time - shown_ < shown_every) return;
    shown_ = time;
    progress_.show(done_ + now.part,
                   fmt::format("{}, {:.0f} % of it{}", name, 100 * now.part,
                               now.left ? ", " + duration(*now.left) + " left" : ""));
}

} // namespace isomotion::app
