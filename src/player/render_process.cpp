#include "player/render_process.h"

#include <algorithm>

#include <fmt/format.h>

#include "image/sequence.h"

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
    if (!order.movie.empty()) words.insert(words.end(), {"--movie", order.movie});
    return words;
}

RenderProcess::RenderProcess(RenderOrder order)
    : order_(std::move(order))
    // File systems keep times more coarsely than clocks do.
    , begin_(fs::file_time_type::clock::now() - std::chrono::seconds(1))
    , process_("/proc/self/exe", render_words(order_)) {}

int RenderProcess::done() const {
    const auto name = image::SequenceName::parse(order_.output);
    int count = 0;
    for (int frame = order_.first; frame <= order_.last; ++frame) {
        std::error_code error;
        const auto written = fs::last_write_time(name.path(frame), error);
        if (!error && written >= begin_) ++count;
    }
    return count;
}

void RenderProcess::cancel() {
    cancelled_ = true;
    process_.interrupt();
}

std::string RenderProcess::error() const {
    if (process_.succeeded()) return {};
    if (cancelled_) return "cancelled";
    const std::string words = process_.last_words(6);
    return words.empty() ? fmt::format("render ended with {}", process_.ending()) : words;
}

} // namespace isomotion::player
