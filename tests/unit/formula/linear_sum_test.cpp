// Which sums a field is taken apart into, and that their terms add up to them.
#include "formula/sums.h"

#include <fmt/format.h>

#include "formula/enclosure.h"
#include "testing.h"

namespace isomotion::formula {
namespace {

Vocabulary of_blobs_alone() {
    Vocabulary vocabulary = test_vocabulary();
    vocabulary.arrays.resize(1);
    return vocabulary;
}

Bindings<double> blobs_alone(int count) {
    Bindings<double> bindings = test_bindings(count);
    bindings.arrays.resize(1);
    return bindings;
}

Field field_of(std::string_view text) {
    const bool links = text.find("links") != text.npos;
    return make_field(text, links ? test_vocabulary() : of_blobs_alone());
}

int count_of(std::string_view text) {
    const auto sums = sums_of(field_of(text));
    return sums ? sums->count : 0;
}

TEST(SumsOfField, OneArraySummedUpToFourTimes) {
    EXPECT_EQ(count_of("sum(blobs, weight*exp(-(x - cx)^2)) - 1"), 1);
    EXPECT_EQ(count_of("x - sum(blobs, cx*x)^2"), 1);
    EXPECT_EQ(count_of("sum(blobs, 1/((x - cx)^2 + 1))/sum(blobs, exp(-(y - cy)^2)) - z"), 2);
    EXPECT_EQ(count_of("sum(blobs, sin(cx*x)) + sum(blobs, sin(cy*y))^2 + sum(blobs, sin(cz*z))^3 "
                       "+ sum(blobs, sin(r*x*y))^4"),
              4);
}

// The same sum twice is one, and what doesn't depend on the element leaves it.
TEST(SumsOfField, AreCountedOnce) {
    EXPECT_EQ(count_of("sum(blobs, exp(-cx*x))*y + sin(sum(blobs, exp(-cx*x)))"), 1);
    EXPECT_EQ(count_of("sum(blobs, a*exp(-cx*x))*y + sum(blobs, -z*exp(-cx*x))"), 1);
}

TEST(SumsOfField, OthersAreNotTakenApart) {
    for (const char* text : {
             "x^2 + y^2 - 1",                                    // none
             "sum(blobs, cx*x) + sum(links, sin(px*x))",         // two arrays
             "sum(blobs, sum(links, sin(px*x + cx)))",           // one in another
             "sum(blobs, exp(-weight*x*sum(links, sin(px*y))))", // no constant factor
             "sum(blobs, sin(cx*x)) + sum(blobs, sin(cy*y))^2 + sum(blobs, sin(cz*z))^3 + "
             "sum(blobs, sin(r*x))^4 + sum(blobs, sin(s*x))^5", // five
         }) {
        EXPECT_FALSE(sums_of(field_of(text)).has_value()) << text;
    }
}

// Fields whose terms are bounded apart: with poles, kinks, compact support, signs and parameters.
constexpr const char* summed[] = {
    "sum(blobs, weight*exp(-((x - cx)^2 + (y - cy)^2 + (z - cz)^2))) - 1",
    "sum(blobs, 1/((x - cx)^2 + (y - cy)^2 + 0.01)) - a*sum(blobs, abs(z - cz)^1.5)",
    "sum(blobs, max(0, 1 - (x - cx)^2 - (y - cy)^2)^3) - 0.1",
    "x*sum(blobs, -a*sin(b*x + cx)) + sum(blobs, min(y, cy)/(1 + z^2))^2",
    "sum(blobs, weight*chebyshev(7, x/4 + cx/4))/(1 + sum(blobs, (r*z)^2)) - c",
    "sum(blobs, cx)*x - sum(blobs, cy)",
};

// Element `e` by itself.
Bindings<Interval> only(const Bindings<double>& bindings, std::size_t e) {
    Bindings<double> one = bindings;
    one.arrays[Sums::array].count = 1;
    for (auto& field : one.arrays[Sums::array].fields) field = {field[e]};
    return convert<Interval>(one);
}

// The program as the body of a loop over the elements: what is left is of the last.
Program of_last_element(const Program& terms) {
    Program looped = terms;
    Instruction begin, end;
    begin.kind = Instruction::Kind::loop_begin;
    begin.index = Sums::array;
    end.kind = Instruction::Kind::loop_end;
    looped.instructions.insert(looped.instructions.begin(), begin);
    looped.instructions.push_back(end);
    return looped;
}

// In any box: what single elements add makes up the bounds of the sums, and these hold the sums in
// double.
TEST(SumsOfField, TermsOfAllElementsAddUpToThem) {
    constexpr std::uint64_t seed = 20260712;
    constexpr int elements = 5;
    Random random(seed);
    const Bindings<double> bindings = blobs_alone(elements);
    for (const char* text : summed) {
        const Field field = field_of(text);
        const Sums sums = sums_of(field).value();
        const auto count = std::size_t(sums.count);
        const Program term = of_last_element(sums.terms);
        for (int k = 0; k < 200; ++k) {
            SCOPED_TRACE(fmt::format("{}, seed {}, box {}", text, seed, k));
            const Point p = random.point(k < 20 ? 0.01 : 3);
            const double reach = k % 3 == 0 ? 0 : random.in(0, 0.5);
            std::array<Interval, 3> box, middle;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                box[axis] = {p[axis] - reach, p[axis] + reach};
                middle[axis] = p[axis];
            }
            std::vector<Interval> whole(1 + count), at_point(1 + count), term_of(count);
            Evaluator<Interval>(sums.with_field).point(convert<Interval>(bindings), box, whole);
            Evaluator<Interval>(sums.with_field)
                .point(convert<Interval>(bindings), middle, at_point);
            std::vector<Interval> total(count, Interval(0.0)), points(count, Interval(0.0));
            for (std::size_t e = 0; e < elements; ++e) {
                Evaluator<Interval>(term).point(only(bindings, e), box, term_of);
                for (std::size_t s = 0; s < count; ++s) total[s] = total[s] + term_of[s];
                Evaluator<Interval>(term).point(only(bindings, e), middle, term_of);
                for (std::size_t s = 0; s < count; ++s) points[s] = points[s] + term_of[s];
            }
            EXPECT_TRUE(contains(whole[0], run(field.value, p, bindings)));
            for (std::size_t s = 0; s < count; ++s) {
                EXPECT_EQ(total[s], whole[s + 1]) << "sum " << s;
                EXPECT_TRUE(contains(total[s], points[s])) << "sum " << s;
                EXPECT_EQ(points[s], at_point[s + 1]) << "sum " << s;
                // Points are bounded by little more than their rounding.
                EXPECT_LE(width(points[s]), 1e-11 * (1 + magnitude(points[s]))) << "sum " << s;
            }
        }
    }
}

// Sums of no element and of one.
TEST(SumsOfField, OfFewElements) {
    for (const char* text : summed) {
        const Field field = field_of(text);
        const Sums sums = sums_of(field).value();
        const std::array<Interval, 3> box{Interval(0.5), Interval(-0.25), Interval(0.125)};
        std::vector<Interval> none(std::size_t(1 + sums.count)), one(none.size());
        std::vector<Interval> term(std::size_t(sums.count));
        Evaluator<Interval>(sums.with_field).point(convert<Interval>(blobs_alone(0)), box, none);
        Evaluator<Interval>(sums.with_field).point(only(blobs_alone(3), 1), box, one);
        Evaluator<Interval>(of_last_element(sums.terms)).point(only(blobs_alone(3), 1), box, term);
        for (std::size_t s = 0; s < term.size(); ++s) {
            EXPECT_EQ(none[s + 1], Interval(0.0)) << text;
            EXPECT_TRUE(contains(one[s + 1], term[s])) << text;
        }
    }
}

// What is asked beside F changes nothing of F.
TEST(SumsOfField, TheFieldBesideThemIsTheField) {
    constexpr std::uint64_t seed = 41;
    Random random(seed);
    const auto intervals = convert<Interval>(blobs_alone(7));
    for (const char* text : summed) {
        const Field field = field_of(text);
        const Sums sums = *sums_of(field);
        const EnclosurePrograms programs = enclosure_programs(field);
        for (int k = 0; k < 100; ++k) {
            const Point p = random.point(2);
            const std::array<Interval, 3> box{Interval(p[0], p[0] + 0.1), Interval(p[1]),
                                              Interval(p[2] - 0.2, p[2])};
            std::vector<Interval> beside(std::size_t(1 + sums.count));
            Interval alone;
            Evaluator<Interval>(sums.with_field).point(intervals, box, beside);
            Evaluator<Interval>(programs.value).point(intervals, box, {&alone, 1});
            EXPECT_EQ(beside[0], alone) << text << ", seed " << seed << ", point " << k;
        }
    }
}

} // namespace
} // namespace isomotion::formula
