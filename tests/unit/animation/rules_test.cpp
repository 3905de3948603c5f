// Rules of motion are the values of the animation, as expressions.
#include "animation/rules.h"

#include <random>

#include <gtest/gtest.h>

#include "formula/graph/program.h"
#include "formula/graph/substitute.h"

namespace isomotion::animation {
namespace {

using formula::Graph;
using formula::NodeId;

double value(const Graph& graph, NodeId node, double time) {
    const formula::Program program = formula::schedule(graph, std::array{node});
    double result = 0;
    formula::Evaluator<double>(program).point({}, {&time, 1}, {&result, 1});
    return result;
}

Keys keys(Ease ease) { return {{{0, 2}, {1, -1}, {1.5, 4}, {4, 0}}, ease}; }

TEST(Rules, OfTracksAreTheirValues) {
    const std::vector<Track> tracks{{"a", 2.0},
                                    {"l", keys(Ease::linear)},
                                    {"s", keys(Ease::smooth)},
                                    {"h", keys(Ease::hold)},
                                    {"c", keys(Ease::cubic)},
                                    {"e", Expression{"a*sin(t) + c^2 - l"}}};
    const Animation animation(tracks, {});
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(-1, 5);
    for (int k = 0; k < 200; ++k) {
        const double t = unit(random);
        Graph graph;
        Rules rules(animation, t, graph, graph.input(0));
        for (int track = 0; track < int(tracks.size()); ++track) {
            EXPECT_NEAR(value(graph, rules.track(track), t),
                        animation.at(t).tracks[std::size_t(track)], 1e-13)
                << tracks[std::size_t(track)].name << " at " << t;
        }
    }
}

TEST(Rules, OfAReferredTrackMayBeAnother) {
    const Animation animation({{"p", Expression{"sin(t)"}}, {"q", Expression{"3*p + 1"}}}, {});
    Graph graph;
    Rules rules(animation, 0, graph, graph.input(1), Driver{0, graph.input(0)});
    EXPECT_DOUBLE_EQ(value(graph, rules.track(1), 0.25), 1.75);
}

// The sums of the first two fields, by rules and as they are.
void expect_rules_of_drops(const Animation& animation, std::initializer_list<double> times) {
    for (const double t : times) {
        Graph graph;
        Rules rules(animation, t, graph, graph.input(0));
        const NodeId x = graph.sum(0, rules.field(0, 0)), y = graph.sum(0, rules.field(0, 1));
        formula::Bindings<double> bindings;
        bindings.arrays = rules.columns();
        const formula::Program program = formula::schedule(graph, std::array{x, y});
        std::array<double, 2> sums{};
        formula::Evaluator<double>(program).point(bindings, {&t, 1}, sums);
        double sum_x = 0, sum_y = 0;
        const Values values = animation.at(t);
        for (const double v : values.arrays[0].fields[0]) sum_x += v;
        for (const double v : values.arrays[0].fields[1]) sum_y += v;
        EXPECT_NEAR(sums[0], sum_x, 1e-12) << t;
        EXPECT_NEAR(sums[1], sum_y, 1e-12) << t;
    }
}

TEST(Rules, OfSamplesAreStraightBetweenThem) {
    // Two elements, of which the second ends at the second sample.
    ElementSamples::Rows rows;
    rows.times = {0, 1, 3};
    rows.begin = {0, 2, 3, 4};
    rows.values = {{0, 10, 4, 7}};
    rows.ids = {5, 6, 5, 5};
    const auto samples =
        std::make_shared<const ElementSamples>(rows, ElementSamples::Interpolation::linear);
    const Animation animation(
        {}, {{"drops", 2, {{"x", Column{0}}, {"y", Expression{"2*x + i"}}}, samples}});
    expect_rules_of_drops(animation, {0.0, 0.25, 0.75, 1.0, 1.5, 2.999, 3.5});
}

TEST(Rules, OfSamplesWithVelocitiesAreCubics) {
    ElementSamples::Rows rows;
    rows.times = {0, 1, 3};
    rows.begin = {0, 2, 3, 4};
    rows.values = {{0, 10, 4, 7}, {1, -2, 5, 0.5}};
    rows.ids = {5, 6, 5, 5};
    rows.velocities = {1, std::nullopt};
    const auto samples =
        std::make_shared<const ElementSamples>(rows, ElementSamples::Interpolation::hermite);
    const Animation animation(
        {}, {{"drops", 2, {{"x", Column{0}}, {"y", Expression{"2*x + i"}}}, samples}});
    expect_rules_of_drops(animation, {-1.0, 0.0, 0.25, 0.75, 1.0, 1.5, 2.999, 3.5});
}

TEST(Rules, ChangeAtKnotsOfWhatIsUsed) {
    const Animation animation({{"l", keys(Ease::linear)}, {"h", keys(Ease::hold)}, {"a", 1.0}}, {});
    const auto times = [&](const Parts& parts, formula::Interval range) {
        std::vector<std::pair<double, bool>> found;
        for (const Knot& knot : knots(animation, parts, range)) {
            found.emplace_back(knot.time, knot.jumps);
        }
        return found;
    };
    using Times = std::vector<std::pair<double, bool>>;
    EXPECT_EQ(times({{0, 2}, {}}, {0, 4}), (Times{{1, false}, {1.5, false}}));
    EXPECT_EQ(times({{1}, {}}, {-1, 5}), (Times{{0, false}, {1, true}, {1.5, true}, {4, true}}));
    EXPECT_TRUE(times({{2}, {}}, {0, 4}).empty());
    // At its own time a jump is over: one at the end of a range is seen there, one at its begin
    // not.
    EXPECT_EQ(times({{1}, {}}, {1, 4}), (Times{{1.5, true}, {4, true}}));
    EXPECT_EQ(times({{0}, {}}, {1, 1.5}), (Times{}));
    EXPECT_EQ(times({{1}, {}}, {4, 4}), (Times{}));
}

// Elements 5 and 6 change rows at 1 s; 6 is gone at 2 s.
Animation changing_rows(std::vector<ArrayField> fields) {
    ElementSamples::Rows rows;
    rows.times = {0, 1, 2};
    rows.begin = {0, 2, 4, 5};
    rows.values = {{0, 10, 11, 1, 2}};
    rows.ids = {5, 6, 6, 5, 5};
    fields.insert(fields.begin(), {"x", Column{0}});
    return Animation(
        {},
        {{"drops", 2, std::move(fields),
          std::make_shared<const ElementSamples>(rows, ElementSamples::Interpolation::linear)}});
}

TEST(Rules, JumpWhereRowsChangeIfRowsAreRead) {
    using Times = std::vector<std::pair<double, bool>>;
    const auto times = [](const ArrayField& field) {
        const Animation animation = changing_rows({field});
        Graph graph;
        Rules rules(animation, 0.5, graph, graph.input(0));
        graph.sum(0, rules.field(0, 1));
        Times found;
        for (const Knot& knot : knots(animation, rules.used(), {0, 3}))
            found.emplace_back(knot.time, knot.jumps);
        return found;
    };
    EXPECT_EQ(times({"y", Expression{"2*x + t"}}), (Times{{1, false}, {2, true}}));
    EXPECT_EQ(times({"y", Expression{"x + n"}}), (Times{{1, false}, {2, true}}));
    for (const ArrayField& field :
         {ArrayField{"y", Expression{"0.5*i"}}, ArrayField{"y", Expression{"x + random(i, 1)"}},
          ArrayField{"y", std::vector<double>{3, 4}}}) {
        EXPECT_EQ(times(field), (Times{{1, true}, {2, true}}));
    }
}

TEST(Rules, JumpWhereTheCountOfASumDoesThoughNoFieldIsRead) {
    const Animation animation = changing_rows({{"w", 1.0}});
    for (const bool reads_field : {false, true}) {
        Graph scene, graph;
        const NodeId body = reads_field ? scene.element(0, 1) : scene.constant(1);
        const NodeId sum = scene.sum(0, body);
        Rules rules(animation, 0.5, graph, graph.input(0));
        formula::substitute(graph, scene, std::array{sum},
                            [&](Graph&, const formula::Node& node, NodeId rebuilt) {
                                return rules.in_place(node, rebuilt);
                            });
        const std::vector<Knot> found = knots(animation, rules.used(), {0, 3});
        ASSERT_FALSE(found.empty());
        EXPECT_EQ(found.back().time, 2);
        EXPECT_TRUE(found.back().jumps);
        // What has the same count is one rule.
        EXPECT_EQ(found.size(), reads_field ? 2u : 1u);
    }
}

TEST(Rules, SamplesThatHoldJumpAtTheEndOfARange) {
    for (const auto how :
         {ElementSamples::Interpolation::hold, ElementSamples::Interpolation::linear}) {
        const ElementSamples::Rows rows{{0, 1, 2}, {0, 1, 2, 3}, {{0.0, 1.0, 3.0}}, {}};
        Array blobs{"blobs", 1, {{"x", Column{0}}}, std::make_shared<ElementSamples>(rows, how)};
        const Animation animation({}, {blobs});
        const auto found = knots(animation, {{}, {0}}, {0.5, 1});
        ASSERT_EQ(found.size(), how == ElementSamples::Interpolation::hold ? 1u : 0u);
        for (const Knot& knot : found) EXPECT_TRUE(knot.time == 1 && knot.jumps);
    }
}

} // namespace
} // namespace isomotion::animation
