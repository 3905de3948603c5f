#include "player/draw/resolution_controller.h"

#include <algorithm>
#include <cmath>

namespace isomotion::player {
namespace {

constexpr std::size_t remembered = 8; // draws that the model is fitted to
constexpr double another_cost = 1.5;  // so many times more or less is not the same scene any more
constexpr double fall_to = 0.9;       // of the budget, after it was missed
constexpr double rise_to = 0.8;       // of the budget, before a larger picture is tried
constexpr int tallest_rise = 4;       // rungs: four times as many pixels
constexpr int least_patience = 6, most_patience = 192;
constexpr int taken_back = 30;      // draws: a fall so soon after a rise says the rise was wrong
constexpr int well_tried = 300;     // draws at one scale, after which that is forgiven
constexpr double least_hold = 2;    // seconds at one scale, once settled
constexpr int settles = 30;         // draws of one cost
constexpr double far_over = 1.5;    // times the budget
constexpr double least_part = 0.25; // of the time between pictures, which draws get in any case

// The largest picture that costs no more.
int largest_within(const CostModel& model, double milliseconds) {
    int rung = 0;
    while (rung + 1 < scale_count && model.at(scale_of(rung)) > milliseconds) ++rung;
    return rung;
}

// The mean cost of the draws with this scale; 0 without any.
double mean_at(const std::vector<MeasuredDraw>& draws, double scale) {
    double sum = 0;
    int count = 0;
    for (const MeasuredDraw& draw : draws) {
        if (draw.scale != scale) continue;
        sum += draw.milliseconds;
        ++count;
    }
    return count == 0 ? 0 : sum / count;
}

// +1: far dearer than draws of its scale were, -1: far cheaper.
int deviation(const std::vector<MeasuredDraw>& draws, const MeasuredDraw& draw) {
    const double usual = mean_at(draws, draw.scale);
    if (usual == 0) return 0;
    if (draw.milliseconds > another_cost * usual) return 1;
    return draw.milliseconds * another_cost < usual ? -1 : 0;
}

// Takes a draw into the history: a lone stray is held back until the next one tells whether it was
// a hiccup, which is dropped, or the scene has changed, and all before it is.
void remember(ResolutionController& p, const MeasuredDraw& draw) {
    const int off = deviation(p.draws, draw);
    if (!p.stray) {
        if (off != 0) {
            p.stray = draw;
            return;
        }
    } else if (off != 0 && off == deviation(p.draws, *p.stray)) {
        p.draws = {*p.stray};
        p.stray.reset();
        p.settling = 0;
    } else {
        p.stray.reset();
    }
    p.draws.push_back(draw);
    if (p.draws.size() > remembered) p.draws.erase(p.draws.begin());
    p.model = cost_of(p.draws, p.model);
}

void fall(ResolutionController& p, double budget, double now) {
    p.rung =
        std::min(std::max(p.rung + 1, largest_within(p.model, fall_to * budget)), scale_count - 1);
    if (p.rose && p.steady < taken_back) p.patience = std::min(2 * p.patience, most_patience);
    p.over = p.roomy = p.steady = 0;
    p.changed = now;
    p.rose = false;
}

} // namespace

double scale_of(int rung) { return std::exp2(-0.25 * std::clamp(rung, 0, scale_count - 1)); }

CostModel cost_of(const std::vector<MeasuredDraw>& draws, const CostModel& before) {
    // With x = 1/ms and y = s^2/ms the errors are a x + b y - 1.
    double x = 0, y = 0, xx = 0, xy = 0, yy = 0, least = 1e300, most = 0;
    for (const MeasuredDraw& draw : draws) {
        const double area = draw.scale * draw.scale;
        const double u = 1 / draw.milliseconds, v = area / draw.milliseconds;
        x += u, y += v, xx += u * u, xy += u * v, yy += v * v;
        least = std::min(least, area);
        most = std::max(most, area);
    }
    if (draws.empty()) return before;
    if (most < 1.9 * least) {
        // As good as one size: the shape stays, its height is fitted.
        const CostModel shape = before.at(1) > 0 ? before : CostModel{0, 1};
        double c = 0, cc = 0;
        for (const MeasuredDraw& draw : draws) {
            const double part = shape.at(draw.scale) / draw.milliseconds;
            c += part;
            cc += part * part;
        }
        return {shape.fixed * c / cc, shape.filled * c / cc};
    }
    const double det = xx * yy - xy * xy;
    const CostModel both{(x * yy - y * xy) / det, (y * xx - x * xy) / det};
    if (!(both.fixed >= 0)) return {0, y / yy};
    if (!(both.filled >= 0)) return {x / xx, 0};
    return both;
}

ResolutionController adjusted(ResolutionController p, const MeasuredDraw& draw, double fps) {
    constexpr double most = 1e9;
    if (!(draw.milliseconds > 0 && draw.milliseconds < most && draw.scale > 0 && fps > 0)) return p;
    const double period = 1000 / fps;
    const double budget = std::max(period - std::max(draw.display, 0.0), least_part * period);
    const bool first = p.draws.empty();
    remember(p, draw);
    // One that was begun before the scale changed says what it costs, and no more.
    if (draw.scale != p.scale()) return p;

    p.steady = std::min(p.steady + 1, well_tried);
    p.settling = std::min(p.settling + 1, settles);
    const bool is_held = p.settling == settles && draw.at - p.changed < least_hold;
    if (p.steady == well_tried) p.patience = least_patience;
    p.over = draw.milliseconds > budget ? p.over + 1 : 0;
    if (p.over >= (first ? 1 : 2) && !(is_held && draw.milliseconds < far_over * budget)) {
        fall(p, budget, draw.at);
        return p;
    }
    const int higher = largest_within(p.model, rise_to * budget);
    p.roomy = p.over == 0 && !p.stray && higher < p.rung ? p.roomy + 1 : 0;
    if (p.roomy >= p.patience && !is_held) {
        p.rung = std::max(higher, p.rung - tallest_rise);
        p.roomy = p.steady = 0;
        p.changed = draw.at;
        p.rose = true;
    }
    return p;
}

} // namespace isomotion::player
