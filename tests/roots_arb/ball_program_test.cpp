// Doubles, intervals and balls agree on every field of the catalogue.
#include "arb/ball_program.h"

#include "formula/enclosure.h"
#include "scenes.h"

namespace isomotion::roots_arb::ball_program_test {
namespace {

using ball::Ball;
using ball::BallProgram;

using formula::Interval;

constexpr unsigned seed = 20240;
constexpr int points = 40;
constexpr slong precision = 200;

Ball value(BallProgram& program, const formula::Bindings<double>& bindings, const glm::dvec3& p,
           slong bits = precision) {
    const std::array<Ball, 3> inputs{Ball(p.x), Ball(p.y), Ball(p.z)};
    Ball f;
    program.evaluate(bindings, inputs, {&f, 1}, bits);
    return f;
}

// The ball is inside, or the interval in the ball: one double that is exact.
bool holds(const Interval& interval, const Ball& ball) {
    arf_t low, high;
    arf_init(low);
    arf_init(high);
    arb_get_interval_arf(low, high, ball.get(), precision);
    const bool inside = arf_cmp_d(low, interval.lo) >= 0 && arf_cmp_d(high, interval.hi) <= 0;
    const bool around = arf_cmp_d(low, interval.lo) <= 0 && arf_cmp_d(high, interval.hi) >= 0;
    arf_clear(low);
    arf_clear(high);
    return inside || around;
}

std::string text(const Ball& ball) {
    char* const digits = arb_get_str(ball.get(), 20, 0);
    std::string result = digits;
    flint_free(digits);
    return result;
}

class EverySurface : public testing::TestWithParam<std::string> {
protected:
    EverySurface()
        : surface(scene_named(GetParam()))
        , bindings(surface.bindings())
        , random(seed) {
        RecordProperty("seed", int(seed));
    }
    glm::dvec3 somewhere() { return catalogue::point_in(surface.at.surfaces[0].bounds, random); }

    catalogue::Used surface;
    formula::Bindings<double> bindings;
    formula::Random random;
};

// Doubles round no worse than balls of 48 bits, whose radius bounds what rounding makes of a value.
TEST_P(EverySurface, DoublesAreAsCloseToBallsAsRoundingAllows) {
    BallProgram program(surface.field().value);
    formula::Evaluator<double> evaluator(surface.field().value);
    int bounded = 0;
    for (int k = 0; k < points; ++k) {
        const glm::dvec3 p = somewhere();
        double f = 0;
        evaluator.point(bindings, catalogue::as_inputs(p), {&f, 1});
        const Ball exact = value(program, bindings, p);
        const Ball rough = value(program, bindings, p, 48);
        if (!rough.is_finite()) continue;
        ++bounded;
        EXPECT_TRUE(arb_contains(rough.get(), exact.get())) << text(rough) << " " << text(exact);
        EXPECT_TRUE(arb_contains(rough.get(), Ball(f).get()))
            << f << " is not in " << text(rough) << ", seed " << seed << ", point " << k;
    }
    EXPECT_EQ(bounded, points);
}

// The program that truth runs keeps Chebyshev polynomials whole, the other one runs their products.
TEST_P(EverySurface, BothProgramsAreOneFunction) {
    const formula::EnclosurePrograms programs = formula::enclosure_programs(surface.field());
    BallProgram lowered(surface.field().value), whole(programs.value);
    for (int k = 0; k < points; ++k) {
        const glm::dvec3 p = somewhere();
        const Ball a = value(lowered, bindings, p), b = value(whole, bindings, p);
        ASSERT_TRUE(a.is_finite() && b.is_finite());
        EXPECT_TRUE(arb_overlaps(a.get(), b.get()))
            << text(a) << " and " << text(b) << ", seed " << seed << ", point " << k;
    }
}

TEST_P(EverySurface, EnclosuresHoldTheBalls) {
    const formula::EnclosurePrograms programs = formula::enclosure_programs(surface.field());
    formula::Evaluator<Interval> evaluator(programs.value);
    const auto intervals = formula::convert<Interval>(surface.at.surfaces[0].bindings);
    BallProgram program(programs.value);
    for (int k = 0; k < points; ++k) {
        const glm::dvec3 p = somewhere();
        const Ball exact = value(program, bindings, p);
        for (const double reach : {0.0, 1e-9, 1e-3}) {
            std::array<Interval, 3> box;
            for (int axis = 0; axis < 3; ++axis) {
                const double low = p[axis] - reach * random.in(0, 1);
                box[std::size_t(axis)] = {low, p[axis] + reach * random.in(0, 1)};
            }
            Interval f;
            evaluator.point(intervals, box, {&f, 1});
            EXPECT_TRUE(holds(f, exact)) << "[" << f.lo << ", " << f.hi << "] and " << text(exact)
                                         << ", seed " << seed << ", point " << k;
        }
    }
}

// (F(p + s d) - F(p)) / s is in the enclosure of dF/dt over the way from p to p + s d.
TEST_P(EverySurface, SlopesHoldDifferenceQuotients) {
    const formula::EnclosurePrograms programs = formula::enclosure_programs(surface.field());
    formula::Evaluator<Interval> along(programs.directional);
    const auto intervals = formula::convert<Interval>(surface.at.surfaces[0].bindings);
    BallProgram program(programs.value), ball_along(programs.directional);
    for (int k = 0; k < points; ++k) {
        // Short ways have doubles for ends: the difference of the ends is the direction.
        const double way = std::exp2(-random.below(20));
        const glm::dvec3 p = somewhere(), q = p + way * (somewhere() - p);
        Ball quotient;
        const Ball f = value(program, bindings, q);
        arb_sub(quotient.get(), f.get(), value(program, bindings, p).get(), precision);
        std::array<Interval, 6> inputs;
        std::array<Ball, 6> balls;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double a = p[int(axis)], b = q[int(axis)];
            inputs[axis] = {std::min(a, b), std::max(a, b)};
            inputs[axis + 3] = Interval(b) - Interval(a);
            balls[axis] = Ball(std::min(a, b), std::max(a, b));
            balls[axis + 3] = Ball(b);
            arb_sub(balls[axis + 3].get(), balls[axis + 3].get(), Ball(a).get(), precision);
        }
        std::array<Interval, 2> enclosure;
        along.point(intervals, inputs, enclosure);
        EXPECT_TRUE(holds(enclosure[1], quotient))
            << "[" << enclosure[1].lo << ", " << enclosure[1].hi << "] and " << text(quotient)
            << ", seed " << seed << ", point " << k;
        std::array<Ball, 2> slope;
        ball_along.evaluate(bindings, balls, slope, precision);
        EXPECT_TRUE(!slope[1].is_finite() || arb_overlaps(slope[1].get(), quotient.get()))
            << text(slope[1]) << " and " << text(quotient) << ", seed " << seed << ", point " << k;
    }
}

// The ball over a box holds those of points in it, F and dF/dt: what searches for roots rest on.
TEST_P(EverySurface, WideBallsHoldTheirMembers) {
    const formula::EnclosurePrograms programs = formula::enclosure_programs(surface.field());
    BallProgram along(programs.directional);
    int bounded = 0;
    for (int k = 0; k < points; ++k) {
        const double reach = std::exp2(-random.below(20));
        const glm::dvec3 p = somewhere(), d = glm::normalize(somewhere() - p);
        std::array<Ball, 6> box, member;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double low = p[int(axis)] - reach, high = p[int(axis)] + reach;
            box[axis] = Ball(low, high);
            member[axis] = Ball(std::clamp(low + 2 * reach * random.in(0, 1), low, high));
            box[axis + 3] = member[axis + 3] = Ball(d[int(axis)]);
        }
        std::array<Ball, 2> wide, exact;
        along.evaluate(bindings, box, wide, 64);
        along.evaluate(bindings, member, exact, precision);
        for (std::size_t o = 0; o < 2; ++o) {
            if (!wide[o].is_finite() || !exact[o].is_finite()) continue;
            ++bounded;
            EXPECT_TRUE(arb_contains(wide[o].get(), exact[o].get()))
                << text(wide[o]) << " and " << text(exact[o]) << ", output " << o << ", seed "
                << seed << ", point " << k;
        }
    }
    EXPECT_GT(bounded, points / 2);
}

INSTANTIATE_TEST_SUITE_P(Balls, EverySurface, testing::ValuesIn(every_surface()),
                         [](const auto& surface) { return surface.param; });

} // namespace
} // namespace isomotion::roots_arb::ball_program_test
