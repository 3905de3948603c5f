#include <cmath>

#include <fmt/format.h>

#include "formula/enclosure.h"
#include "formula/field.h"
#include "formula/glsl/glsl_interval.h"
#include "formula/graph/degree.h"
#include "formula/graph/derivative.h"
#include "formula/graph/lowering.h"
#include "formula/graph/parser.h"
#include "formula/graph/substitute.h"
#include "formula/linear_sum.h"
#include "fuzz/generated_glsl.h"
#include "fuzz/targets.h"

namespace isomotion::fuzz {
namespace {

using namespace formula;
using formula::Interval; // and not the public header's

Vocabulary vocabulary() {
    Vocabulary v;
    v.inputs = coordinate_names;
    v.parameters = {"a", "b", "m", "float", "width"};
    v.arrays = {{"blobs", {{"cx", {}}, {"cy", {}}, {"cz", {}}, {"w", {}}, {"k", {}}}},
                {"links", {{"px", {}}, {"width", 4}}}};
    return v;
}

Bindings<double> bindings() {
    Bindings<double> b;
    b.parameters = {1.25, -0.75, 3, 0, 0.125};
    b.arrays = {{2, {{0.5, -1}, {0, 2}, {1e-3, 4}, {1, -3}, {30, 0.1}}}, {1, {{-0.25}}}};
    return b;
}

constexpr std::array<double, 3> places[] = {{0.3, -0.7, 1.1}, {0, 0, 0}, {1e6, -1e-6, 2}};

// Where doubles go on as real numbers do, apart from rounding.
bool is_tame(double value) {
    const double size = std::abs(value);
    return value == 0 || (size > 1e-250 && size < 1e250);
}

bool is_defined(const Node& node, const std::vector<double>& values) {
    const double a = node.arity > 0 ? values[node.children[0]] : 0;
    const double b = node.arity > 1 ? values[node.children[1]] : 0;
    switch (node.op) {
    case Op::sqrt:
        return a >= 0;
    case Op::log:
        return a > 0;
    case Op::acosh:
        return a >= 1;
    case Op::asin:
    case Op::acos:
        return std::abs(a) <= 1;
    case Op::divide:
        return b != 0;
    case Op::power:
        return a > 0;
    default:
        return true;
    }
}

// Every node outside of loops is an output: where its children's values in double lie in their
// intervals, its own does.
void check_enclosure(const Graph& graph, NodeId root, const std::array<double, 3>& place) {
    std::vector<NodeId> nodes;
    for (const NodeId id : nodes_below(graph, std::array{root})) {
        if (graph[id].op == Op::chebyshev)
            return; // exact on intervals, rounded products on numbers
        if (graph[id].arrays == 0) nodes.push_back(id);
    }
    const Program program = schedule(graph, nodes);
    std::vector<double> results(nodes.size()), values(graph.size());
    std::vector<Interval> bounds(nodes.size());
    std::vector<bool> follows(graph.size());
    const Bindings<double> numbers = bindings();
    Evaluator<double>(program).point(numbers, place, results);
    const std::array<Interval, 3> box{place[0], place[1], place[2]};
    Evaluator<Interval>(program).point(convert<Interval>(numbers), box, bounds);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        const Node& node = graph[nodes[k]];
        const double value = values[nodes[k]] = results[k];
        bool check = is_tame(value) && node.op != Op::sum && is_defined(node, values);
        for (int c = 0; c < node.arity; ++c) check &= follows[node.children[std::size_t(c)]];
        if (check && !contains(bounds[k], value)) {
            throw Violation(fmt::format("{} = {} lies outside [{}, {}]", name(node.op), value,
                                        bounds[k].lo, bounds[k].hi));
        }
        follows[nodes[k]] = check || (node.op == Op::sum && contains(bounds[k], value));
    }
}

void evaluate(const Field& field, const EnclosurePrograms& enclosing) {
    const Bindings<double> numbers = bindings();
    const auto floats = convert<float>(numbers);
    const auto intervals = convert<Interval>(numbers);
    FieldEvaluator<double> in_double(field);
    FieldEvaluator<float> in_float(field);
    Evaluator<Interval> along(enclosing.directional), gradient(enclosing.gradient);
    for (const auto& [x, y, z] : places) {
        in_double.directional(numbers, {x, y, z}, {1, 0, -1});
        in_double.gradient(numbers, {x, y, z});
        in_float.directional(floats, {float(x), float(y), float(z)}, {1, 0, -1});
        in_float.gradient(floats, {float(x), float(y), float(z)});
        const std::array<Interval, 6> ray{{{x, x + 0.25}, y, {z - 1, z}, 1, {-1, 1}, 0.5}};
        std::array<Interval, 2> line;
        std::array<Interval, 3> slopes;
        along.point(intervals, ray, line);
        gradient.point(intervals, std::span(ray).first(3), slopes);
        for (const Interval& bound : {line[0], line[1], slopes[0], slopes[1], slopes[2]}) {
            if (is_empty(bound)) throw Violation("an empty interval");
        }
    }
}

// Animation's grammar knows other names.
void as_expression(std::string_view text) {
    Vocabulary of_time;
    of_time.inputs = {"t", "i", "n"};
    of_time.parameters = {"a", "b", "camera.fov"};
    of_time.allows_random = true;
    Graph graph;
    try {
        const NodeId root = parse(text, of_time, graph);
        const Program program = schedule_lowered(graph, root);
        Bindings<double> numbers;
        numbers.parameters = {1, -2, 40};
        double result = 0;
        Evaluator<double>(program).point(numbers, std::array{0.5, 3.0, 10.0}, {&result, 1});
    } catch (const ParseError&) {
    }
}

} // namespace

void formula(std::string_view text) {
    as_expression(text);
    Field field;
    try {
        field = make_field(text, vocabulary());
    } catch (const ParseError& error) {
        if (std::string_view(error.what()).size() > 2000) throw Violation("an endless message");
        return;
    } catch (const std::length_error&) {
        return;
    }
    const EnclosurePrograms enclosing = enclosure_programs(field);
    check_generated(glsl_value(field) + glsl_directional(field) + glsl_gradient(field) +
                    glsl_value_interval(enclosing, field.packing) +
                    glsl_directional_interval(enclosing, field.packing) +
                    glsl_gradient_interval(enclosing, field.packing));
    degree(field.graph, field.root);
    if (const auto sum = linear_sum(field)) {
        check_generated(glsl_rest_and_factor_interval(*sum, field.packing) +
                        glsl_term_interval(*sum, field.packing));
    }
    evaluate(field, enclosing);
    for (const auto& place : places) check_enclosure(field.graph, field.root, place);
}

} // namespace isomotion::fuzz
