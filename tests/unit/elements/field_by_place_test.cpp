// What is said of a field over boxes from the elements that matter there, against the field itself.
#include "elements/field_by_place.h"

#include <cmath>

#include <gmock/gmock.h>

#include "families.h"

namespace isomotion::elements {
namespace {

const Region ball{glm::dvec3(-1.1), glm::dvec3(1.1)};

using Point = std::array<double, 3>;

class Boxes : public testing::TestWithParam<Family> {
protected:
    Boxes()
        : field_(formula::make_field(GetParam().formula, family_vocabulary())) {}

    Point place(double margin) {
        std::uniform_real_distribution<double> in(-1.1 + margin, 1.1 - margin);
        return {in(draw_), in(draw_), in(draw_)};
    }

    std::mt19937 draw_{20261126};
    formula::Field field_;
};

TEST_P(Boxes, HoldValuesAndSlopesOfAllElements) {
    SCOPED_TRACE("seed 20261126");
    for (const int count : {65, 700}) {
        const double spacing = 0.8 / std::cbrt(count);
        const auto values = drawn_elements(draw_, count, spacing);
        const auto by_place = FieldByPlace::of(field_, std::array{count});
        ASSERT_TRUE(by_place);
        const FieldByPlace::Frame frame = by_place->at(values, ball, 2);
        BoxesByPlace directional(frame.programs().directional, frame);
        formula::FieldEvaluator<double> evaluator(field_);
        const auto all = formula::convert<double>(values);
        // What is left out differs from place to place, and counts as if it were the same.
        double left_out = 0;
        for (const double most : frame.grid().left_out) left_out += most;
        int bounded = 0, slopes = 0;
        for (int k = 0; k < 300; ++k) {
            const double size = std::exp2(std::uniform_real_distribution<double>(-14, -2)(draw_));
            const Point a = place(0.26);
            const Point d{place(0.1)[0], place(0.1)[1], place(0.1)[2]};
            std::array<Interval, 6> box;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double b = a[axis] + size * d[axis];
                box[axis] = Interval(std::min(a[axis], b), std::max(a[axis], b));
                box[3 + axis] = d[axis];
            }
            std::array<Interval, 2> told;
            std::array<std::span<const Interval>, 6> from;
            for (std::size_t i = 0; i < 6; ++i) from[i] = {&box[i], 1};
            directional.points(from, std::array{std::span(&told[0], 1), std::span(&told[1], 1)});
            bounded += told[0] != Interval::entire();
            slopes += told[1] != Interval::entire();
            const auto at = [&](double t) {
                return evaluator.value(all, {a[0] + t * d[0], a[1] + t * d[1], a[2] + t * d[2]});
            };
            for (const double part : {0.0, 0.3, 1.0}) {
                const double f = at(part * size);
                if (std::isnan(f)) {
                    EXPECT_EQ(told[0], Interval::entire());
                    continue;
                }
                // Doubles, too, are rounded.
                const double slack = 1e-11 * (1 + std::abs(f));
                EXPECT_TRUE(contains(told[0], f) || contains(told[0] + Interval(-slack, slack), f))
                    << count << ": " << f << " in " << testing::PrintToString(told[0]);
            }
            const double change = at(size) - at(0);
            if (std::isnan(change) || told[1] == Interval::entire()) continue;
            // A logarithm of what is left out is more.
            const double factor = std::string(GetParam().name) == "logarithm" ? 10 : 2;
            const double slack = factor * left_out + 1e-11;
            EXPECT_GE(change, size * told[1].lo - slack);
            EXPECT_LE(change, size * told[1].hi + slack);
        }
        EXPECT_GT(bounded, std::string(GetParam().name) == "ratio" ? 10 : 150);
        EXPECT_GT(slopes, 10);
    }
}

class ExactBoxes : public Boxes {};

// Where lists leave nothing out, bounds are those from all elements.
TEST_P(ExactBoxes, AreAsNarrowAsFromAllElements) {
    const int count = 300;
    const auto values = drawn_elements(draw_, count, 0.8 / std::cbrt(count));
    const auto by_place = FieldByPlace::of(field_, std::array{count});
    ASSERT_TRUE(by_place);
    const FieldByPlace::Frame frame = by_place->at(values, ball, 1);
    BoxesByPlace gradient(frame.programs().gradient, frame);
    const formula::EnclosurePrograms programs = formula::enclosure_programs(field_);
    formula::Evaluator<Interval> of_all(programs.gradient);
    const auto all = formula::convert<Interval>(values);
    for (int k = 0; k < 200; ++k) {
        const Point a = place(0.1);
        std::array<Interval, 3> box, told, expected;
        std::array<std::span<const Interval>, 3> from;
        std::array<std::span<Interval>, 3> to;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            box[axis] = Interval(a[axis], a[axis] + 0.01);
            from[axis] = {&box[axis], 1};
            to[axis] = {&told[axis], 1};
        }
        gradient.points(from, to);
        of_all.point(all, box, expected);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double slack = 1e-12 * (1 + magnitude(told[axis]));
            if (expected[axis] == Interval::entire()) continue;
            EXPECT_NEAR(told[axis].lo, expected[axis].lo, slack);
            EXPECT_NEAR(told[axis].hi, expected[axis].hi, slack);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Families, Boxes, testing::ValuesIn(families));
INSTANTIATE_TEST_SUITE_P(LeastFamilies, Boxes, testing::ValuesIn(least_families));

std::vector<Family> exact_families() {
    std::vector<Family> exact;
    for (const Family& family : families) {
        if (family.exact) exact.push_back(family);
    }
    return exact;
}
INSTANTIATE_TEST_SUITE_P(Families, ExactBoxes, testing::ValuesIn(exact_families()));

TEST(FieldByPlace, IsOfManyElementsOnly) {
    const auto field = formula::make_field(families[0].formula, family_vocabulary());
    EXPECT_FALSE(FieldByPlace::of(field, std::array{FieldByPlace::few}));
    EXPECT_TRUE(FieldByPlace::of(field, std::array{FieldByPlace::few + 1}));
    const auto plane = formula::make_field("z - sum(p, cx*cy)/100", family_vocabulary());
    EXPECT_FALSE(FieldByPlace::of(plane, std::array{1000})) << "no kernels";
}

TEST(BoxesByPlace, TellNothingOfWhatIsOutsideOrVeryLarge) {
    const auto field = formula::make_field(families[0].formula, family_vocabulary());
    std::mt19937 draw(1);
    const auto values = drawn_elements(draw, 20000, 0.03);
    const auto by_place = FieldByPlace::of(field, std::array{20000});
    ASSERT_TRUE(by_place);
    const FieldByPlace::Frame frame = by_place->at(values, ball, 2);
    BoxesByPlace value(frame.programs().value, frame);
    for (const Interval& side : {Interval(-1, 1), Interval(1.05, 1.2)}) {
        Interval told;
        const std::span<const Interval> from(&side, 1);
        value.points(std::array{from, from, from}, std::array{std::span(&told, 1)});
        EXPECT_EQ(told, Interval::entire());
    }
}

} // namespace
} // namespace isomotion::elements
