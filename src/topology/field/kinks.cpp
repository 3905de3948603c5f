#include "topology/field/kinks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "formula/graph/derivative.h"
#include "formula/graph/substitute.h"
#include "formula/interval/interval_operations.h"
#include "topology/field/difference.h"

namespace isomotion::topology {
namespace {

using formula::Graph;
using formula::Interval;
using formula::Node;
using formula::NodeId;
using formula::Op;

constexpr int most_unrolled = 128; // elements of a least()

struct Square {
    double weight = 1;
    NodeId of = 0;
};

// u = sum of weights times squares; none for what isn't one.
std::optional<std::vector<Square>> squares(const Graph& g, NodeId u) {
    const Node& node = g[u];
    if (node.op == Op::add) {
        auto a = squares(g, node.children[0]), b = squares(g, node.children[1]);
        if (!a || !b) return std::nullopt;
        a->insert(a->end(), b->begin(), b->end());
        return a;
    }
    if (node.op != Op::multiply) return std::nullopt;
    const auto [a, b, c, d] = node.children;
    if (a == b) return std::vector{Square{1, a}};
    const NodeId factor = g.is_constant(a) ? a : b, rest = factor == a ? b : a;
    if (!g.is_constant(factor) || !(g[factor].value > 0)) return std::nullopt;
    auto scaled = squares(g, rest);
    if (!scaled || scaled->size() != 1) return std::nullopt;
    // A product of two constants may be rounded.
    if ((*scaled)[0].weight != 1) return std::nullopt;
    (*scaled)[0].weight = g[factor].value;
    return scaled;
}

// The root of one square is an abs.
std::optional<NodeId> as_abs(Graph& g, const Node& node) {
    if (node.op != Op::sqrt) return std::nullopt;
    const auto of = squares(g, node.children[0]);
    if (!of || of->size() != 1 || (*of)[0].weight != 1) return std::nullopt;
    return g.unary(Op::abs, (*of)[0].of);
}

// Remakes the root, and what it may be written as.
void remake(Graph& g, NodeId& root, std::vector<Narrower>& narrower,
            const formula::Replacement& replacement) {
    std::vector<NodeId> all{root};
    for (const Narrower& one : narrower) all.insert(all.end(), {one.than, one.is});
    all = formula::substitute(g, g, all, replacement);
    root = all[0];
    for (std::size_t k = 0; k < narrower.size(); ++k)
        narrower[k] = {all[2 * k + 1], all[2 * k + 2]};
}

void put_abs(Graph& g, NodeId& root, std::vector<Narrower>& narrower) {
    remake(g, root, narrower, [](Graph& to, const Node&, NodeId rebuilt) {
        const Node node = to[rebuilt];
        return as_abs(to, node).value_or(rebuilt);
    });
}

NodeId narrowed(Graph& g, NodeId root, const std::vector<Narrower>& narrower) {
    if (narrower.empty()) return root;
    return formula::substitute(g, g, std::array{root}, [&](Graph&, const Node&, NodeId rebuilt) {
        const auto found = std::ranges::find(narrower, rebuilt, &Narrower::than);
        return found == narrower.end() ? rebuilt : found->is;
    })[0];
}

// Bases of powers whose exponent isn't whole: those are smooth on one side of 0 alone.
std::set<NodeId> bases(const Graph& g, std::span<const NodeId> below) {
    std::set<NodeId> found;
    for (const NodeId id : below) {
        if (g[id].op == Op::power) found.insert(g[id].children[0]);
    }
    return found;
}

// Choices that compare the same, where there are several.
using SameDifference = std::vector<std::vector<NodeId>>;

SameDifference same_differences(Graph& g, std::span<const NodeId> choices) {
    std::map<std::pair<NodeId, NodeId>, std::vector<NodeId>> by_difference;
    for (const NodeId id : choices) {
        const auto compared = difference(g, Node(g[id]));
        if (!compared) continue;
        by_difference[std::minmax(compared->first, compared->second)].push_back(id);
    }
    SameDifference several;
    for (auto& [compared, same] : by_difference) {
        if (same.size() > 1) several.push_back(std::move(same));
    }
    return several;
}

// The outermost of `choices` that holds the difference of another one beside it, as max(k - |a -
// b|, 0) does beside min(a, b): without it the other may be no kink. Else the outermost.
NodeId first_to_split(const Graph& g, std::span<const NodeId> choices, const SameDifference& all) {
    if (all.empty()) return choices.front();
    for (const NodeId id : choices) {
        const std::vector<NodeId> below = formula::nodes_below(g, std::array{id});
        const auto is_inside = [&](NodeId one) {
            return one != id && std::ranges::binary_search(below, one);
        };
        const auto is_split = [&](const std::vector<NodeId>& same) {
            const auto inside = std::ranges::count_if(same, is_inside);
            return inside > 0 && inside < std::ssize(same) &&
                   std::ranges::find(same, id) == same.end();
        };
        if (std::ranges::any_of(all, is_split)) return id;
    }
    return choices.front();
}

struct Outermost {
    NodeId id = 0;
    bool shares_difference = false; // with another choice
};

// The outermost kink of min, max or abs; else the outermost cone that isn't among those left out.
std::optional<Outermost> outermost(Graph& g, NodeId root, std::span<const NodeId> beside) {
    const std::vector<NodeId> below = formula::nodes_below(g, std::array{root});
    const std::set<NodeId> powers = bases(g, below);
    const auto find = [&](auto&& is_kink) {
        std::vector<NodeId> found;
        for (auto id = below.rbegin(); id != below.rend(); ++id) {
            if (g[*id].arrays == 0 && !powers.contains(*id) && is_kink(*id)) found.push_back(*id);
        }
        return found;
    };
    const std::vector<NodeId> choices = find([&](NodeId id) {
        return g[id].op == Op::min || g[id].op == Op::max || g[id].op == Op::abs;
    });
    if (!choices.empty()) {
        const SameDifference all = same_differences(g, choices);
        const NodeId first = first_to_split(g, choices, all);
        const auto holds_first = [&](const std::vector<NodeId>& same) {
            return std::ranges::find(same, first) != same.end();
        };
        return Outermost{first, std::ranges::any_of(all, holds_first)};
    }
    const std::vector<NodeId> cones = find([&](NodeId id) {
        return g[id].op == Op::sqrt && std::ranges::find(beside, id) == beside.end() &&
               squares(g, g[id].children[0]).has_value();
    });
    return cones.empty() ? std::nullopt : std::optional(Outermost{cones.front(), false});
}

// least(array, key) of few elements as min of their keys. Elements' fields become parameters.
void unroll(BoundFormula& formula) {
    Graph& g = formula.graph;
    formula::Bindings<Interval>& bindings = formula.bindings;
    const auto key_of = [&](Graph& to, const Node& least, std::size_t element) {
        return formula::substitute(
            to, to, std::array{least.children[0]}, [&](Graph& in, const Node& leaf, NodeId same) {
                if (leaf.op != Op::element || leaf.index != least.index) return same;
                const auto& fields = bindings.arrays[std::size_t(leaf.index)].fields;
                bindings.parameters.push_back(fields[std::size_t(leaf.second)][element]);
                return in.parameter(int(bindings.parameters.size() - 1));
            })[0];
    };
    remake(g, formula.root, formula.narrower, [&](Graph& to, const Node&, NodeId rebuilt) {
        const Node node = to[rebuilt];
        if (node.op != Op::least || node.arrays != 0) return rebuilt;
        const int count = bindings.arrays[std::size_t(node.index)].count;
        if (count < 1 || count > most_unrolled) return rebuilt;
        for (const NodeId id : formula::nodes_below(to, std::array{node.children[0]})) {
            const Node& below = to[id];
            if (formula::is_over_elements(below.op) && below.index == node.index) return rebuilt;
        }
        std::vector<NodeId> keys;
        for (std::size_t i = 0; i < std::size_t(count); ++i) keys.push_back(key_of(to, node, i));
        // Builds the least as a tree: what is far is left out of it by halves.
        for (std::size_t step = 1; step < keys.size(); step *= 2) {
            for (std::size_t k = 0; k + step < keys.size(); k += 2 * step)
                keys[k] = to.binary(Op::min, keys[k], keys[k + step]);
        }
        return keys[0];
    });
}

std::size_t multipliers_of(std::span<const Kink> kinks) {
    std::size_t count = 0;
    for (const Kink& kink : kinks) count += kink.weights.size();
    return count;
}

std::vector<Interval> ranges_of(std::span<const Kink> kinks) {
    std::vector<Interval> ranges;
    for (const Kink& kink : kinks) {
        for (const Interval& weight : kink.weights) {
            const double most = (Interval(1) / formula::Operations<Interval>::sqrt(weight)).hi;
            ranges.emplace_back(-most, most);
        }
    }
    return ranges;
}

} // namespace

Interval Kink::reach(std::span<const Interval> multipliers) const {
    Interval sum = 0;
    for (std::size_t k = 0; k < weights.size(); ++k)
        sum = sum + weights[k] * square(multipliers[first + k]);
    return sum;
}

struct KinkTree::Question {
    NodeId node;
    std::optional<Difference> of; // of a cone none
    std::vector<Square> squares;
    formula::Program h; // of a cone what it is the root of
    mutable std::unique_ptr<formula::Evaluator<Interval>> evaluator{}; // once it was asked
};

struct KinkTree::Branch {
    NodeId root;
    std::vector<Narrower> narrower;
    std::vector<Kink> kinks;
    std::vector<Interval> ranges; // of their multipliers
    std::vector<NodeId> beside;   // cones that it is beside
    std::vector<char> path;
    const Branch* above = nullptr;
    std::optional<Question> question; // none of a smooth formula
    const Question& known_question() const {
        if (!question) throw std::logic_error("a smooth formula has no question");
        return *question;
    }
    std::array<std::unique_ptr<Branch>, 4> below{};
};

namespace {
enum SideOfKink : char { negative, positive, on, beside }; // of h
} // namespace

KinkTree::KinkTree(BoundFormula formula, std::size_t most_multipliers)
    : formula_(std::move(formula))
    , most_multipliers_(most_multipliers) {
    formula_.graph.fold_exactly();
    unroll(formula_);
    put_abs(formula_.graph, formula_.root, formula_.narrower);
    root_ = make(formula_.root, formula_.narrower, {}, {}, {});
}

bool KinkTree::has_kinks() const { return root_->question.has_value(); }

KinkTree::~KinkTree() = default;

std::unique_ptr<KinkTree::Branch> KinkTree::make(NodeId root, std::vector<Narrower> narrower,
                                                 std::vector<Kink> kinks, std::vector<NodeId> cones,
                                                 std::vector<char> path) {
    auto made = std::make_unique<Branch>();
    made->root = root;
    made->narrower = std::move(narrower);
    made->ranges = ranges_of(kinks);
    made->kinks = std::move(kinks);
    made->beside = std::move(cones);
    made->path = std::move(path);
    Graph& g = formula_.graph;
    std::optional<Outermost> kink = outermost(g, root, made->beside);
    while (kink && kink->shares_difference) {
        const auto smooth = without_even_height(g, root, *difference(g, Node(g[kink->id])),
                                                formula_.bindings.parameters);
        if (!smooth) break;
        made->root = root = *smooth;
        kink = outermost(g, root, made->beside);
    }
    if (!kink) return made;
    const Node node = g[kink->id];
    Question question{kink->id, difference(g, node), {}, {}, {}};
    NodeId h = node.children[0];
    if (question.of) {
        h = g.subtract(question.of->first, question.of->second);
    } else {
        question.squares = *squares(g, h);
    }
    question.h = formula::schedule(g, std::array{h});
    made->question = std::move(question);
    return made;
}

KinkTree::Branch& KinkTree::below(Branch& branch, char side) {
    auto& made = branch.below[std::size_t(static_cast<unsigned char>(side))];
    if (made) return *made;
    Graph& g = formula_.graph;
    const Question& question = branch.known_question();
    std::vector<Kink> kinks = branch.kinks;
    std::vector<NodeId> cones = branch.beside;
    NodeId height{}; // what stands for |h|
    if (side == on || side == beside) {
        Kink kink{multipliers_of(kinks), {}, side == beside};
        const auto multiplier = [&](std::size_t k) {
            return g.input(first_multiplier_input + int(kink.first + k));
        };
        if (question.of) {
            kink.weights = {1.0};
            height = g.multiply(multiplier(0), g.subtract(question.of->first, question.of->second));
        } else {
            height = g.constant(0);
            for (std::size_t k = 0; k < question.squares.size(); ++k) {
                const Square& square = question.squares[k];
                kink.weights.emplace_back(square.weight);
                height =
                    g.add(height, g.multiply(g.multiply(g.constant(square.weight), multiplier(k)),
                                             square.of));
            }
        }
        height = g.add(height, g.input(first_height_input + int(kinks.size())));
        kinks.push_back(std::move(kink));
    }
    NodeId root = branch.root;
    std::vector<Narrower> narrower = branch.narrower;
    if (!question.of && side == positive) {
        cones.push_back(question.node);
    } else {
        const NodeId half = g.constant(0.5);
        remake(g, root, narrower, [&](Graph& to, const Node& node, NodeId rebuilt) {
            if (!question.of) {
                return node == to[question.node] ? height : rebuilt;
            }
            const auto here = difference(to, node);
            if (!here || !is_the_same(*here, *question.of)) return rebuilt;
            const bool is_negative = (side == negative) == (*here == *question.of);
            const auto [a, b] = *here;
            if (node.op == Op::abs) {
                const NodeId of = node.children[0];
                return side == on ? height : is_negative ? to.unary(Op::negate, of) : of;
            }
            if (side != on) return (node.op == Op::min) == is_negative ? a : b;
            const NodeId sum = to.add(a, b);
            return to.multiply(half,
                               node.op == Op::min ? to.subtract(sum, height) : to.add(sum, height));
        });
        put_abs(g, root, narrower);
        root = narrowed(g, root, narrower);
    }
    std::vector<char> path = branch.path;
    path.push_back(side);
    made = make(root, std::move(narrower), std::move(kinks), std::move(cones), std::move(path));
    made->above = &branch;
    return *made;
}

Interval KinkTree::asked(const Branch& branch, std::span<const Interval> inputs) {
    const Question& question = branch.known_question();
    if (!question.evaluator)
        question.evaluator = std::make_unique<formula::Evaluator<Interval>>(question.h);
    Interval h;
    question.evaluator->point(formula_.bindings, inputs, {&h, 1});
    return h;
}

bool KinkTree::descend(Branch& branch, std::span<Interval> inputs, bool with_kinks,
                       std::size_t most, std::vector<const Branch*>& found) {
    if (branch.ranges.size() > most_multipliers_) return false;
    if (!branch.question) {
        found.push_back(&branch);
        return found.size() <= most;
    }
    std::ranges::copy(branch.ranges, inputs.begin() + first_multiplier_input);
    const Interval h = asked(branch, inputs);
    const auto go = [&](char side) {
        return descend(below(branch, side), inputs, with_kinks, most, found);
    };
    if (h.lo > 0) return go(positive);
    if (!branch.question->of) return go(on) && (!with_kinks || go(beside));
    if (h.hi < 0) return go(negative);
    return go(negative) && go(positive) && (!with_kinks || go(on));
}

namespace {
std::vector<Interval> inputs_of(const SpaceBox& place, Interval clock) {
    std::vector<Interval> inputs(std::size_t(first_height_input) + 8, Interval(0));
    std::ranges::copy(place, inputs.begin());
    inputs[clock_input] = clock;
    return inputs;
}
} // namespace

std::optional<std::vector<const KinkTree::Branch*>>
KinkTree::pieces(const SpaceBox& place, Interval clock, std::size_t most) {
    std::vector<Interval> inputs = inputs_of(place, clock);
    std::vector<const Branch*> found;
    if (!descend(*root_, inputs, false, most, found)) return std::nullopt;
    return found;
}

std::optional<std::vector<const KinkTree::Branch*>>
KinkTree::strata(const SpaceBox& place, Interval clock, std::size_t most) {
    std::vector<Interval> inputs = inputs_of(place, clock);
    std::vector<const Branch*> found;
    if (!descend(*root_, inputs, true, most, found)) return std::nullopt;
    return found;
}

KinkTree::Sides KinkTree::is_on_sides(const Branch& branch, const SpaceBox& place, Interval clock,
                                      std::span<const Interval> multipliers) {
    std::vector<Interval> inputs = inputs_of(place, clock);
    std::ranges::copy(multipliers, inputs.begin() + first_multiplier_input);
    Sides sides = Sides::yes;
    std::size_t depth = branch.path.size();
    for (const Branch* above = branch.above; above; above = above->above) {
        const char side = branch.path[--depth];
        if (side == on || side == beside) continue;
        const Interval h = asked(*above, inputs);
        const bool is_certain = h.lo > 0 || h.hi < 0;
        if (is_certain && (h.lo > 0) != (side == positive)) return Sides::no;
        if (!is_certain) sides = Sides::unknown;
    }
    return sides;
}

NodeId KinkTree::root(const Branch& branch) { return branch.root; }
std::span<const Kink> KinkTree::kinks(const Branch& branch) { return branch.kinks; }
std::span<const Interval> KinkTree::ranges(const Branch& branch) { return branch.ranges; }
const std::vector<char>& KinkTree::path(const Branch& branch) { return branch.path; }

BoundFormula bound_formula(const Motion& motion) {
    Graph graph = motion.graph;
    std::vector<Narrower> narrower;
    const NodeId field = with_blends_in_pieces(graph, motion, narrower);
    return {std::move(graph), field, formula::convert<Interval>(motion.bindings),
            std::move(narrower)};
}

} // namespace isomotion::topology
