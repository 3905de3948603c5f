// A formula's text, straight to numbers: what most tests of this folder begin with.
#pragma once

#include <array>
#include <initializer_list>
#include <random>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "formula/evaluate/evaluate.h"
#include "formula/graph/lowering.h"
#include "formula/graph/parser.h"

namespace isomotion::formula {

// Two arrays: `blobs` with six fields (two texels), `links` with two and a third that is shared.
inline Vocabulary test_vocabulary() {
    Vocabulary v;
    v.inputs = coordinate_names;
    v.parameters = {"a", "b", "c", "m", "width"};
    v.arrays = {
        {"blobs", {{"cx", {}}, {"cy", {}}, {"cz", {}}, {"weight", {}}, {"r", {}}, {"s", {}}}},
        {"links", {{"px", {}}, {"py", {}}, {"width", 4}}}};
    v.allows_equation = true;
    return v;
}

inline Bindings<double> test_bindings(int blobs = 3, int links = 2) {
    Bindings<double> bindings;
    bindings.parameters = {1.25, -0.75, 0.5, 3, 0.125};
    const auto columns = [](int count, int fields) {
        ArrayColumns<double> array;
        array.count = count;
        for (int f = 0; f < fields; ++f) {
            auto& column = array.fields.emplace_back();
            for (int i = 0; i < count; ++i) column.push_back(0.25 * (f + 1) - 0.375 * i);
        }
        return array;
    };
    bindings.arrays = {columns(blobs, 6), columns(links, 2)};
    return bindings;
}

using Point = std::array<double, 3>;

inline double run(const Program& program, const Point& p = {},
                  const Bindings<double>& bindings = test_bindings()) {
    double result = 0;
    Evaluator<double>(program).point(bindings, p, {&result, 1});
    return result;
}

inline double value_of(Graph& graph, NodeId node, const Point& p = {},
                       const Bindings<double>& bindings = test_bindings()) {
    return run(schedule_lowered(graph, node), p, bindings);
}

inline double value_of(std::string_view text, const Point& p = {},
                       const Bindings<double>& bindings = test_bindings()) {
    Graph graph;
    const NodeId root = parse(text, test_vocabulary(), graph);
    return value_of(graph, root, p, bindings);
}

inline NodeId parse(Graph& graph, std::string_view text) {
    return parse(text, test_vocabulary(), graph);
}

// Both texts are one node of one graph.
inline void expect_same(const std::string& text, const std::string& plain) {
    Graph graph;
    EXPECT_EQ(parse(graph, text), parse(graph, plain)) << text;
}

// Random tests print the seed they failed with.
class Random {
public:
    explicit Random(std::uint64_t seed)
        : engine_(seed) {}
    // The engine's bits are the standard's, a distribution's are not.
    double in(double low, double high) {
        return low + (high - low) * (double(engine_() >> 11) * 0x1p-53);
    }
    int below(int bound) { return int(engine_() % std::uint64_t(bound)); }
    Point point(double reach) { return {in(-reach, reach), in(-reach, reach), in(-reach, reach)}; }

private:
    std::mt19937_64 engine_;
};

} // namespace isomotion::formula
