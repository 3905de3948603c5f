// Arithmetic operators on nodes of a graph.
#pragma once

#include "formula/graph/graph.h"

namespace isomotion::formula {

struct Term {
    Graph* graph;
    NodeId node;

    Term number(double value) const { return {graph, graph->constant(value)}; }
    Term of(Op op) const { return {graph, graph->unary(op, node)}; }
    Term with(Op op, Term b) const { return {graph, graph->binary(op, node, b.node)}; }
};

inline Term operator-(Term a) { return a.of(Op::negate); }
inline Term operator+(Term a, Term b) { return a.with(Op::add, b); }
inline Term operator-(Term a, Term b) { return a.with(Op::subtract, b); }
inline Term operator*(Term a, Term b) { return a.with(Op::multiply, b); }
inline Term operator/(Term a, Term b) { return a.with(Op::divide, b); }
inline Term operator+(double a, Term b) { return b.number(a) + b; }
inline Term operator-(double a, Term b) { return b.number(a) - b; }
inline Term operator*(double a, Term b) { return b.number(a) * b; }
inline Term operator/(double a, Term b) { return b.number(a) / b; }

inline Term min(Term a, Term b) { return a.with(Op::min, b); }
inline Term max(Term a, Term b) { return a.with(Op::max, b); }

} // namespace isomotion::formula
