#include "player/model/render_process.h"

#include <algorithm>
#include <thread>

#include <fmt/format.h>

namespace isomotion::player {
namespace fs = std::filesystem;

std::vector<std::string> render_words(const RenderOrder& order) {
    std::vector<std::string> words{"render", order.scene.string(), "--quiet", "-o", order.output};
    words.insert(
        words.end(),
        {"--frames", order.poster ? "poster" : fmt::format("{}-{}", order.first, order.last)});
    words.insert(words.end(), {"--size", fmt::format("{}x{}", order.width, order.height)});
    for (const scene::Override& setting : order.overrides) {
        words.insert(words.end(), {"--set", setting});
    }
    if (order.reach == scene::Reach::anywhere) words.emplace_back("--allow-outside");
    if (!order.movie.empty()) words.insert(words.end(), {"--movie", order.movie});
    return words;
}

RenderProcess::RenderProcess(RenderOrder order)
    : order_(std::move(order))
    , name_(sequence::SequenceName::parse(order_.output))
    // File systems keep times more coarsely than clocks do.
    , begin_(fs::file_time_type::clock::now() - std::chrono::seconds(1))
    , process_("/proc/self/exe", render_words(order_)) {}

int RenderProcess::done() {
    for (; written_ < frames(); ++written_) {
        std::error_code error;
        const auto time = fs::last_write_time(name_.path(order_.first + written_), error);
        if (error || time < begin_) break;
    }
    return written_;
}

void RenderProcess::cancel() {
    cancelled_ = true;
    process_.interrupt();
}

void RenderProcess::cancel(std::chrono::milliseconds patience) {
    constexpr std::chrono::milliseconds glance{10};
    cancel();
    for (; patience.count() > 0 && !ended(); patience -= glance) {
        std::this_thread::sleep_for(glance);
    }
}

std::string RenderProcess::error() const {
    if (process_.succeeded()) return {};
    if (cancelled_) return "cancelled";
    const std::string words = process_.last_words(6);
    return words.empty() ? fmt::format("render ended with {}", process_.ending()) : words;
}

} // namespace isomotion::player
