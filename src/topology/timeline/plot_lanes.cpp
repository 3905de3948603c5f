#include "topology/timeline/plot_lanes.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "topology/timeline/kind_mark.h"
#include "topology/timeline/words.h"

namespace isomotion::topology {
namespace {

constexpr double sparse_height = 20, crowded_height = 37;
constexpr double least_apart = 5.5;             // of triangles that can be told apart
constexpr double sign_width = 10;               // of a triangle, with air
constexpr double bar_room = 17, rug_length = 6; // above and below the line of a crowded lane
constexpr int least_full = 4;                   // so many events at least make a bar of full height
constexpr double least_bin = 6;                 // a bar's least width
constexpr double count_x = 54, sign_x = 66, name_x = 76;

struct Place {
    double frame = 0;
    bool is_proved = false;
};

struct Lane {
    const KindMark* mark = nullptr;
    std::vector<Place> places; // ascending
    bool is_crowded = false;
    std::map<std::int64_t, std::pair<int, int>> bins; // by number: proved events, and all
};

Lane lane_of(const KindMark& mark, const PlotAxis& axis, const TimelineRecord& record, double bin) {
    Lane lane{&mark, {}, false, {}};
    for (const Event& event : record.timeline.events) {
        if (event.kind != mark.kind) continue;
        const double frame = mid(frames_at(record.header.fps, event.time));
        lane.places.push_back({std::clamp(frame, axis.first, axis.last), event.is_proved});
    }
    std::ranges::sort(lane.places, {}, &Place::frame);
    for (std::size_t k = 0; k + 1 < lane.places.size(); ++k) {
        const double apart = lane.places[k + 1].frame - lane.places[k].frame;
        lane.is_crowded = lane.is_crowded || apart * axis.unit() < least_apart;
    }
    if (!lane.is_crowded) return lane;
    for (const Place& place : lane.places) {
        auto& [proved, all] = lane.bins[std::int64_t(std::floor(place.frame / bin))];
        proved += place.is_proved;
        ++all;
    }
    return lane;
}

int most_in_a_bin(const Lane& lane) {
    int most = 0;
    for (const auto& [number, counts] : lane.bins) most = std::max(most, counts.second);
    return most;
}

std::string sign_of(const KindMark& mark, double x, double y) {
    return mark.change == 0 ? diamond(x, y) : triangle(x, y, mark.change > 0);
}

std::string name_of(const KindMark& mark) {
    if (mark.kind == Kind::unknown) return "unknown";
    return mark.kind == Kind::none ? "no change" : std::string(name(mark.kind));
}

void draw_head(Svg& svg, const PlotAxis& axis, const KindMark& mark, std::size_t count, double y) {
    svg.draw("<path d=\"M{:.1f} {:.1f}H{:.1f}\" stroke=\"#e4e4e4\"/>", axis.left, y, axis.right);
    svg.text(count_x, y + 4, fmt::format("{}", count), {12, Anchor::end, "#666"});
    svg.draw("<path d=\"{}\" fill=\"{}\"/>", sign_of(mark, sign_x, y), mark.colour);
    svg.text(name_x, y + 4, name_of(mark));
}

// Writes the frames of marks beside those that have room for it, to the right or to the left.
void label_places(Svg& svg, const PlotAxis& axis, const Lane& lane, double y) {
    constexpr double size = 11, reach = sign_width / 2;
    const auto x_of = [&](std::size_t k) { return axis.x(lane.places[k].frame); };
    for (std::size_t k = 0; k < lane.places.size(); ++k) {
        const std::string words = fmt::format("{:.1f}", lane.places[k].frame);
        const double x = x_of(k), room = text_width(words, size) + 2 * reach + 2;
        const bool is_last = k + 1 == lane.places.size();
        if (is_last || x + room < x_of(k + 1)) {
            if (svg.text_where_free(x + reach + 2, y + 4, words, {size, Anchor::start, "#555"}))
                continue;
        }
        if (k == 0 || x - room > x_of(k - 1))
            svg.text_where_free(x - reach - 2, y + 4, words, {size, Anchor::end, "#555"});
    }
}

void draw_sparse(Svg& svg, const PlotAxis& axis, const Lane& lane, double y) {
    for (const Place& place : lane.places) {
        const std::string sign = sign_of(*lane.mark, axis.x(place.frame), y);
        if (place.is_proved) {
            svg.draw("<path class=\"event\" d=\"{}\" fill=\"{}\" stroke=\"#fff\" "
                     "stroke-width=\"0.6\"/>",
                     sign, lane.mark->colour);
        } else {
            svg.draw("<path class=\"event\" d=\"{}\" fill=\"#fff\" stroke=\"{}\" "
                     "stroke-width=\"1.4\"/>",
                     sign, lane.mark->colour);
        }
    }
    label_places(svg, axis, lane, y);
}

// Writes above the highest bars, as far as there is room, how many events they count.
void label_peaks(Svg& svg, const PlotAxis& axis, const Lane& lane, double bin, double scale,
                 double y) {
    constexpr int most_labels = 6;
    constexpr double size = 10.5;
    std::vector<std::pair<int, std::int64_t>> bars; // so many events, in that bin
    for (const auto& [number, counts] : lane.bins) bars.emplace_back(counts.second, number);
    std::ranges::stable_sort(bars, std::ranges::greater{}, &std::pair<int, std::int64_t>::first);
    int drawn = 0;
    for (const auto& [count, number] : bars) {
        if (drawn == most_labels || count < 2 || 2 * count < bars.front().first) break;
        const std::string words = fmt::format("{}", count);
        const auto reach =
            std::int64_t(std::ceil((text_width(words, size) / 2) / (bin * axis.unit()) + 0.5));
        const auto first = lane.bins.lower_bound(number - reach),
                   last = lane.bins.upper_bound(number + reach);
        const int highest = std::max_element(first, last, [](const auto& a, const auto& b) {
                                return a.second.second < b.second.second;
                            })->second.second;
        if (highest > count) continue;
        const double middle = axis.clamped((double(number) + 0.5) * bin);
        drawn += svg.text_where_free(middle, y - std::max(2.0, scale * count) - 2, words,
                                     {size, Anchor::middle, "#555"});
    }
}

void draw_crowded(Svg& svg, const PlotAxis& axis, const Lane& lane, double bin, double scale,
                  double y) {
    std::string proved_bars, other_bars, proved_ticks, other_ticks;
    for (const auto& [number, counts] : lane.bins) {
        const auto& [proved, all] = counts;
        const double from = axis.clamped(double(number) * bin);
        const double wide = axis.clamped(double(number + 1) * bin) - from - 0.8;
        const double high = std::max(2.0, scale * all), solid = high * proved / all;
        const auto bar = [&](double low, double top) {
            return fmt::format("M{:.1f} {:.1f}h{:.1f}V{:.1f}h{:.1f}z", from + 0.4, y - low,
                               std::max(wide, 0.4), y - top, -std::max(wide, 0.4));
        };
        if (proved > 0) proved_bars += bar(0, solid);
        if (proved < all) other_bars += bar(solid, high);
    }
    for (const Place& place : lane.places) {
        (place.is_proved ? proved_ticks : other_ticks) +=
            fmt::format("M{:.2f} {:.1f}v{:.1f}", axis.x(place.frame), y + 1.5, rug_length - 1.5);
    }
    const char* colour = lane.mark->colour;
    if (!proved_bars.empty()) {
        svg.draw("<path d=\"{}\" fill=\"{}\"/>", proved_bars, colour);
        svg.draw("<path class=\"events\" d=\"{}\" stroke=\"{}\" stroke-width=\"0.8\"/>",
                 proved_ticks, colour);
    }
    if (!other_bars.empty()) {
        svg.draw("<path d=\"{}\" fill=\"#fff\" stroke=\"{}\" stroke-width=\"0.8\"/>", other_bars,
                 colour);
        svg.draw("<path class=\"events\" d=\"{}\" stroke=\"{}\" stroke-width=\"0.8\" "
                 "stroke-dasharray=\"1.5 1\"/>",
                 other_ticks, colour);
    }
    label_peaks(svg, axis, lane, bin, scale, y);
}

} // namespace

std::string triangle(double x, double y, bool up) {
    const double tip = up ? -5 : 5;
    return fmt::format("M{:.2f} {:.1f}l4.5 {}h-9z", x, y + tip, -2 * tip);
}

std::string diamond(double x, double y) {
    return fmt::format("M{:.2f} {:.1f}l5 5l-5 5l-5 -5z", x, y - 5);
}

LanesDrawn draw_lanes(Svg& svg, const PlotAxis& axis, const TimelineRecord& record, double top) {
    const double bin =
        nice_step(axis.last - axis.first, std::max(1.0, (axis.right - axis.left) / least_bin));
    std::vector<Lane> lanes;
    for (const KindMark& mark : kind_marks()) {
        Lane lane = lane_of(mark, axis, record, bin);
        if (!lane.places.empty()) lanes.push_back(std::move(lane));
    }
    const bool has_bars = std::ranges::any_of(lanes, &Lane::is_crowded);
    LanesDrawn drawn{top, false, has_bars ? bin : 0};
    for (const Lane& lane : lanes) {
        const double y = lane.is_crowded ? drawn.bottom + crowded_height - rug_length - 2
                                         : drawn.bottom + sparse_height / 2;
        draw_head(svg, axis, *lane.mark, lane.places.size(), y);
        if (lane.is_crowded) {
            const double scale = bar_room / std::max(least_full, most_in_a_bin(lane));
            draw_crowded(svg, axis, lane, bin, scale, y);
        } else {
            draw_sparse(svg, axis, lane, y);
        }
        drawn.triangles = drawn.triangles || lane.mark->change != 0;
        drawn.bottom += lane.is_crowded ? crowded_height : sparse_height;
    }
    return drawn;
}

} // namespace isomotion::topology
