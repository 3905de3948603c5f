#include "topology/timeline/plot.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "topology/timeline/steps.h"
#include "topology/timeline/summary.h"
#include "topology/timeline/words.h"

namespace isomotion::topology {
namespace {

using formula::Interval;

constexpr double width = 1040, left = 150, right = 28, picture_size = 96;
constexpr double panel_height = 92, lane_height = 20, gap = 14;

struct Mark {
    Kind kind;
    const char* colour;
    bool adds; // to one of the Betti numbers; the other kinds take away
};
constexpr Mark marks[] = {
    {Kind::birth, "#009e73", true},        {Kind::death, "#cc79a7", false},
    {Kind::merge, "#0072b2", false},       {Kind::split, "#d55e00", true},
    {Kind::tunnel_forms, "#56b4e9", true}, {Kind::tunnel_closes, "#e69f00", false},
    {Kind::tunnel_opens, "#117733", true}, {Kind::tunnel_breaks, "#882255", false},
    {Kind::void_forms, "#332288", true},   {Kind::void_fills, "#999933", false},
    {Kind::void_opens, "#aa4499", false},  {Kind::void_born, "#44aa99", true},
    {Kind::unknown, "#666666", true},
};

std::string escaped(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        safe += c == '<'   ? "&lt;"
                : c == '>' ? "&gt;"
                : c == '&' ? "&amp;"
                : c == '"' ? "&quot;"
                           : std::string(1, c);
    }
    return safe;
}

// 1, 2 or 5 times a power of ten, so that at most `most` of them are in the span.
double nice_step(double span, double most) {
    const double rough = span / most, power = std::pow(10, std::floor(std::log10(rough)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= rough) return factor * power;
    }
    return 10 * power;
}

class Plot {
public:
    Plot(const TimelineRecord& record, const std::vector<Thumbnail>& thumbnails)
        : record_(record)
        , timeline_(record.timeline)
        , fps_(record.header.fps)
        , steps_(steps_of(record.timeline))
        , thumbnails_(thumbnails)
        , first_(frame_at(fps_, timeline_.range.lo))
        , last_(std::max(frame_at(fps_, timeline_.range.hi), first_ + 1e-9)) {}

    std::string svg() {
        title();
        if (!thumbnails_.empty()) pictures();
        top_ = y_;
        panel("components", &Betti::components, true);
        panel("tunnels", &Betti::tunnels, false);
        panel("voids", &Betti::voids, false);
        for (const Mark& mark : marks) lane(mark);
        unresolved_lane();
        axis();
        return fmt::format(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" "
            "xmlns:xlink=\"http://www.w3.org/1999/xlink\" width=\"{0}\" height=\"{1}\" "
            "viewBox=\"0 0 {0} {1}\" font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\" "
            "font-size=\"12\" fill=\"#222\">\n"
            "<defs><pattern id=\"unknown\" width=\"6\" height=\"6\" "
            "patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(45)\"><rect width=\"6\" "
            "height=\"6\" fill=\"#f4f4f4\"/><path d=\"M0 0V6\" stroke=\"#bbb\" "
            "stroke-width=\"2\"/></pattern></defs>\n"
            "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n{2}{3}</svg>\n",
            width, y_ + 8, behind_, body_);
    }

private:
    template<class... Args> void draw(fmt::format_string<Args...> format, Args&&... args) {
        body_ += fmt::format(format, std::forward<Args>(args)...) + "\n";
    }
    double x(double frame) const {
        return left + (width - left - right) * (frame - first_) / (last_ - first_);
    }
    double clamped(double frame) const { return x(std::clamp(frame, first_, last_)); }

    void title() {
        const bool complete = timeline_.is_complete();
        draw("<text x=\"16\" y=\"26\" font-size=\"17\" font-weight=\"bold\">{}</text>",
             escaped(record_.header.title));
        draw("<text x=\"16\" y=\"46\">{}</text>", escaped(tally(timeline_)));
        std::string verdict = "complete, all proved";
        if (!complete) {
            const auto reasons = gaps(timeline_, fps_);
            verdict = "incomplete: " + reasons.front();
            if (reasons.size() > 1) verdict += fmt::format(", and {} more", reasons.size() - 1);
        }
        draw("<text x=\"16\" y=\"64\" fill=\"{}\">{}</text>", complete ? "#117733" : "#b03a00",
             escaped(verdict));
        if (!complete) {
            draw("<text x=\"{:.1f}\" y=\"64\" text-anchor=\"end\" font-size=\"10\" "
                 "fill=\"#555\">hollow, dashed: not proved; hatched: unknown</text>",
                 width - right);
        }
        y_ = 84;
    }

    void pictures() {
        const double slot = (width - left - right) / double(thumbnails_.size());
        const double size = std::min(picture_size, slot - 6);
        const double foot = y_ + size + 16, top = foot + 26;
        for (std::size_t k = 0; k < thumbnails_.size(); ++k) {
            const Thumbnail& one = thumbnails_[k];
            const double middle = left + slot * (double(k) + 0.5), at = clamped(one.frame);
            draw("<image x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" "
                 "xlink:href=\"{}\"/>",
                 middle - size / 2, y_, size, size, escaped(one.picture));
            draw("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\" font-size=\"10\" "
                 "fill=\"#555\">{:.1f}</text>",
                 middle, foot - 4, one.frame);
            draw("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"#999\" fill=\"none\"/>", middle,
                 foot, at, top);
            places_.push_back(at);
        }
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
        draw("<text x=\"16\" y=\"{:.1f}\" font-weight=\"bold\">{}</text>", y_ + 14, label);
        for (int tick = 0; tick <= ceiling; tick += step) {
            draw("<path d=\"M{:.1f} {:.1f}H{:.1f}\" stroke=\"#e4e4e4\"/><text x=\"{:.1f}\" "
                 "y=\"{:.1f}\" text-anchor=\"end\" font-size=\"10\">{}</text>",
                 left, y(tick), width - right, left - 6, y(tick) + 3.5, tick);
        }
        for (std::size_t k = 0; k < steps_.steps.size(); ++k) {
            const Step& here = steps_.steps[k];
            // A step ends in the middle of the instant after it, narrow as those are.
            const double from = k > 0 ? moment_x(k - 1) : x(first_);
            const double to = k < steps_.instants.size() ? moment_x(k) : x(last_);
            if (!here.solid) {
                draw("<rect x=\"{:.2f}\" y=\"{:.1f}\" width=\"{:.2f}\" height=\"{:.1f}\" "
                     "fill=\"url(#unknown)\"/>",
                     from, foot - panel_height, to - from, panel_height);
                continue;
            }
            const double level = y((*here.solid).*number);
            draw("<rect x=\"{:.2f}\" y=\"{:.1f}\" width=\"{:.2f}\" height=\"{:.1f}\" "
                 "fill=\"#0072b2\" fill-opacity=\"0.13\"/>",
                 from, level, to - from, foot - level);
            draw("<path d=\"M{:.2f} {:.1f}H{:.2f}\" stroke=\"#1a3a52\" stroke-width=\"1.6\"{}/>",
                 from, level, to, here.is_proved ? "" : " stroke-dasharray=\"4 3\"");
            const Step* next = k + 1 < steps_.steps.size() ? &steps_.steps[k + 1] : nullptr;
            if (next && next->solid) {
                draw("<path d=\"M{:.2f} {:.1f}V{:.1f}\" stroke=\"#1a3a52\" stroke-width=\"1.6\" "
                     "stroke-linecap=\"square\"/>",
                     to, level, y((*next->solid).*number));
            }
        }
        y_ = foot;
    }
    double moment_x(std::size_t k) const {
        return clamped(mid(frames_at(fps_, steps_.instants[k].time)));
    }

    void lane_frame(const std::string& label, std::size_t count, const char* colour,
                    const std::string& sign) {
        if (!has_lanes_) y_ += gap;
        has_lanes_ = true;
        draw("<path d=\"M{:.1f} {:.1f}H{:.1f}\" stroke=\"#ececec\"/>", left, y_ + lane_height / 2,
             width - right);
        draw("<text x=\"34\" y=\"{:.1f}\">{}</text><text x=\"{:.1f}\" y=\"{:.1f}\" "
             "text-anchor=\"end\" fill=\"#666\">{}</text>",
             y_ + lane_height / 2 + 4, escaped(label), left - 8, y_ + lane_height / 2 + 4, count);
        draw("<path d=\"{}\" fill=\"{}\"/>", sign, colour);
    }
    static std::string triangle(double at, double middle, bool up) {
        const double tip = up ? -5 : 5;
        return fmt::format("M{:.2f} {:.1f}l4.5 {}h-9z", at, middle + tip, -2 * tip);
    }
    static std::string diamond(double at, double middle) {
        return fmt::format("M{:.2f} {:.1f}l5 5l-5 5l-5 -5z", at, middle - 5);
    }

    void lane(const Mark& mark) {
        const auto count = std::ranges::count(timeline_.events, mark.kind, &Event::kind);
        if (count == 0) return;
        const double start = has_lanes_ ? y_ : y_ + gap, middle = start + lane_height / 2;
        const bool known = mark.kind != Kind::unknown;
        const auto sign = [&](double at) {
            return known ? triangle(at, middle, mark.adds) : diamond(at, middle);
        };
        lane_frame(known ? std::string(name(mark.kind)) : "unknown", std::size_t(count),
                   mark.colour, sign(22));
        for (const Event& event : timeline_.events) {
            if (event.kind != mark.kind) continue;
            draw("<path d=\"{}\" {}/>", sign(clamped(mid(frames_at(fps_, event.time)))),
                 event.is_proved ? fmt::format("fill=\"{}\" fill-opacity=\"0.8\"", mark.colour)
                                 : fmt::format("fill=\"#fff\" stroke=\"{}\" stroke-width=\"1.4\"",
                                               mark.colour));
        }
        y_ += lane_height;
    }

    void unresolved_lane() {
        if (timeline_.unresolved.empty()) return;
        const double start = has_lanes_ ? y_ : y_ + gap, middle = start + lane_height / 2;
        lane_frame("unresolved", timeline_.unresolved.size(), "#b03a00", diamond(22, middle));
        for (const Unresolved& place : timeline_.unresolved) {
            const Interval frames = frames_at(fps_, place.time);
            const double from = clamped(frames.lo), to = std::max(clamped(frames.hi), from + 3);
            behind_ += fmt::format("<rect x=\"{:.2f}\" y=\"{:.1f}\" width=\"{:.2f}\" "
                                   "height=\"{:.1f}\" fill=\"url(#unknown)\"/>\n",
                                   from, top_ + gap, to - from, y_ + lane_height - top_ - gap);
            draw("<path d=\"{}\" fill=\"#b03a00\"/>", diamond((from + to) / 2, middle));
        }
        y_ += lane_height;
    }

    void axis() {
        const double foot = y_ + 6;
        draw("<path d=\"M{:.1f} {:.1f}H{:.1f}\" stroke=\"#222\"/>", left, foot, width - right);
        const double step = nice_step(last_ - first_, 12);
        const double begin = std::ceil(first_ / step - 1e-9) * step;
        for (int k = 0; begin + k * step <= last_ + 1e-9 * step; ++k) {
            const double tick = begin + k * step;
            draw("<path d=\"M{0:.1f} {1:.1f}v5\" stroke=\"#222\"/><text x=\"{0:.1f}\" "
                 "y=\"{2:.1f}\" text-anchor=\"middle\" font-size=\"10\">{3:.6g}</text>",
                 x(tick), foot, foot + 17, tick);
        }
        draw("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\" font-size=\"10\">frame</text>",
             left - 6, foot + 17);
        for (const double at : places_) {
            behind_ += fmt::format("<path d=\"M{:.1f} {:.1f}V{:.1f}\" stroke=\"#999\" "
                                   "stroke-dasharray=\"2 3\"/>\n",
                                   at, top_, foot);
        }
        y_ = foot + 22;
    }

    const TimelineRecord& record_;
    const Timeline& timeline_;
    animation::FrameRate fps_;
    Steps steps_;
    const std::vector<Thumbnail>& thumbnails_;
    double first_, last_;
    double y_ = 0, top_ = 0; // where the next thing goes; where panels begin
    bool has_lanes_ = false;
    std::vector<double> places_; // of the thumbnails' frames
    std::string behind_, body_;
};

} // namespace

std::string plot_svg(const TimelineRecord& record, const std::vector<Thumbnail>& thumbnails) {
    return Plot(record, thumbnails).svg();
}

} // namespace isomotion::topology
