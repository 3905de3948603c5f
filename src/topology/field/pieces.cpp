#include "topology/field/pieces.h"

#include <algorithm>

#include "formula/graph/continuity.h"
#include "formula/graph/substitute.h"

namespace isomotion::topology {
namespace {

using formula::Graph;
using formula::Interval;
using formula::Node;
using formula::NodeId;
using formula::Op;

constexpr std::size_t most_pieces = 64, most_multipliers = 6;
constexpr std::size_t most_kept = 512; // fields of pieces

// Multipliers may be anything in their ranges.
SpaceFormula alone(const BoundFormula& from, const KinkTree::Branch& piece, Side solid) {
    SpaceFormula made{{}, {}, from.bindings, solid};
    made.graph.fold_exactly();
    const auto first = int(from.bindings.parameters.size());
    for (const Interval& range : KinkTree::ranges(piece)) made.bindings.parameters.push_back(range);
    made.root =
        formula::substitute(made.graph, from.graph, std::array{KinkTree::root(piece)},
                            [&](Graph& to, const Node& node, NodeId rebuilt) {
                                if (node.op != Op::input) return rebuilt;
                                if (node.index >= first_height_input) return to.constant(0);
                                if (node.index < first_multiplier_input) return rebuilt;
                                return to.parameter(first + node.index - first_multiplier_input);
                            })[0];
    return made;
}

} // namespace

Pieces::Pieces(const SpaceFormula& formula)
    : solid_(formula.solid)
    , tree_({formula.graph, formula.root, formula.bindings}, most_multipliers)
    , whole_({tree_.formula().graph, tree_.formula().root, tree_.formula().bindings, solid_}) {
    Graph g = tree_.formula().graph;
    const NodeId jumps = formula::jumps(g, tree_.formula().root);
    jumps_ = formula::schedule(g, std::array{jumps});
}

bool Pieces::may_jump(const SpaceBox& box) {
    Interval jumps;
    formula::Evaluator<Interval>(jumps_).point(tree_.formula().bindings, box, {&jumps, 1});
    return jumps != Interval(0.0);
}

FrameField& Pieces::field(const KinkTree::Branch& piece) {
    auto& made = fields_[&piece];
    if (!made) made = std::make_unique<FrameField>(alone(tree_.formula(), piece, solid_));
    return *made;
}

Interval Pieces::value(const SpaceBox& box) {
    Interval value;
    whole_.values(whole_.everything(), {&box, 1}, {&value, 1});
    return value;
}

Pieces::Over Pieces::over(const SpaceBox& box, const Elements& near) {
    const auto sign_of = [](Interval value) {
        return value.lo > 0 ? Sign::positive : value.hi < 0 ? Sign::negative : Sign::mixed;
    };
    Over over;
    if (!has_kinks()) {
        ValueAndGradient g;
        whole_.over(near, {&box, 1}, {&g, 1});
        if (contains(g.value, 0.0)) whole_.tighten(near, {&box, 1}, {&g, 1});
        over.sign = sign_of(g.value);
        if (over.sign != Sign::mixed || may_jump(box)) return over;
        std::ranges::copy(g.gradient, over.gradients.emplace_back().begin());
        return over;
    }
    over.sign = sign_of(value(box));
    if (over.sign != Sign::mixed || may_jump(box)) return over;
    const auto pieces = tree_.pieces(box, Interval(0), most_pieces);
    if (!pieces) return over;
    if (fields_.size() > most_kept) fields_.clear(); // made again where they are asked for
    bool may_be_negative = false, may_be_positive = false;
    for (const KinkTree::Branch* piece : *pieces) {
        FrameField& of_piece = field(*piece);
        ValueAndGradient g;
        of_piece.over(of_piece.everything(), {&box, 1}, {&g, 1});
        if (contains(g.value, 0.0)) of_piece.tighten(of_piece.everything(), {&box, 1}, {&g, 1});
        const Sign sign = sign_of(g.value);
        may_be_negative |= sign != Sign::positive;
        may_be_positive |= sign != Sign::negative;
        if (sign != Sign::mixed) continue;
        Box& gradient = over.gradients.emplace_back();
        std::ranges::copy(g.gradient, gradient.begin());
    }
    if (over.gradients.empty() && may_be_negative != may_be_positive)
        over.sign = may_be_negative ? Sign::negative : Sign::positive;
    return over;
}

} // namespace isomotion::topology
