// Which fields are a sum and something else, and that the parts make up the field.
#include "formula/linear_sum.h"

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

constexpr const char* linear[] = {
    "sum(blobs, weight*exp(-((x - cx)^2 + (y - cy)^2 + (z - cz)^2))) - 1",
    "a - sum(blobs, 1/((x - cx)^2 + (y - cy)^2 + 0.01))",
    "x*y - 2*(z - sum(blobs, max(0, 1 - (x - cx)^2 - (y - cy)^2)^3)/(1 + z^2))",
    "-(sum(blobs, abs(z - cz)^1.5) - c)*exp(x)",
    "sum(blobs, b*sin(cx*x)) + sum(blobs, b*sin(cx*x)) - z", // one sum, twice
    "sum(blobs, cx)",
};

TEST(LinearSum, OthersAreNotTakenApart) {
    for (const char* text : {
             "x^2 + y^2 - 1",                                    // no sum
             "sum(blobs, cx*x)^2 - 1",                           // not linear
             "1/sum(blobs, cx^2 + x^2) - 1",                     //
             "exp(sum(blobs, cx*x))",                            //
             "max(sum(blobs, cx*x), y)",                         //
             "sum(blobs, sin(cx*x))/sum(blobs, exp(-cy*y)) - 1", // two sums
             "sum(blobs, cx*x) + sum(links, sin(px*x))",         // two arrays
             "sum(blobs, sum(links, sin(px*x + cx)))",           // one in another
         }) {
        EXPECT_FALSE(linear_sum(field_of(text)).has_value()) << text;
    }
}

// The program as the body of a loop over the elements: what is left is of the last.
Program of_last_element(const Program& term) {
    Program looped = term;
    Instruction begin, end;
    begin.kind = Instruction::Kind::loop_begin;
    begin.index = LinearSum::array;
    end.kind = Instruction::Kind::loop_end;
    looped.instructions.insert(looped.instructions.begin(), begin);
    looped.instructions.push_back(end);
    return looped;
}

// Element `e` by itself.
Bindings<Interval> only(const Bindings<double>& bindings, std::size_t e) {
    Bindings<double> one = bindings;
    one.arrays[LinearSum::array].count = 1;
    for (auto& field : one.arrays[LinearSum::array].fields) field = {field[e]};
    return convert<Interval>(one);
}

// At points: rest and factor times the terms of all elements meet the field.
TEST(LinearSum, ThePartsMakeUpTheField) {
    constexpr std::uint64_t seed = 20260712;
    Random random(seed);
    for (const int elements : {0, 1, 5}) {
        const Bindings<double> bindings = blobs_alone(elements);
        for (const char* text : linear) {
            const Field field = field_of(text);
            const auto sum = linear_sum(field);
            ASSERT_TRUE(sum.has_value()) << text;
            const Program term = of_last_element(sum->term);
            const EnclosurePrograms programs = enclosure_programs(field);
            for (int k = 0; k < 200; ++k) {
                SCOPED_TRACE(fmt::format("{}, {} elements, seed {}, {}", text, elements, seed, k));
                const Point p = random.point(3);
                const std::array<Interval, 3> at{p[0], p[1], p[2]};
                Interval whole, total(0.0);
                Evaluator<Interval>(programs.value)
                    .point(convert<Interval>(bindings), at, {&whole, 1});
                for (int e = 0; e < elements; ++e) {
                    Interval of_one;
                    Evaluator<Interval>(term).point(only(bindings, std::size_t(e)), at,
                                                    {&of_one, 1});
                    total = total + of_one;
                }
                std::array<Interval, 2> parts;
                Evaluator<Interval>(sum->rest_and_factor)
                    .point(convert<Interval>(bindings), at, parts);
                const Interval made = parts[1] * total + parts[0];
                EXPECT_FALSE(is_empty(intersect(whole, made)))
                    << whole.lo << " " << whole.hi << ", made " << made.lo << " " << made.hi;
                EXPECT_LE(width(made), 1e-9 * (1 + magnitude(whole) + magnitude(parts[0])));
            }
        }
    }
}

} // namespace
} // namespace isomotion::formula
