// Controls the resolution while something moves, so that pictures come at a desired rate.
//
// The model is that a draw at scale s of the window's width and height costs a + b s^2
// milliseconds. Both are fitted to the draws since the cost last changed, by least squares of
// relative errors. They give the largest scale within the budget: 1000 / fps less what it takes to
// put a picture on the screen. Scales come from a short ladder, and four rules keep them stable:
//
//   * down only after two successive draws over the budget, so that a hiccup of the machine changes
//     nothing and a heavier scene takes effect at its second picture (the very first draw at once);
//   * up only when the model predicts room to spare, `patience` times in a row;
//   * a rise that had to be reversed doubles the patience;
//   * once settled, no change within two seconds of the last, unless the cost has changed or a
//     draw takes half as long again as the budget.
//
// The controller is pure: the state is a value, and the caller provides the clock. Leave out draws
// that compile.
#pragma once

#include <optional>
#include <vector>

namespace isomotion::player {

// Scales, each with half as many pixels as two before it: 2^(-k/4), from 1 to 1/16.
inline constexpr int scale_count = 17;
double scale_of(int rung);

// The cost of a picture; never negative.
struct CostModel {
    double fixed = 0;  // a: milliseconds independent of the size
    double filled = 0; // b: additional milliseconds of a picture of full size

    double at(double scale) const { return fixed + filled * scale * scale; }
};

struct MeasuredDraw {
    double scale = 1;
    double milliseconds = 0;
    double at = 0;      // seconds, by the caller's clock
    double display = 0; // milliseconds to put it on the screen, which no draw runs beside
};

// Least squares of relative errors, with a and b at least 0. Draws of one scale can't separate a
// from b; then a is the same part of the total as in `before`.
CostModel cost_of(const std::vector<MeasuredDraw>& draws, const CostModel& before);

struct ResolutionController {
    int rung = 0;                      // scale_of(rung) is the next draw's
    std::vector<MeasuredDraw> draws;   // the model is fitted to these, the latest last
    std::optional<MeasuredDraw> stray; // the last draw, if it was far off the cost of its scale
    CostModel model;
    int over = 0;          // successive draws over the budget
    int roomy = 0;         // successive draws that leave room for a larger picture
    int patience = 6;      // the number of such draws that make it larger
    int steady = 0;        // draws since the scale changed
    double changed = -1e9; // time of that change, seconds
    int settling = 0;      // draws since the cost last changed
    bool rose = false;     // whether it rose then

    double scale() const { return scale_of(rung); }
};

// Updates the controller with a draw of any scale; `fps` is the desired rate. Ignores times and
// scales that are not positive.
ResolutionController adjusted(ResolutionController controller, const MeasuredDraw& draw,
                              double fps);

} // namespace isomotion::player
