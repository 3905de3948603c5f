// An attack on slopes: every operation and every pair of them, over boxes placed on and across
// their special points. What one value differs from another by, computed by Arb, must be within the
// slope's enclosure, or the enclosure must say nothing; so with slopes and second derivatives. What
// is evaluated in doubles, cut off as it is, must be so too.
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "arb/ball_program.h"
#include "formula/enclosure.h"
#include "formula/graph/functions.h"
#include "topology/field/jet.h"
#include "unit/formula/testing.h"

namespace isomotion::roots_arb::slopes_test {
namespace {

using ball::Ball;
using ball::BallProgram;
using formula::Bindings;
using formula::Evaluator;
using formula::Graph;
using formula::infinity;
using formula::Interval;
using formula::NodeId;
using formula::Program;
using formula::Random;

using Box = std::array<Interval, 3>;
using Point = std::array<double, 3>;

constexpr slong precision = 240;

// {} is what it is applied to; a second argument is an expression of y and z.
std::vector<std::string> operations() {
    std::vector<std::string> all{"-{}",
                                 "{} + y",
                                 "y - {}",
                                 "{}*y",
                                 "{0}*{0}",
                                 "{}/y",
                                 "y/{}",
                                 "min({}, y)",
                                 "max(z, {})",
                                 "({})^3",
                                 "({})^-1",
                                 "({})^-2",
                                 "({})^0.5",
                                 "({})^0.3",
                                 "({})^1.5",
                                 "({})^-0.5",
                                 "({})^(-301)",
                                 "({})^(-300)",
                                 "({})^301",
                                 "({})^40",
                                 "({})^y",
                                 "0^max({}, 0)",
                                 "max({}, 0)^max(y, 0)",
                                 "2^({})",
                                 "smoothmin({}, y, 0.5)",
                                 "chebyshev(4, {})",
                                 "chebyshev(30, {})",
                                 "20*({})",
                                 "({})/3"};
    for (const formula::Function& function : formula::functions()) {
        if (function.has_value) all.push_back(std::string(function.name) + "({})");
    }
    return all;
}

std::string applied(const std::string& operation, const std::string& to) {
    return fmt::format(fmt::runtime(operation), to);
}

// A number on or next to a place where operations have poles, jumps, kinks, ends and cuts.
double special(Random& random) {
    static constexpr std::array fixed{0.0,  1.0,   0.5,     2.0,      3.0,   69.07755278982137,
                                      99.0, 690.8, 1e-3,    1e-15,    1e8,   1.2345,
                                      4.0,  0.1,   1.3e-10, 2.5e-100, 0.999, 1.5};
    const double sign = random.below(2) == 0 ? 1 : -1;
    if (random.below(3) == 0) return sign * random.below(30) * (std::numbers::pi / 2);
    return sign * fixed[std::size_t(random.below(int(fixed.size())))];
}

Interval interval_about(double place, Random& random) {
    const double width = std::exp2(random.in(-40, 3));
    const double before = random.below(4) == 0 ? 0 : random.in(0, width);
    const double after = random.below(4) == 0 ? 0 : random.in(0, width);
    return {place - before, place + after};
}

double member(Interval a, Random& random) {
    const int choice = random.below(6);
    if (choice == 0) return a.lo;
    if (choice == 1) return a.hi;
    return std::clamp(random.in(a.lo, a.hi), a.lo, a.hi);
}

std::string describe(const Box& box) {
    std::string text;
    for (const Interval side : box) text += fmt::format("[{:.17g}, {:.17g}] ", side.lo, side.hi);
    return text;
}

// Whether a ball may hold a member of an enclosure.
bool meets(const Ball& ball, Interval enclosure) {
    return !ball.is_apart_from(enclosure.lo, enclosure.hi);
}

Ball quotient(const Ball& f, const Ball& g, double p, double q) {
    Ball over, difference;
    arb_sub(over.get(), Ball(p).get(), Ball(q).get(), precision);
    arb_sub(difference.get(), f.get(), g.get(), precision);
    arb_div(difference.get(), difference.get(), over.get(), precision);
    return difference;
}

// F, its three slopes and its six second derivatives over boxes, on paper and in doubles.
class Subject {
public:
    explicit Subject(const std::string& text)
        : text_(text) {
        Graph g;
        const NodeId root = formula::parse(g, text);
        constexpr std::array<std::size_t, 3> axes{0, 1, 2};
        over_boxes_ = formula::schedule(g, topology::jet_over_boxes(g, root, axes, 3));
        const std::vector<NodeId> numbers = topology::jet_at_points(g, root, axes, 3);
        at_points_ = formula::schedule(g, std::span(numbers).first(4));
        evaluated_ = formula::schedule_lowered(g, root);
        enclose_.emplace(over_boxes_);
        on_paper_.emplace(at_points_);
        evaluate_.emplace(evaluated_);
    }

    void attack(Random& random, int draws) {
        for (int draw = 0; draw < draws; ++draw) {
            Box box;
            for (Interval& side : box) side = interval_about(special(random), random);
            // Some sides rest.
            for (Interval& side : box) side = random.below(3) == 0 ? Interval(side.lo) : side;
            std::array<Interval, 10> bounds; // F, by x, y, z, and xx, xy, xz, yy, yz, zz
            enclose_->point(intervals_, box, bounds);
            Point p, q;
            for (std::size_t k = 0; k < 3; ++k) p[k] = member(box[k], random);
            const auto axis = std::size_t(random.below(3));
            q = p;
            q[axis] = member(box[axis], random);
            compare(box, bounds, p, q, axis);
            if (testing::Test::HasFatalFailure()) return;
        }
    }

    int quotients() const { return quotients_; }

private:
    std::array<Ball, 4> on_paper(const Point& p) {
        const std::array<Ball, 3> inputs{Ball(p[0]), Ball(p[1]), Ball(p[2])};
        std::array<Ball, 4> values;
        on_paper_->evaluate(numbers_, inputs, values, precision);
        return values;
    }

    void compare(const Box& box, const std::array<Interval, 10>& bounds, const Point& p,
                 const Point& q, std::size_t axis) {
        const auto at_p = on_paper(p), at_q = on_paper(q);
        const Interval slope = bounds[1 + axis];
        const bool says_something = slope != Interval::entire();
        const auto where = [&] {
            return fmt::format("{} over {}by {}, from {:.17g} to {:.17g}: slope [{:.17g}, {:.17g}]",
                               text_, describe(box), "xyz"[axis], p[axis], q[axis], slope.lo,
                               slope.hi);
        };
        for (const auto* values : {&at_p, &at_q}) {
            if (!(*values)[0].is_finite()) continue;
            ASSERT_TRUE(meets((*values)[0], bounds[0])) << where();
        }
        if (p[axis] == q[axis]) return;
        if (says_something && at_p[0].is_finite() && at_q[0].is_finite()) {
            ++quotients_;
            ASSERT_TRUE(meets(quotient(at_p[0], at_q[0], p[axis], q[axis]), slope)) << where();
        }
        if (says_something && bounds[0] != Interval::entire())
            compare_evaluated(slope, p, q, axis, where);
        // Second derivatives are all difference quotients of slopes.
        static constexpr std::size_t second[3][3]{{4, 5, 6}, {5, 7, 8}, {6, 8, 9}};
        for (std::size_t k = 0; k < 3; ++k) {
            const Interval bend = bounds[second[k][axis]];
            const Ball &a = at_p[1 + k], &b = at_q[1 + k];
            if (bend == Interval::entire() || !a.is_finite() || !b.is_finite()) continue;
            ++quotients_;
            ASSERT_TRUE(meets(quotient(a, b, p[axis], q[axis]), bend))
                << where()
                << fmt::format(", by {} once more [{:.17g}, {:.17g}]", "xyz"[k], bend.lo, bend.hi);
        }
    }

    // In doubles, which round: by 2^-24 of all that is in play, counted generously, over
    // differences that are not all rounding.
    template<class Where>
    void compare_evaluated(Interval slope, const Point& p, const Point& q, std::size_t axis,
                           Where&& where) {
        double f = 0, g = 0;
        evaluate_->point(numbers_, p, {&f, 1});
        evaluate_->point(numbers_, q, {&g, 1});
        ASSERT_FALSE(std::isnan(f) || std::isnan(g)) << where();
        if (std::isinf(f) || std::isinf(g)) return; // of what is beyond doubles nothing is said
        const double apart = p[axis] - q[axis];
        const double size = std::abs(p[axis]) + std::abs(q[axis]);
        if (std::abs(apart) < std::max(1e-3, 0x1p-20 * size)) return;
        const double found = (f - g) / apart;
        const double finite = formula::magnitude(intersect(slope, {-1e200, 1e200}));
        const double error =
            0x1p-24 * (1 + std::abs(f) + std::abs(g) + finite * (1 + size)) / std::abs(apart);
        ASSERT_TRUE(slope.lo <= found + error && found - error <= slope.hi)
            << where() << fmt::format(": evaluated {:.17g} and {:.17g}, {:.17g}", f, g, found);
    }

    std::string text_;
    Bindings<double> numbers_ = formula::test_bindings();
    Bindings<Interval> intervals_ = formula::convert<Interval>(numbers_);
    Program over_boxes_, at_points_, evaluated_;
    std::optional<Evaluator<Interval>> enclose_;
    std::optional<BallProgram> on_paper_;
    std::optional<Evaluator<double>> evaluate_;
    int quotients_ = 0;
};

std::uint64_t seed() {
    const char* given = std::getenv("ISOMOTION_SEED");
    return given ? std::strtoull(given, nullptr, 10) : 2201;
}

void attack(const std::vector<std::string>& formulas, int draws) {
    int quotients = 0;
    for (std::size_t k = 0; k < formulas.size(); ++k) {
        SCOPED_TRACE(fmt::format("seed {} (ISOMOTION_SEED)", seed()));
        Random random(seed() + k);
        Subject subject(formulas[k]);
        subject.attack(random, draws);
        quotients += subject.quotients();
        if (testing::Test::HasFatalFailure()) return;
    }
    std::printf("%zu formulas, %d quotients\n", formulas.size(), quotients);
    EXPECT_GT(quotients, draws * int(formulas.size()) / 4); // bounds that say something
}

std::vector<std::string> pairs() {
    std::vector<std::string> all;
    for (const std::string& outer : operations()) {
        for (const std::string& inner : operations())
            all.push_back(applied(outer, "(" + applied(inner, "x") + ")"));
    }
    return all;
}

TEST(Slopes, HoldQuotientsOfEveryOperation) {
    std::vector<std::string> formulas;
    for (const std::string& operation : operations()) formulas.push_back(applied(operation, "x"));
    // What rounds within an angle may come to much behind others: not in pairs.
    for (const char* angle :
         {"atan2(x, y)", "atan2(y, x*y)", "atan2(x - 1, y + z)*z", "cos(3*atan2(x, y))",
          "sin(2*atan2(y, x)) + z", "cos(atan2(y, x*y))", "tan(atan2(x*y, y))"})
        formulas.emplace_back(angle);
    attack(formulas, 300);
}

TEST(Slopes, HoldQuotientsOfEveryPair) { attack(pairs(), 60); }

// Ten million draws.
TEST(SlopesExhaustive, HoldQuotientsOfEveryPair) { attack(pairs(), 6000); }

} // namespace
} // namespace isomotion::roots_arb::slopes_test
