#include "scene/reading/time.h"

#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "scene/key_tables.h"
#include "scene/limits.h"
#include "scene/reading/read_keys.h"

namespace isomotion::scene {
namespace {

animation::FrameRate read_fps(const toml::node& fps) {
    std::optional<animation::FrameRate> rate;
    if (const auto text = fps.value_exact<std::string>()) {
        rate = animation::parse_frame_rate(*text);
    } else if (fps.is_number()) {
        rate = animation::parse_frame_rate(fmt::format("{}", read_finite(fps, "time.fps")));
    }
    if (rate) return *rate;
    fail(fps, "time.fps", "must be above 0: 30, 23.976 (up to nine decimals) or \"30000/1001\"");
}

// `seconds` say in place of `frames` how long the scene is.
void read_seconds(Section& section, animation::Timeline& timeline) {
    const auto seconds = section.number("seconds", 1e-9, limits::frames);
    if (!seconds) return;
    const animation::FrameRate& fps = timeline.fps;
    const double count = std::round(*seconds * double(fps.numerator) / double(fps.denominator));
    if (section.is_wrong("frames")) return;
    if (section.has("frames")) {
        section.tell(
            "seconds",
            fmt::format("says again how long the scene is: {} frames; at fps = {}, frames = {} "
                        "takes these {:g} seconds. Keep one of frames and seconds",
                        timeline.frames, animation::to_string(fps), count, *seconds));
    }
    if (count < 1 || count > limits::frames) {
        section.tell("seconds", fmt::format("is {:g} frames; a scene has from 1 to {}", count,
                                            limits::frames));
        return;
    }
    timeline.frames = int(count);
}

} // namespace

TimeParts read_time(Section& document) {
    TimeParts read;
    auto section = document.section("time");
    if (!section) return read;
    if (const toml::node* fps = section->find("fps"))
        section->attempt("fps", [&] { read.timeline.fps = read_fps(*fps); });
    read_keys(keys::time_keys, *section, read.timeline);
    read_seconds(*section, read.timeline);
    // Every frame that is named elsewhere may then be one.
    const bool are_frames_wrong = section->is_wrong("frames") || section->is_wrong("seconds");
    if (are_frames_wrong) read.timeline.frames = limits::frames;
    read.seed = std::uint64_t(section->integer("seed", 0, 2'147'483'647).value_or(0));
    section->refuse_rest();
    return read;
}

} // namespace isomotion::scene
