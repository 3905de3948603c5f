// Tapes for boxes are the whole tape's function there.
#include "formula/tape/tape_cells.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "formula/enclosure.h"
#include "formula/field.h"
#include "formula/graph/operations.h"
#include "formula/interval/interval_operations.h"
#include "formula/interval/noise_enclosure.h"
#include "formula/tape/unrolled.h"
#include "testing.h"

namespace isomotion::formula {
namespace {

// Runs a tape in doubles, or over a box in intervals.
template<class Number>
std::vector<Number> run(const Tape& tape, const std::array<Number, 6>& inputs) {
    using Do = Operations<Number>;
    std::vector<Number> values;
    for (const TapeStep& step : tape.steps) {
        std::array<Number, 4> of{};
        for (std::size_t k = 0; k < step.arity; ++k) of[k] = values[std::size_t(step.operands[k])];
        const auto value = [&]() -> Number {
            switch (step.op) {
            case Op::constant:
                if constexpr (std::is_same_v<Number, double>)
                    return mid(step.value);
                else
                    return step.value;
            case Op::input:
                return inputs[std::size_t(step.index)];
            case Op::negate:
                return Do::negate(of[0]);
#define CASE(name, ...)                                                                            \
    case Op::name:                                                                                 \
        return Do::name(of[0]);
                ISOMOTION_FUNCTIONS(CASE)
#undef CASE
            case Op::add:
                return Do::add(of[0], of[1]);
            case Op::subtract:
                return Do::subtract(of[0], of[1]);
            case Op::multiply:
                return Do::multiply(of[0], of[1]);
            case Op::divide:
                return Do::divide(of[0], of[1]);
            case Op::min:
                return Do::min(of[0], of[1]);
            case Op::max:
                return Do::max(of[0], of[1]);
            case Op::power:
                return Do::power(of[0], of[1]);
            case Op::select:
                return Do::select(of[0], of[1], of[2], of[3]);
            case Op::noise: {
                const NoiseOrder order = NoiseOrder::unpacked(step.index);
                if constexpr (std::is_same_v<Number, double>)
                    return noise(of[0], of[1], of[2], order);
                else
                    return NoiseEnclosure(order)(of[0], of[1], of[2]);
            }
            default:
                ADD_FAILURE() << "no operation " << int(step.op);
                return Number(0);
            }
        };
        values.push_back(value());
    }
    std::vector<Number> outputs;
    for (const int output : tape.outputs) outputs.push_back(values[std::size_t(output)]);
    return outputs;
}

Tape tape_of_field(const std::string& formula) {
    const Field field = make_field(formula, {});
    return tape_of(std::array<TapeSource, 2>{{{field.value}, {field.directional, 1, 1}}}).value();
}

void expect_same(double a, double b, const std::string& where) {
    if (std::isnan(a) || std::isnan(b)) {
        EXPECT_EQ(std::isnan(a), std::isnan(b)) << where;
    } else {
        EXPECT_NEAR(a, b, 1e-9 * (1 + std::abs(a))) << where;
    }
}

// Formulas whose choices are decided in some boxes and not in others.
const std::vector<std::string> formulas_with_choices{
    "min(x, y) - z",
    "max(min(x^2 + y^2, z), abs(x - y) - 0.2)",
    "abs(abs(x) - 0.3) + abs(y)*z",
    "floor(3*x) + floor(2*y)*z",
    "sign(x)*y + sign(z - 2)",
    "x*max(0, y) + z*min(0, y - 3)",
    "min(exp(x), log(2 + y)) - sqrt(max(0, z))",
    "max(x, x) + min(y, 1)*max(z, -4) + 0*x",
    "(abs(x) - x)*(y + 1) - z",
    "min((x-0.5)^2+y^2+z^2, (x+0.5)^2+y^2+z^2, x^2+(y-1)^2+z^2) - 0.1",
    // sides that a third one beats, below what hands them on
    "min(min(x + 2, y + 1), min(z, 3*x))",
    "max(0.5 - min(x, y, z, x + y, y + z), -max(x*y, y*z, z*x, x - 1) - 0.1)",
    "abs(min(x, y, z, x + 1) - 0.5) - 0.2",
    // compared twice, or for a value of another kind
    "max(x*y, z) - min(x*y, z)",
    "min(x, y)*min(x, y, z) - max(x, 0.5)",
    "max(max(x, 0), z) + sqrt(x) - 1",
    "max(max(1, abs(x)), z) + asin(x) - 2.5",
    "max(noise(x, 2*y, z) - y, min(z, noise(z, x, 0.5)) - 2)",
    "min(y, min(log(x), 2 + x^2))",
};

// A box in another, or anywhere.
std::array<Interval, 6> random_box(Random& random, const std::array<Interval, 6>& around) {
    std::array<Interval, 6> box;
    for (std::size_t i = 0; i < 6; ++i) {
        const double size = (around[i].hi - around[i].lo) * std::exp2(random.in(-8, -1));
        const double low = random.in(around[i].lo, around[i].hi - size);
        box[i] = {low, low + size};
    }
    return box;
}

TEST(Tape, WithinABoxIsTheWholeTapesFunction) {
    constexpr int seed = 61;
    Random random(seed);
    std::array<Interval, 6> everywhere;
    everywhere.fill({-4, 4});
    std::size_t shorter = 0, all = 0;
    for (const std::string& formula : formulas_with_choices) {
        const Tape whole = tape_of_field(formula);
        Specialiser specialise;
        for (int k = 0; k < 200; ++k) {
            // shortened twice, as for cells in cells
            const auto box = random_box(random, everywhere), part = random_box(random, box);
            Tape here, within;
            specialise(whole, box, here);
            specialise(here, part, within);
            ++all;
            shorter += here.steps.size() < whole.steps.size();
            EXPECT_LE(within.steps.size(), here.steps.size() + 1) << formula;
            for (int p = 0; p < 8; ++p) {
                std::array<double, 6> at{};
                for (std::size_t i = 0; i < 6; ++i) at[i] = random.in(part[i].lo, part[i].hi);
                const auto a = run(whole, at), b = run(here, at), c = run(within, at);
                ASSERT_EQ(a.size(), b.size());
                for (std::size_t o = 0; o < a.size(); ++o) {
                    const std::string where = formula + ", output " + std::to_string(o) +
                                              ", seed " + std::to_string(seed);
                    expect_same(a[o], b[o], where);
                    expect_same(a[o], c[o], where);
                }
            }
        }
    }
    EXPECT_GT(double(shorter), 0.5 * double(all));
}

// Enclosures tell jumps by infinite bounds, which are no values: they must not be decided away.
TEST(Tape, KeepsWhatTellsJumps) {
    constexpr int seed = 63;
    Random random(seed);
    std::array<Interval, 6> everywhere;
    everywhere.fill({-2, 2});
    int infinite = 0;
    for (const char* formula : {"sign(x) + 0.5", "sign(x)*y + floor(z)", "floor(3*x)*y - z"}) {
        const Field field = make_field(formula, {});
        const EnclosurePrograms& programs = enclosure_programs(field);
        const Tape whole =
            tape_of(std::array<TapeSource, 3>{
                        {{programs.value}, {programs.breaks, 0}, {programs.directional, 1, 1}}})
                .value();
        for (int k = 0; k < 200; ++k) {
            const auto box = random_box(random, everywhere);
            Tape here;
            Specialiser()(whole, box, here);
            const auto a = run(whole, box), b = run(here, box);
            for (std::size_t o = 0; o < a.size(); ++o) {
                const std::string where = std::string(formula) + ", output " + std::to_string(o) +
                                          ", seed " + std::to_string(seed);
                expect_same(std::max(a[o].lo, -1e300), std::max(b[o].lo, -1e300), where);
                expect_same(std::min(a[o].hi, 1e300), std::min(b[o].hi, 1e300), where);
                infinite += a[o].hi > 1e300;
            }
        }
    }
    EXPECT_GT(infinite, 100);
}

// However they are ordered: a minimum of minima compares far ones with far ones.
TEST(Tape, DropsFarBallsThatAreComparedWithFarOnesOnly) {
    Random random(62);
    std::vector<std::string> balls;
    for (int k = 0; k < 64; ++k) {
        const double distance = k == 0 ? 0 : random.in(2, 3), turn = random.in(0, 6.28);
        balls.push_back("(x - " + std::to_string(distance * std::cos(turn)) + ")^2 + (y - " +
                        std::to_string(distance * std::sin(turn)) + ")^2 + z^2 - 0.1");
    }
    std::swap(balls.front(), balls.back());
    std::string chain = balls.front();
    for (std::size_t k = 1; k < balls.size(); ++k) chain = "min(" + chain + ", " + balls[k] + ")";
    const Tape whole = tape_of_field("0.5*max(-(" + chain + "), z - 9)");
    std::array<Interval, 6> box;
    box.fill({-0.2, 0.2});
    Tape near;
    Specialiser()(whole, box, near);
    const Tape one = tape_of_field("0.5*-(" + balls.back() + ")");
    EXPECT_GT(whole.steps.size(), 64u * 4);
    EXPECT_LE(near.steps.size(), one.steps.size() + 2);
}

TEST(Tape, KeepsOfManyBallsThoseThatAreNear) {
    std::string formula = "min(";
    for (int k = 0; k < 64; ++k)
        formula += (k > 0 ? ", " : "") + std::string("(x - ") + std::to_string(k) +
                   ")^2 + y^2 + z^2 - 0.1";
    const Tape whole = tape_of_field(formula + ")");
    Tape near;
    Specialiser()(whole,
                  std::array<Interval, 6>{Interval(30.1, 30.2), Interval(0, 0.1), Interval(0, 0.1),
                                          Interval(-1, 1), Interval(-1, 1), Interval(-1, 1)},
                  near);
    EXPECT_GT(whole.steps.size(), 64u * 4);
    EXPECT_LT(near.steps.size(), 30u);
}

TEST(Tape, LoopsOverElementsHaveNone) {
    const Field field = make_field("sum(blobs, (x - cx)^2) - 1", test_vocabulary());
    EXPECT_FALSE(tape_of(std::array<TapeSource, 1>{{{field.value}}}));
}

// The number of registers that the tape's words take.
int registers_of(const Tape& tape) {
    const TapeOperations operations(tape, TapeNumbers::floats);
    return words_of(tape, operations, 6, 1 << 20).value().registers;
}

// The slope of a product of sums needs the values of both, and both slopes.
TEST(Tape, KeepsFewValuesOfLongProducts) {
    std::string first, second;
    for (int k = 0; k < 300; ++k) {
        const std::string plus = k == 0 ? "" : " + ", number = std::to_string(0.3 + 0.01 * k);
        first += plus + "sin(" + number + "*x - y)*cos(y + " + number + "*z)";
        second += plus + "cos(x*z - " + number + ")";
    }
    const Tape tape = tape_of_field("(" + first + ")*exp(" + second + ") - 1");
    EXPECT_LT(registers_of(tape), 40);
}

// All monomials share the powers of x, y and z. Their slopes wait until the sums that they enter
// have come to them, though the powers are there from the first.
TEST(Tape, KeepsFewValuesOfLongPolynomials) {
    constexpr int degree = 14;
    std::string monomials = "-0.5";
    for (int i = 0; i <= degree; ++i) {
        for (int j = 0; i + j <= degree; ++j) {
            for (int k = 0; i + j + k <= degree; ++k)
                monomials +=
                    fmt::format(" + {}*x^{}*y^{}*z^{}", 0.3 + 0.01 * (i + 2 * j - k), i, j, k);
        }
    }
    EXPECT_LT(registers_of(tape_of_field(monomials)), 100);
}

// Of what is needed for each of many elements, what is cheap is computed again.
TEST(Tape, RepeatsCheapStepsThatAreNeededMuchLater) {
    std::string terms;
    for (int k = 0; k < 600; ++k)
        terms += (k == 0 ? "" : " + ") + ("sin(" + std::to_string(0.3 + 0.01 * k)) + "*x - cx)";
    const Field field = make_field("sum(blobs, (" + terms + ")*cy)", test_vocabulary());
    const ElementParameters elements(0, field.packing, {{3, 3}, {}});
    const auto value = unrolled(field.value, elements, 1 << 20);
    const auto slope = unrolled(field.directional, elements, 1 << 20);
    ASSERT_TRUE(value && slope);
    const Tape tape = tape_of(std::array<TapeSource, 2>{{{*value}, {*slope, 1, 1}}}).value();
    EXPECT_LT(registers_of(with_parameters(tape, std::vector<Interval>(100, 0.3))), 100);
}

TEST(Tape, IsInWordsThatAnInterpreterReads) {
    // Every instruction but a call is two words, in turns of eight; registers serve again.
    const Tape tape = part_of(tape_of_field("min(x*y, z) + 0.1*x - 2*y"), 0, 1);
    const TapeOperations operations(tape, TapeNumbers::floats);
    const auto words = words_of(tape, operations, 3);
    ASSERT_TRUE(words);
    EXPECT_EQ(words->words.size() % (2 * tape_unrolled), 0u);
    EXPECT_EQ(words->turns * 2 * tape_unrolled, int(words->words.size()));
    EXPECT_LE(words->registers, 8);
    EXPECT_FALSE(words_of(tape, operations, 3, 4));
    const Tape calls = part_of(tape_of_field("exp(x) + sin(y)*log(z)"), 0, 1);
    const TapeOperations of_calls(calls, TapeNumbers::floats);
    EXPECT_TRUE(of_calls.has_calls());
    EXPECT_TRUE(words_of(calls, of_calls, 3));
    const Tape noises = part_of(tape_of_field("noise(x, y, z) + noise(y, z, 2*x) + exp(x)"), 0, 1);
    const TapeOperations of_noises(noises, TapeNumbers::intervals);
    EXPECT_EQ(of_noises.orders_of_noise(), 1);
    const auto with_noises = words_of(noises, of_noises, 3);
    ASSERT_TRUE(with_noises);
    EXPECT_EQ(with_noises->noises, 2);
}

// Of the cells of a grid those hold no root whose tape says so, and each finds a tape.
TEST(TapeCells, TellCellsWithoutRoots) {
    std::string formula = "min(";
    for (const char* ball :
         {"(x-0.5)^2 + y^2 + z^2", "(x+0.5)^2 + y^2 + z^2", "x^2 + (y-0.5)^2 + z^2",
          "x^2 + (y+0.5)^2 + z^2", "x^2 + y^2 + (z-0.5)^2", "x^2 + y^2 + (z+0.5)^2"})
        formula += (formula.back() == '(' ? "" : ", ") + std::string(ball);
    const Field field = make_field(formula + ") - 0.04", {});
    const auto group = TapeFunctions::of(
        {{field.value, TapeNumbers::floats}, {field.directional, TapeNumbers::floats, 1, 1}});
    ASSERT_TRUE(group);
    const std::array<Interval, 3> box{Interval(-1, 1), Interval(-1, 1), Interval(-1, 1)};
    TapeLimits limits;
    limits.threads = 2;
    const TapeCells cells = tape_cells(std::array{*group}, {}, box, limits);
    ASSERT_GE(cells.levels, 2);
    const Tape whole = tape_of(std::array<TapeSource, 1>{{{field.value}}}).value();
    const int n = 1 << cells.levels;
    const std::size_t all = std::size_t(n) * n * n;
    const std::size_t first = std::size_t(cells.spans_of_a_function()) - all;
    std::size_t free = 0;
    for (std::size_t k = 0; k < all; ++k) {
        const std::uint32_t notes = cells.spans[2 * (first + k) + 1];
        EXPECT_LE(cells.spans[2 * (first + k)] + (notes & 0xffffffu), cells.words.size() / 2);
        EXPECT_GT(notes & 0xffffffu, 0u);
        if (!(notes & TapeCells::free)) continue;
        ++free;
        const std::array<int, 3> at{int(k) % n, int(k) / n % n, int(k) / (n * n)};
        for (int corner = 0; corner < 8; ++corner) {
            const auto side = [&](int i) {
                return -1 + (at[std::size_t(i)] + (corner >> i & 1)) * 2.0 / n;
            };
            const double f = run(whole, std::array<double, 6>{side(0), side(1), side(2)})[0];
            ASSERT_EQ(f < 0, bool(notes & TapeCells::negative)) << k << ": " << f;
        }
    }
    EXPECT_GT(free, all / 4);
    EXPECT_LT(free, all);
}

} // namespace
} // namespace isomotion::formula
