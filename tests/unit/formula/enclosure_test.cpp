// Formulas on intervals against the same formulas on MPFR numbers.
#include "formula/enclosure.h"

#include <list>
#include <optional>

#include <fmt/format.h>

#include "catalogue.h"
#include "exact.h"
#include "formula/graph/derivative.h"
#include "formula/graph/operations.h"

namespace isomotion::formula::enclosure_test {
namespace {

using Box = std::array<Interval, 6>;
using ExactPoint = std::array<Exact, 6>;

// Evaluates a graph by recursion.
class ExactGraph {
public:
    ExactGraph(const Graph& graph, const Bindings<double>& bindings)
        : graph_(graph)
        , bindings_(bindings)
        , known_(graph.size())
        , element_(bindings.arrays.size()) {}

    Exact value(NodeId root, const ExactPoint& inputs) {
        inputs_ = &inputs;
        known_.assign(graph_.size(), std::nullopt);
        return value(root);
    }

private:
    Exact value(NodeId id) {
        auto& known = known_[id];
        if (!known) known = compute(graph_[id]);
        return *known;
    }

    Exact compute(const Node& node) {
        const auto index = std::size_t(node.index);
        const auto child = [&](std::size_t k) { return value(node.children[k]); };
        switch (node.op) {
        case Op::constant:
            return node.value;
        case Op::input:
            return (*inputs_)[index];
        case Op::parameter:
            return bindings_.parameters[index];
        case Op::element:
            return bindings_.arrays[index].fields[std::size_t(node.second)][element_[index]];
        case Op::sum: {
            Exact total = 0;
            element_[index] = 0;
            for (; element_[index] < std::size_t(bindings_.arrays[index].count);
                 ++element_[index]) {
                for (NodeId id = 0; id < graph_.size(); ++id)
                    if (graph_[id].arrays & 1u << node.index) known_[id].reset();
                total = total + child(0);
            }
            return total;
        }
        case Op::least:
        case Op::pick: {
            Exact least(double(Operations<float>::least_of_none()));
            Exact picked = node.op == Op::least ? least : Exact(0);
            element_[index] = 0;
            for (; element_[index] < std::size_t(bindings_.arrays[index].count);
                 ++element_[index]) {
                for (NodeId id = 0; id < graph_.size(); ++id)
                    if (graph_[id].arrays & 1u << node.index) known_[id].reset();
                if (!(child(0) < least)) continue;
                least = child(0);
                picked = child(std::size_t(node.arity - 1));
            }
            return picked;
        }
        case Op::chebyshev:
            return chebyshev(node.index, node.second, child(0));
        case Op::select:
            return child(0) < child(1) ? child(2) : child(3);
        default:
            return node.arity == 1 ? apply(node.op, child(0)) : apply(node.op, child(0), child(1));
        }
    }

    const Graph& graph_;
    const Bindings<double>& bindings_;
    const ExactPoint* inputs_ = nullptr;
    std::vector<std::optional<Exact>> known_;
    std::vector<std::size_t> element_;
};

// A field on intervals, and its value and derivatives on MPFR numbers.
class Subject {
public:
    Subject(const Field& field, Bindings<double> bindings, Slopes slopes = Slopes::pointwise)
        : bindings_(std::move(bindings))
        , intervals_(convert<Interval>(bindings_))
        , programs_(enclosure_programs(field))
        , value_(programs_.value)
        , along_(programs_.directional)
        , gradient_(programs_.gradient)
        , graph_(field.graph) {
        const NodeId one = graph_.constant(1), zero = graph_.constant(0);
        const auto slope = [&](const std::vector<NodeId>& directions) {
            return differentiate_inputs(graph_, field.root, directions, slopes);
        };
        roots_ = {field.root, slope({graph_.input(3), graph_.input(4), graph_.input(5)}),
                  slope({one, zero, zero}), slope({zero, one, zero}), slope({zero, zero, one})};
    }

    Subject(const Subject&) = delete; // the evaluators know where the programs are
    Subject& operator=(const Subject&) = delete;

    // F, dF/dt and the gradient.
    std::array<Interval, 5> enclose(const Box& box) {
        std::array<Interval, 5> result;
        Interval value;
        const std::span<const Interval> point = std::span(box).first(3);
        value_.point(intervals_, point, {&value, 1});
        along_.point(intervals_, box, std::span(result).first(2));
        gradient_.point(intervals_, point, std::span(result).last(3));
        EXPECT_EQ(value, result[0]);
        return result;
    }

    std::array<Exact, 5> exact(const ExactPoint& p) {
        ExactGraph evaluate(graph_, bindings_);
        std::array<Exact, 5> result;
        for (std::size_t k = 0; k < 5; ++k) result[k] = evaluate.value(roots_[k], p);
        return result;
    }

    const EnclosurePrograms& programs() const { return programs_; }
    const Bindings<Interval>& intervals() const { return intervals_; }

private:
    Bindings<double> bindings_;
    Bindings<Interval> intervals_;
    EnclosurePrograms programs_;
    Evaluator<Interval> value_, along_, gradient_;
    Graph graph_;
    std::array<NodeId, 5> roots_;
};

Subject subject(std::string_view text) {
    return {make_field(text, test_vocabulary()), test_bindings(), Slopes::generalized};
}

bool is_proper(Interval a) { return a.lo <= a.hi && a.lo < infinity && a.hi > -infinity; }

// Boxes of all sizes, now and then a point or with a coordinate of 0.
Box random_box(Random& random, double reach) {
    Box box;
    const double size = random.below(8) == 0 ? 0 : reach * std::exp2(random.in(-40, 1));
    for (std::size_t k = 0; k < 6; ++k) {
        const double scale = k < 3 ? reach : 1;
        const double x = random.below(8) == 0 ? 0 : random.in(-scale, scale);
        box[k] = {x, x + random.in(0, 1) * size};
    }
    return box;
}

ExactPoint random_point(Random& random, const Box& box) {
    ExactPoint p;
    for (std::size_t k = 0; k < 6; ++k) {
        const double part = random.below(4) == 0 ? random.below(2) : random.in(0, 1);
        const double x = box[k].lo + part * (box[k].hi - box[k].lo);
        p[k] = std::clamp(x, box[k].lo, box[k].hi);
    }
    return p;
}

std::string describe(const Box& box) {
    std::string text;
    for (const Interval x : box) text += fmt::format("[{:a}, {:a}] ", x.lo, x.hi);
    return text;
}

void expect_enclosed(Subject& field, double reach, std::uint64_t seed, int boxes) {
    Random random(seed);
    for (int trial = 0; trial < boxes; ++trial) {
        const Box box = random_box(random, reach);
        const auto enclosed = field.enclose(box);
        for (int k = 0; k < 3; ++k) {
            const auto values = field.exact(random_point(random, box));
            for (std::size_t o = 0; o < 5; ++o) {
                ASSERT_TRUE(is_proper(enclosed[o])) << "seed " << seed << ' ' << describe(box);
                if (values[o].is_undefined()) continue; // on a kink
                ASSERT_TRUE(holds(enclosed[o], values[o]))
                    << "seed " << seed << ": output " << o << " over " << describe(box) << ": "
                    << testing::PrintToString(enclosed[o]) << " lacks " << values[o];
            }
        }
    }
}

TEST(Enclosure, HoldsTheCatalogue) {
    for (const CatalogueSurface& surface : catalogue()) {
        SCOPED_TRACE(surface.name);
        const CatalogueField made(surface);
        Subject field(made.field, made.bindings);
        expect_enclosed(field, surface.reach, 90, 40);
    }
}

// What has bounds itself hides that its argument has no value.
TEST(Enclosure, IsTheEntireLineWhereThereIsNoValue) {
    const Interval one = 1.0;
    struct Gap {
        const char* formula;
        Interval x, y;
        bool has_values;
    };
    for (const Gap& gap :
         {Gap{"sin(log(x))", {-2, -1}, one, false}, Gap{"sin(log(x))", {-1, 1}, one, false},
          Gap{"sin(log(x))", {1, 2}, one, true}, Gap{"atan(x^0.3)", {-2, -1}, one, false},
          Gap{"atan(x^0.3)", {1, 2}, one, true}, Gap{"atan(x/y)", {-1, 1}, {-1, 1}, false},
          Gap{"atan(x/y)", {1, 2}, {1, 2}, true}, Gap{"atan(x/(b + 0.75))", {-1, 1}, one, false},
          Gap{"min(x, 3 + sin(log(x)))", {-1, 1}, one, false},
          Gap{"x*sign(2 + sin(log(x)))", {-1, 1}, one, false},
          Gap{"x + sqrt(-1 - abs(log(x)))", {-1, 1}, one, false},
          Gap{"sum(blobs, sin(log(x + 0*cx)))", {-2, -1}, one, false}}) {
        Subject field = subject(gap.formula);
        // The value, the slope along a direction and the gradient.
        for (const Interval bounds : field.enclose({gap.x, gap.y, one, one, one, one})) {
            EXPECT_EQ(bounds != Interval::entire(), gap.has_values)
                << gap.formula << " over " << testing::PrintToString(gap.x);
        }
    }
}

// The slope of x/3 is a third, which no double is.
TEST(Enclosure, HoldsSlopesThatAreNoDoubles) {
    const Exact third = Exact(1) / Exact(3), tenth = Exact(0.1) - Exact(1);
    EXPECT_TRUE(holds(subject("x/3").enclose(Box{})[2], third));
    Subject power = subject("x^0.1"); // 0.1 x^(0.1 - 1), and 0.1 - 1 is none
    const Interval x = 1e100;
    EXPECT_TRUE(holds(power.enclose({x, x, x, x, x, x})[2],
                      Exact(0.1) * apply(Op::power, Exact(1e100), tenth)));
}

constexpr std::array kinked{
    "floor(3*x) + x/2 - y",
    "sign(x*y - z) + z",
    "floor(sin(9*x)*2)*y - sign(z)",
    "sqrt(x^2 + y^2 - 1/4) - z",
    "sqrt(1 - x^2 - y^2 - z^2) + x",
    "asin(2*x) - acos(y*z*3) + y",
    "min(x, y, z) + max(x^2, y)",
    "abs(x)^0.5 + abs(y)^1.5 - abs(z - x)",
    "abs(abs(abs(x) - 1/2) - y)*z",
    "min(1, max(0, 3*x - y))^3",
    "sum(blobs, sqrt((x-cx)^2 + (y-cy)^2)) + sum(links, floor(px*x))",
    "least(blobs, (x-cx)^2 + (y-3*cy)^2) - z*greatest(links, px*x - y)",
    "min(greatest(blobs, abs(x - cx)*cy), sum(links, least(blobs, px*cx*z)))",
    "chebyshev(5, x)*chebyshev(3, y) + chebyshev(30, z)",
    "exp(-x^2)*y/(2 + sin(z)) + tanh(x*z) - log(2 + y)",
    "(x^2)^0.3 + 2^y - (2 + x)^y",
    "u = max(1, abs(x)); cos(6*acos(min(1, abs(x))))*cosh(6*log(u + sqrt(u*u - 1))) - y",
    "u = max(1, abs(y)); cos(5*acos(y))*cosh(5*log(u + sqrt(u*u - 1))) - cos(9*acos(x - 1/8))*z",
    "cosh(x)*sinh(y) - tan(z/2) + atan(5*x)",
    "atan2(y, x) + z",
    "atan2(x - 1/8, y + z)*atan2(z, x)",
    "cos(3*atan2(y, x))*sqrt(x^2 + y^2) - z",
    "sin(2*atan2(y, x) - z)*tan(atan2(z, y)/2)"};

// Divided differences of any two points, not only derivatives: across kinks and jumps too.
TEST(Enclosure, HoldsDividedDifferences) {
    constexpr std::uint64_t seed = 91;
    for (const auto* text : kinked) {
        SCOPED_TRACE(testing::Message() << text << ", seed " << seed);
        Subject field = subject(text);
        Random random(seed);
        for (int trial = 0; trial < 200; ++trial) {
            const double length = std::exp2(random.in(-12, 1));
            const Point p = random.point(1), d = random.point(1);
            Box box;
            for (std::size_t k = 0; k < 3; ++k) {
                const Interval way = Interval(0, length) * Interval(d[k]);
                box[k] = Interval(p[k]) + way;
                box[k + 3] = d[k];
            }
            const Interval slope = field.enclose(box)[1];
            const auto at = [&](double t) {
                ExactPoint q;
                for (std::size_t k = 0; k < 3; ++k) q[k] = Exact(p[k]) + Exact(t) * Exact(d[k]);
                return field.exact(q)[0];
            };
            for (int k = 0; k < 4; ++k) {
                const double s = k == 0 ? 0 : random.in(0, length);
                const double t = k == 0 ? length : random.in(0, length);
                const Exact quotient = (at(s) - at(t)) / (Exact(s) - Exact(t));
                ASSERT_TRUE(holds(slope, quotient)) << testing::PrintToString(slope) << " lacks "
                                                    << quotient << " over " << describe(box);
            }
        }
    }
}

TEST(Enclosure, HoldsKinkedFormulas) {
    for (const auto* text : kinked) {
        SCOPED_TRACE(text);
        Subject field = subject(text);
        expect_enclosed(field, 1.5, 92, 100);
    }
}

// Half spaces, all of space, the faces at infinity, and sums over nothing.
TEST(Enclosure, HasNoNan) {
    const Interval all = Interval::entire();
    std::list<Subject> fields;
    for (const CatalogueSurface& surface : catalogue()) {
        CatalogueField made(surface);
        fields.emplace_back(made.field, made.bindings);
        for (auto& array : made.bindings.arrays) array = {0, {{}, {}, {}}};
        fields.emplace_back(made.field, made.bindings);
    }
    for (const auto* text : kinked) {
        for (const int blobs : {0, 3})
            fields.emplace_back(make_field(text, test_vocabulary()), test_bindings(blobs));
    }
    const std::vector<Interval> ends{all,
                                     {0, infinity},
                                     {-infinity, 0},
                                     {1, infinity},
                                     {1e300, infinity},
                                     {-infinity, -1e308},
                                     {-1e200, 1e200},
                                     0.0,
                                     1e308,
                                     {0, smallest_positive},
                                     {-1, 1}};
    constexpr std::uint64_t seed = 93;
    Random random(seed);
    for (Subject& field : fields) {
        for (int trial = 0; trial < 300; ++trial) {
            Box box;
            for (Interval& side : box) side = ends[std::size_t(random.below(int(ends.size())))];
            for (const Interval result : field.enclose(box))
                ASSERT_TRUE(is_proper(result)) << "seed " << seed << ' ' << describe(box);
        }
    }
}

TEST(Enclosure, KeepsChebyshevWhole) {
    Subject field = subject("chebyshev(50,x) + chebyshev(50,y) + chebyshev(50,z)");
    for (const Program* program :
         {&field.programs().value, &field.programs().directional, &field.programs().gradient}) {
        int whole = 0;
        for (const Instruction& now : program->instructions) whole += now.op == Op::chebyshev;
        EXPECT_GE(whole, 3);
    }
    const Interval unit{-1, 1};
    const Interval value = field.enclose({unit, unit, unit, 1.0, 0.0, 0.0})[0];
    EXPECT_NEAR(value.lo, -3, 1e-14);
    EXPECT_NEAR(value.hi, 3, 1e-14);
}

TEST(Enclosure, SquaresAreNotNegative) {
    Subject field = subject("x^2 + y^4 + (x*y)^6");
    const Interval value = field.enclose({{{-1, 2}, {-2, 1}, 0.0, 0.0, 0.0, 0.0}})[0];
    EXPECT_EQ(value.lo, 0);
    EXPECT_NEAR(value.hi, 4 + 16 + 4096, 1e-10);
}

// Values are as wide as the box, times something that doesn't depend on it.
TEST(Enclosure, ShrinksWithTheBox) {
    constexpr std::uint64_t seed = 94;
    for (const CatalogueSurface& surface : catalogue()) {
        SCOPED_TRACE(testing::Message() << surface.name << ", seed " << seed);
        const CatalogueField made(surface);
        Subject field(made.field, made.bindings);
        Random random(seed);
        for (int trial = 0; trial < 10; ++trial) {
            const Point p = random.point(surface.reach);
            const auto value = [&](double size) {
                Box box{};
                for (std::size_t k = 0; k < 3; ++k) box[k] = {p[k], p[k] + size};
                return field.enclose(box)[0];
            };
            const double rounding = width(value(0));
            EXPECT_LT(rounding, 1e-10 * (1 + magnitude(value(0))));
            EXPECT_LE(width(value(1e-9)), 2e-3 * width(value(1e-6)) + 2 * rounding);
        }
    }
}

TEST(Enclosure, FloatBindingsBecomePoints) {
    Bindings<float> bindings;
    bindings.parameters = {0.1F, std::numeric_limits<float>::infinity()};
    bindings.arrays = {{1, {{0.3F}}}};
    bindings.seed = 5;
    const auto intervals = convert<Interval>(bindings);
    EXPECT_EQ(intervals.parameters[0], Interval(double(0.1F)));
    EXPECT_EQ(intervals.parameters[1], Interval(largest_finite, infinity));
    EXPECT_EQ(intervals.arrays[0].fields[0][0], Interval(double(0.3F)));
    EXPECT_EQ(intervals.seed, 5u);
}

TEST(Enclosure, RandomNumbersOfPoints) {
    Graph g;
    const NodeId root = g.binary(Op::random, g.input(0), g.constant(3));
    const Program program = schedule(g, std::array{root});
    Evaluator<Interval> evaluator(program);
    Bindings<Interval> bindings;
    bindings.seed = 8;
    Interval result;
    evaluator.point(bindings, std::array{Interval(2.0)}, {&result, 1});
    EXPECT_EQ(result, Interval(random_unit(8, 2, 3)));
    evaluator.point(bindings, std::array{Interval(2, 3)}, {&result, 1});
    EXPECT_EQ(result, Interval(0, 1));
}

TEST(Enclosure, BlocksGiveWhatSinglePointsGive) {
    constexpr std::uint64_t seed = 95;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    for (const auto* text : kinked) {
        SCOPED_TRACE(text);
        const Subject field = subject(text);
        Evaluator<Interval> evaluator(field.programs().directional);
        for (const std::size_t size : {1, 31, 32, 33, 70}) {
            Random random(seed);
            std::vector<Box> boxes;
            std::array<std::vector<Interval>, 6> columns;
            for (std::size_t i = 0; i < size; ++i) {
                boxes.push_back(random_box(random, 1.5));
                for (std::size_t k = 0; k < 6; ++k) columns[k].push_back(boxes.back()[k]);
            }
            const std::array<std::span<const Interval>, 6> inputs{
                columns[0], columns[1], columns[2], columns[3], columns[4], columns[5]};
            std::array<std::vector<Interval>, 2> results;
            for (auto& result : results) result.assign(size + 1, Interval(-123.0));
            const std::array<std::span<Interval>, 2> outputs{std::span(results[0]).first(size),
                                                             std::span(results[1]).first(size)};
            evaluator.points(field.intervals(), inputs, outputs);
            for (std::size_t i = 0; i < size; ++i) {
                std::array<Interval, 2> single;
                evaluator.point(field.intervals(), boxes[i], single);
                for (std::size_t o = 0; o < 2; ++o) EXPECT_EQ(results[o][i], single[o]) << i;
            }
            EXPECT_EQ(results[0][size], Interval(-123.0));
            EXPECT_EQ(results[1][size], Interval(-123.0));
        }
    }
}

// A copy shares what was derived; a field of other values has its own.
TEST(EnclosurePrograms, AreDerivedOnce) {
    const Field field = make_field("floor(x) + y^2", {});
    const Field copy = field;
    EXPECT_EQ(&enclosure_programs(field), &enclosure_programs(copy));
    EXPECT_EQ(&value_enclosure(field), &value_enclosure(copy));
    const Field twice = scaled(field, 2);
    const Field walls = with_walls(field, 0.1);
    const auto value_at_a_place = [](const Field& of) {
        Interval value;
        const std::array<Interval, 3> place{1, 1, 0};
        Evaluator<Interval>(value_enclosure(of)).point({}, place, {&value, 1});
        return value;
    };
    EXPECT_EQ(value_at_a_place(field), Interval(2));
    EXPECT_EQ(value_at_a_place(twice), Interval(4));
    // A jump of F across 0 is a root only where jumps are walls.
    const auto may_jump = [](const Field& of) {
        const std::array<Interval, 3> about{Interval(0.5, 1.5), 0, 0};
        std::array<Interval, 2> jump;
        Evaluator<Interval>(enclosure_programs(of).jumps).point({}, about, jump);
        return jump[0] != Interval(0);
    };
    EXPECT_TRUE(may_jump(field));
    EXPECT_FALSE(may_jump(walls));
}

// F, dF/dt and the gradient of dF/dt, against what is worked out by hand of x^3 y + 2 y z - z^2.
TEST(HessianProgram, OfAPolynomialIsItsSecondDerivatives) {
    const Field field = make_field("x^3*y + 2*y*z - z^2", test_vocabulary());
    const auto& program = hessian_program(field);
    ASSERT_TRUE(program);
    Evaluator<Interval> evaluator(*program);
    const Bindings<Interval> bindings = convert<Interval>(test_bindings());
    Random random(1);
    for (int again = 0; again < 100; ++again) {
        Box box = random_box(random, 1.5);
        const auto exact = [&](auto&& of) {
            return of(mid(box[0]), mid(box[1]), mid(box[2]), mid(box[3]), mid(box[4]), mid(box[5]));
        };
        const std::array expected{
            exact([](double x, double y, double z, double, double, double) {
                return x * x * x * y + 2 * y * z - z * z;
            }),
            exact([](double x, double y, double z, double u, double v, double w) {
                return 3 * x * x * y * u + (x * x * x + 2 * z) * v + (2 * y - 2 * z) * w;
            }),
            exact([](double x, double y, double, double u, double v, double) {
                return 6 * x * y * u + 3 * x * x * v;
            }),
            exact([](double x, double, double, double u, double, double w) {
                return 3 * x * x * u + 2 * w;
            }),
            exact(
                [](double, double, double, double, double v, double w) { return 2 * v - 2 * w; })};
        std::array<Interval, 5> found;
        evaluator.point(bindings, box, found);
        for (std::size_t k = 0; k < found.size(); ++k) {
            EXPECT_LE(found[k].lo, expected[k] + 1e-13) << k;
            EXPECT_GE(found[k].hi, expected[k] - 1e-13) << k;
        }
        for (Interval& side : box) side = Interval(mid(side));
        evaluator.point(bindings, box, found);
        for (std::size_t k = 0; k < found.size(); ++k) {
            EXPECT_NEAR(found[k].lo, expected[k], 1e-12) << k;
            EXPECT_NEAR(found[k].hi, expected[k], 1e-12) << k;
        }
    }
}

TEST(HessianProgram, IsOfNoOtherField) {
    for (const char* text : {"exp(x) + y", "1/x + y^2 + z", "sqrt(x) + y", "abs(x) + z^2"}) {
        const Field field = make_field(text, test_vocabulary());
        EXPECT_FALSE(hessian_program(field)) << text;
    }
}

} // namespace
} // namespace isomotion::formula::enclosure_test
