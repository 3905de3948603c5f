// Controls the resolution while something moves, so that pictures keep coming at a wanted rate.
//
// A draw at scale s of the window's width and height is taken to cost a + b s^2 milliseconds. Both
// are fitted to the draws since the cost last changed, by least squares of relative errors. From
// that follows the largest scale within the budget of 1000 / fps. Scales come from a short ladder,
// and four rules keep them still:
//   * down only after two draws in a row over the budget, so that a hiccup of the machine changes
//     nothing and a heavier scene is answered at its second picture (the very first draw at once);
//   * up only when the model promises room to spare, `patience` times in a row;
//   * a rise that had to be taken back doubles the patience;
//   * once settled, no change within two seconds of the last, unless the cost has changed or a
//     draw takes half as long again as it may.
// Pure: the state is a value, the clock is the caller's. Leave out draws that compile.
#pragma once

#include <optional>
#include <vector>

namespace isomotion::player {

// Scales, each with half as many pixels as two before it: 2^(-k/4), from 1 to 1/16.
inline constexpr int scale_count = 17;
double scale_of(int rung);

// The cost of a picture; never negative.
struct CostModel {
    double fixed = 0;  // a: milliseconds whatever the size
    double filled = 0; // b: milliseconds a picture of full size takes beside that

    double at(double scale) const { return fixed + filled * scale * scale; }
};

struct MeasuredDraw {
    double scale = 1;
    double milliseconds = 0;
    double at = 0; // seconds, by the caller's clock
};

// Least squares of relative errors, with a and b not below 0. Draws that all have one scale don't
// tell a from b: then a is the same part of the whole as in `before`.
CostModel cost_of(const std::vector<MeasuredDraw>& draws, const CostModel& before);

struct ResolutionController {
    int rung = 0;                      // scale_of(rung) is the next draw's
    std::vector<MeasuredDraw> draws;   // the model is fitted to these, the latest last
    std::optional<MeasuredDraw> stray; // the last one, if it was far off the cost of its scale
    CostModel model;
    int over = 0;          // draws in a row over the budget
    int roomy = 0;         // draws in a row that leave room for a larger picture
    int patience = 6;      // so many of them make it larger
    int steady = 0;        // draws since the scale changed
    double changed = -1e9; // when that was, seconds
    int settling = 0;      // draws since the cost last changed
    bool rose = false;     // when it did

    double scale() const { return scale_of(rung); }
};

// Takes a draw into account, of whatever scale; `fps` is the wanted rate. Ignores times and scales
// that are not positive.
ResolutionController adjusted(ResolutionController controller, const MeasuredDraw& draw,
                              double fps);

} // namespace isomotion::player
