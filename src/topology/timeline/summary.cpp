#include "topology/timeline/summary.h"

#include <algorithm>

#include <fmt/format.h>

#include "topology/timeline/advice.h"
#include "topology/timeline/words.h"

namespace isomotion::topology {
namespace {

std::string from_to(const char* thing, int Betti::*number, const Timeline& timeline) {
    const auto text = [&](const std::optional<Betti>& solid) {
        return solid ? std::to_string((*solid).*number) : "?";
    };
    return fmt::format("{} -> {} {}", text(timeline.start), text(timeline.end), thing);
}

std::int64_t events_that_change(const Timeline& timeline) {
    return std::ranges::count_if(timeline.events,
                                 [](const Event& event) { return event.kind != Kind::none; });
}

// A line of its own; empty if there is nothing to tell.
std::string proved_again(const Timeline& timeline) {
    const auto number = std::ranges::count_if(timeline.events, &Event::is_proved_again);
    if (number == 0) return "";
    const auto all = std::int64_t(timeline.events.size());
    return number == all
               ? "\neach event proved again in ball arithmetic"
               : fmt::format("\n{} of {} events proved again in ball arithmetic", number, all);
}

// A line of its own; empty if there is nothing to tell.
std::string counted_again(const Recount& recount) {
    if (recount.spans == 0) return "";
    return fmt::format(
        "\nBetti numbers counted again in {} of {} proved spans between events{}", recount.agree,
        recount.spans,
        recount.agree < recount.spans ? "; the others are too short, or too fine for grids" : "");
}

} // namespace

std::string tally(const Timeline& timeline) {
    std::string text;
    const auto add = [&](Kind kind) {
        const auto number = std::ranges::count(timeline.events, kind, &Event::kind);
        if (number == 0) return;
        text += fmt::format("{}{}", text.empty() ? "" : ", ", counted(number, kind));
    };
    for (int k = int(Kind::birth); k <= int(Kind::none); ++k) add(Kind(k));
    add(Kind::unknown);
    if (!text.empty()) return text;
    return timeline.is_proved ? "no event" : "no event found";
}

std::string summary(const TimelineRecord& record) {
    const Timeline& timeline = record.timeline;
    const auto fps = record.header.fps;
    std::string text = fmt::format("{}: frames {} to {}, {:.6g} to {:.6g} s\n", record.header.title,
                                   frame_text(frame_at(fps, timeline.range.lo)),
                                   frame_text(frame_at(fps, timeline.range.hi)), timeline.range.lo,
                                   timeline.range.hi);
    text += fmt::format("{}, {}, {}\n", from_to("components", &Betti::components, timeline),
                        from_to("tunnels", &Betti::tunnels, timeline),
                        from_to("voids", &Betti::voids, timeline));
    if (const auto number = events_that_change(timeline); number > 0) {
        text += fmt::format("{} event{}: ", number, number == 1 ? "" : "s");
    }
    text += tally(timeline);
    if (!timeline.events.empty()) {
        const auto frame = [&](const Event& event) {
            return frame_text(frames_at(fps, event.time));
        };
        text += timeline.events.size() == 1
                    ? fmt::format("; at frame {}", frame(timeline.events.front()))
                    : fmt::format("; first at frame {}, last at {}", frame(timeline.events.front()),
                                  frame(timeline.events.back()));
    }
    const auto reasons = gaps(timeline, fps);
    text += proved_again(timeline);
    text += counted_again(timeline.recount);
    if (reasons.empty()) return text + "\ncomplete, all proved\n";
    text += "\nINCOMPLETE\n";
    for (const std::string& reason : reasons) text += fmt::format("    {}\n", reason);
    for (const std::string& words : advice(timeline, fps)) text += fmt::format("try: {}\n", words);
    return text;
}

} // namespace isomotion::topology
