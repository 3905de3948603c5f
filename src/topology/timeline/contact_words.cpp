#include "topology/timeline/contact_words.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "topology/timeline/advice.h"
#include "topology/timeline/words.h"

namespace isomotion::topology {
namespace {

// What a birth or a death of their common part does to the two.
std::string deed_of(const Event& event) {
    if (event.kind == Kind::birth) {
        const bool is_more = event.before && event.before->components > 0;
        return is_more ? "touch at one more place" : "touch";
    }
    const bool is_less = event.after && event.after->components > 0;
    return is_less ? "part at one place" : "part";
}

// What rounding leaves of 0 is no coordinate.
std::string place_text(const std::array<double, 3>& place) {
    double size = 0;
    for (const double x : place) size = std::max(size, std::abs(x));
    const auto text = [&](double x) { return std::abs(x) < 1e-12 * size ? 0.0 : x; };
    return fmt::format("({:.4g}, {:.4g}, {:.4g})", text(place[0]), text(place[1]), text(place[2]));
}

std::string at_start(const std::string& names, const Timeline& timeline) {
    if (!timeline.start) return "";
    const int places = timeline.start->components;
    if (places == 0) return "";
    const char* proved = timeline.start_is_proved ? ", proved" : "";
    return places == 1 ? fmt::format("{} are in contact at the start{}\n", names, proved)
                       : fmt::format("{} are in contact at {} places at the start{}\n", names,
                                     places, proved);
}

} // namespace

std::string contact_text(const NamedPair& pair, const Timeline& timeline,
                         animation::FrameRate fps) {
    const std::string names = fmt::format("{} and {}", pair.first, pair.second);
    std::string text = at_start(names, timeline);
    for (const Event& event : timeline.events) {
        if (event.kind != Kind::birth && event.kind != Kind::death) continue;
        const double time = mid(event.time);
        const auto place =
            pair.to_world(time, {mid(event.where[0]), mid(event.where[1]), mid(event.where[2])});
        text += fmt::format("{} {} at frame {}, {:.6g} s, near {}{}\n", names, deed_of(event),
                            frame_text(frames_at(fps, event.time)), time, place_text(place),
                            event.is_proved ? ", proved" : "");
    }
    const auto reasons = gaps(timeline, fps);
    if (text.empty() && reasons.empty()) return names + " never touch, proved\n";
    if (reasons.empty()) return text + names + ": complete, all proved\n";
    text += names + ": INCOMPLETE\n";
    for (const std::string& reason : reasons) text += fmt::format("    {}\n", reason);
    for (const std::string& words : advice(timeline, fps)) text += fmt::format("try: {}\n", words);
    return text;
}

} // namespace isomotion::topology
