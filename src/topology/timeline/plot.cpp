#include "topology/timeline/plot.h"

#include <algorithm>
#include <cmath>

#include "topology/timeline/plot_axis.h"
#include "topology/timeline/plot_lanes.h"
#include "topology/timeline/steps.h"
#include "topology/timeline/summary.h"
#include "topology/timeline/svg.h"
#include "topology/timeline/words.h"

namespace isomotion::topology {
namespace {

using formula::Interval;

// So wide that its smallest text can be read where it is shown 800 pixels wide.
constexpr double width = 960, margin = 16, left = 178, right = 28;
constexpr double picture_size = 92, panel_height = 82, gap = 12;
constexpr double unresolved_height = 20;
constexpr const char* not_known = "#b03a00";

constexpr const char* hatching =
    "<pattern id=\"unknown\" width=\"6\" height=\"6\" patternUnits=\"userSpaceOnUse\" "
    "patternTransform=\"rotate(45)\"><rect width=\"6\" height=\"6\" fill=\"#f4f4f4\"/><path "
    "d=\"M0 0V6\" stroke=\"#bbb\" stroke-width=\"2\"/></pattern>";

class Plot {
public:
    Plot(const TimelineRecord& record, const std::vector<Thumbnail>& thumbnails)
        : record_(record)
        , timeline_(record.timeline)
        , fps_(record.header.fps)
        , steps_(steps_of(record.timeline))
        , thumbnails_(thumbnails) {
        axis_.first = frame_at(fps_, timeline_.range.lo);
        axis_.last = std::max(frame_at(fps_, timeline_.range.hi), axis_.first + 1e-9);
        axis_.left = left;
        axis_.right = width - right;
    }

    std::string svg() {
        title();
        if (!thumbnails_.empty()) pictures();
        top_ = y_;
        panel("components", &Betti::components, true);
        panel("tunnels", &Betti::tunnels, false);
        panel("voids", &Betti::voids, false);
        lanes_ = draw_lanes(svg_, axis_, record_, y_ + gap);
        y_ = lanes_.bottom;
        unresolved_lane();
        axis();
        legend();
        return svg_.file(y_ + 10, hatching);
    }

private:
    void title() {
        const bool complete = timeline_.is_complete();
        const double room = width - 2 * margin;
        svg_.text(margin, 28, cut_to(record_.header.title, room, 18, true),
                  {18, Anchor::start, "#222", true});
        y_ = 49;
        // Lanes have the numbers, too.
        const std::string counts = tally(timeline_);
        const std::string total = fmt::format("{} events", timeline_.events.size());
        svg_.text(margin, y_, text_width(counts, 13) <= room ? counts : total, {13});
        y_ += 18;
        std::string verdict = "complete, all proved";
        if (!complete) {
            const auto reasons = gaps(timeline_, fps_);
            verdict = "incomplete: ";
            if (reasons.size() > 1)
                verdict = fmt::format("incomplete, {} reasons: ", reasons.size());
            verdict += reasons.front();
        }
        for (const std::string& line : wrapped(verdict, room, 13, 3)) {
            svg_.text(margin, y_, line, {13, Anchor::start, complete ? "#117733" : not_known});
            y_ += 18;
        }
        y_ += 2;
    }

    void pictures() {
        const double slot = (axis_.right - axis_.left) / double(thumbnails_.size());
        const double size = std::min(picture_size, slot - 4);
        const double foot = y_ + size + 18, top = foot + 24;
        for (std::size_t k = 0; k < thumbnails_.size(); ++k) {
            const Thumbnail& one = thumbnails_[k];
            const double middle = axis_.left + slot * (double(k) + 0.5);
            const double at = axis_.clamped(one.frame);
            svg_.draw("<image x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" "
                      "xlink:href=\"{}\"/>",
                      middle - size / 2, y_, size, size, escaped(one.picture));
            svg_.text_where_free(middle, foot - 4, fmt::format("{:.1f}", one.frame),
                                 {12, Anchor::middle, "#555"});
            svg_.draw("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"#999\" fill=\"none\"/>",
                      middle, foot, at, top);
            places_.push_back(at);
        }
        svg_.text(margin, foot - 4, "frame", {12, Anchor::start, "#555"});
        y_ = top;
    }

    // One Betti number. `always`: also where it is 0 all the time.
    void panel(const char* label, int Betti::*number, bool always) {
        int most = 0;
        for (const Step& step : steps_.steps) {
            if (step.solid) most = std::max(most, (*step.solid).*number);
        }
        if (most == 0 && !always) return;
        y_ += gap;
        const int step = int(std::max(1.0, nice_step(std::max(1, most), 4)));
        const int ceiling = step * std::max(1, (most + step - 1) / step);
        const double foot = y_ + panel_height, scale = (panel_height - 8) / ceiling;
        const auto y = [&](int value) { return foot - scale * value; };
        svg_.text(margin, y_ + 12, label, {13, Anchor::start, "#222", true});
        for (int tick = 0; tick <= ceiling; tick += step) {
            svg_.draw("<path d=\"M{:.1f} {:.1f}H{:.1f}\" stroke=\"#e4e4e4\"/>", axis_.left, y(tick),
                      axis_.right);
            svg_.text_where_free(axis_.left - 6, y(tick) + 4, fmt::format("{}", tick),
                                 {12, Anchor::end, "#555"});
        }
        curve(foot, [&](const Betti& solid) { return y(solid.*number); });
        y_ = foot;
    }

    // The steps, as one line and one area as far as they are known and proved alike.
    template<class Height> void curve(double foot, Height&& height) {
        std::string line, area;
        bool is_proved = true;
        double end = 0;
        const auto finish = [&] {
            if (line.empty()) return;
            svg_.draw("<path d=\"{}V{:.1f}z\" fill=\"#0072b2\" fill-opacity=\"0.13\"/>", area,
                      foot);
            svg_.draw("<path d=\"{}\" fill=\"none\" stroke=\"#1a3a52\" stroke-width=\"1.5\"{}/>",
                      line, is_proved ? "" : " stroke-dasharray=\"4 3\"");
            line.clear();
        };
        for (std::size_t k = 0; k < steps_.steps.size(); ++k) {
            const Step& here = steps_.steps[k];
            // A step ends in the middle of the instant after it, narrow as those are.
            const double from = k > 0 ? moment_x(k - 1) : axis_.left;
            const double to = k < steps_.instants.size() ? moment_x(k) : axis_.right;
            if (!here.solid) {
                finish();
                if (to <= from) continue;
                svg_.draw("<rect x=\"{:.2f}\" y=\"{:.1f}\" width=\"{:.2f}\" height=\"{:.1f}\" "
                          "fill=\"url(#unknown)\"/>",
                          from, foot - panel_height, to - from, panel_height);
                continue;
            }
            const double level = height(*here.solid);
            if (!line.empty() && here.is_proved != is_proved) {
                line += fmt::format("V{:.1f}", level); // its riser belongs to both
                finish();
            }
            if (line.empty()) {
                line = fmt::format("M{:.1f} {:.1f}", from, level);
                area = fmt::format("M{:.1f} {:.1f}V{:.1f}", from, foot, level);
                is_proved = here.is_proved;
                end = level;
            }
            const std::string step =
                (level != end ? fmt::format("V{:.1f}", level) : "") + fmt::format("H{:.1f}", to);
            line += step;
            area += step;
            end = level;
        }
        finish();
    }
    double moment_x(std::size_t k) const {
        return axis_.clamped(mid(frames_at(fps_, steps_.instants[k].time)));
    }

    void unresolved_lane() {
        if (timeline_.unresolved.empty()) return;
        const double middle = y_ + unresolved_height / 2;
        svg_.draw("<path d=\"M{:.1f} {:.1f}H{:.1f}\" stroke=\"#e4e4e4\"/>", axis_.left, middle,
                  axis_.right);
        svg_.text(54, middle + 4, fmt::format("{}", timeline_.unresolved.size()),
                  {12, Anchor::end, "#666"});
        svg_.draw("<path d=\"{}\" fill=\"{}\"/>", diamond(66, middle), not_known);
        svg_.text(76, middle + 4, "unresolved");
        for (const Unresolved& place : timeline_.unresolved) {
            const Interval frames = frames_at(fps_, place.time);
            const double from = axis_.clamped(frames.lo);
            const double to = std::max(axis_.clamped(frames.hi), from + 3);
            svg_.draw_behind("<rect x=\"{:.2f}\" y=\"{:.1f}\" width=\"{:.2f}\" height=\"{:.1f}\" "
                             "fill=\"url(#unknown)\"/>",
                             from, top_ + gap, to - from, y_ + unresolved_height - top_ - gap);
            svg_.draw("<path class=\"unresolved\" d=\"{}\" fill=\"{}\"/>",
                      diamond((from + to) / 2, middle), not_known);
        }
        y_ += unresolved_height;
    }

    void axis() {
        const double foot = y_ + 6;
        svg_.draw("<path d=\"M{:.1f} {:.1f}H{:.1f}\" stroke=\"#222\"/>", axis_.left, foot,
                  axis_.right);
        svg_.text(margin, foot + 18, "frame", {12, Anchor::start, "#555"});
        const double step = nice_step(axis_.last - axis_.first, 12);
        const double begin = std::ceil(axis_.first / step - 1e-9) * step;
        for (int k = 0; begin + k * step <= axis_.last + 1e-9 * step; ++k) {
            const double tick = begin + k * step;
            svg_.draw("<path d=\"M{:.1f} {:.1f}v5\" stroke=\"#222\"/>", axis_.x(tick), foot);
            svg_.text_where_free(axis_.x(tick), foot + 18, fmt::format("{:.6g}", tick),
                                 {12, Anchor::middle});
        }
        for (const double at : places_) {
            svg_.draw_behind("<path d=\"M{:.1f} {:.1f}V{:.1f}\" stroke=\"#999\" "
                             "stroke-dasharray=\"2 3\"/>",
                             at, top_, foot);
        }
        y_ = foot + 22;
    }

    // Explains what is drawn, and nothing else.
    void legend() {
        const bool has_open = std::ranges::any_of(
            timeline_.events, [](const Event& event) { return !event.is_proved; });
        const bool has_dashes = std::ranges::any_of(
            steps_.steps, [](const Step& step) { return step.solid && !step.is_proved; });
        const bool has_hatching =
            !timeline_.unresolved.empty() ||
            std::ranges::any_of(steps_.steps, [](const Step& step) { return !step.solid; });
        double x = axis_.left;
        y_ += 20;
        const auto entry = [&](const std::string& words, double sign, auto&& draw_sign) {
            const double takes = sign + text_width(words, 12);
            if (x > axis_.left && x + takes > axis_.right) {
                x = axis_.left;
                y_ += 18;
            }
            draw_sign(x, y_ - 4);
            svg_.text(x + sign, y_, words, {12, Anchor::start, "#555"});
            x += takes + 18;
        };
        const auto sign = [&](bool up) {
            return [this, up](double at, double y) {
                svg_.draw("<path d=\"{}\" fill=\"#555\"/>", triangle(at + 5, y, up));
            };
        };
        if (lanes_.triangles) {
            entry("adds one", 14, sign(true));
            entry("takes one away", 14, sign(false));
        }
        if (lanes_.bin > 0) {
            entry("one event", 9, [&](double at, double y) {
                svg_.draw("<path d=\"M{:.1f} {:.1f}v8\" stroke=\"#555\"/>", at + 3, y - 4);
            });
            entry(lanes_.bin == 1 ? std::string("events in a frame")
                                  : fmt::format("events in {:g} frames", lanes_.bin),
                  17, [&](double at, double y) {
                      svg_.draw("<path d=\"M{:.1f} {:.1f}h4v-4h4v-5h4v9z\" fill=\"#555\"/>", at,
                                y + 4);
                  });
        }
        if (has_open || has_dashes) {
            entry("not proved", 38, [&](double at, double y) {
                svg_.draw("<path d=\"{}\" fill=\"#fff\" stroke=\"#555\" stroke-width=\"1.4\"/>",
                          triangle(at + 5, y, true));
                svg_.draw("<path d=\"M{:.1f} {:.1f}h20\" stroke=\"#1a3a52\" stroke-width=\"1.5\" "
                          "stroke-dasharray=\"4 3\"/>",
                          at + 14, y);
            });
        }
        if (has_hatching) {
            entry("unknown", 20, [&](double at, double y) {
                svg_.draw("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"16\" height=\"10\" "
                          "fill=\"url(#unknown)\"/>",
                          at, y - 5);
            });
        }
        if (x == axis_.left) y_ -= 20; // there was nothing to explain
    }

    const TimelineRecord& record_;
    const Timeline& timeline_;
    animation::FrameRate fps_;
    Steps steps_;
    const std::vector<Thumbnail>& thumbnails_;
    PlotAxis axis_;
    Svg svg_{width};
    double y_ = 0, top_ = 0; // where the next thing goes; where panels begin
    LanesDrawn lanes_;
    std::vector<double> places_; // of the thumbnails' frames
};

} // namespace

std::string plot_svg(const TimelineRecord& record, const std::vector<Thumbnail>& thumbnails) {
    return Plot(record, thumbnails).svg();
}

} // namespace isomotion::topology
