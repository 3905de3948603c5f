// F and its derivatives over boxes of n unknowns, in intervals.
//
// A sum is evaluated over only those elements that matter in a box. The sum of the other terms is
// enclosed once for that box, and holds for all boxes inside it (Elements): by an interval or, for
// terms that are smooth in the box, by Taylor's formula about its middle. An operation that asks
// for the least element keeps the elements that may be the least somewhere in the box.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "formula/evaluate/evaluate.h"
#include "formula/graph/program.h"
#include "topology/field/jet.h"
#include "topology/field/sum_slopes.h"

namespace isomotion::topology {

// The programs. All threads can share one.
class BoxField {
public:
    // Inputs of the graph: the unknowns; then, with `ends`, the least and the greatest value of the
    // last unknown in a box, and [-1, 1].
    struct Inputs {
        std::size_t unknowns = 0;
        bool has_ends = false;

        std::size_t count() const { return unknowns + (has_ends ? 3 : 0); }
    };

    BoxField() = default;
    // `jet` comes from jet_over_boxes(), with the first `rows` rows of second derivatives. Elements
    // are left out only of arrays whose loops contain no other loops; by Taylor's formula only
    // where `slopes` tells those of the array's sums.
    BoxField(formula::Graph graph, std::span<const formula::NodeId> jet, Inputs inputs,
             std::size_t rows, std::span<const SumSlopes> slopes = {});

    std::size_t unknowns() const { return inputs_.unknowns; }

private:
    friend class BoxEvaluator;

    struct Culling {
        int array = 0;           // the array whose elements are left out
        std::vector<int> fields; // fields of the array that terms depend on
        formula::Program terms;  // inputs: all of the field's, then fields; outputs: one element's
                                 // term of each sum, then each key of a least element
        std::size_t first_sum = 0;        // position among the sums of all arrays
        std::vector<char> is_first_order; // whether F or its gradient has the sum
        std::size_t keys = 0;
        // The same for Taylor's formula, if its slopes are known: outputs are one element's term of
        // each sum, each key, then slopes of the terms as their sums' remainders have them, then
        // what is 0 where they are smooth.
        formula::Program expansion;
        // What of these is asked for in the middle of a box.
        formula::Program middle;
        bool can_expand = false;
    };
    // The remainder of a sum by Taylor's formula, as parameters of the expanded programs: the value
    // in the middle; slopes by each unknown; half of second slopes by the same unknown, and second
    // ones, for each i each j <= i.
    struct Remainder {
        std::size_t first_parameter = 0;
        std::size_t slopes = 0, second = 0; // how many; without slopes the value is an enclosure

        std::size_t parameters() const { return 1 + slopes + second; }
    };
    // Sums over an array, and the keys of operations that ask for its least element.
    struct Loops {
        std::vector<formula::NodeId> sums, keys;
    };
    static std::map<int, Loops> loops_to_cull(const formula::Graph& graph,
                                              std::span<const formula::NodeId> roots);
    Culling culling(formula::Graph& graph, int array, const Loops& loops,
                    std::span<const formula::NodeId> first_order,
                    std::span<const SumSlopes> slopes) const;
    // The sum's remainder as an expression of the unknowns.
    formula::NodeId expanded(formula::Graph& graph, const Remainder& remainder) const;

    Inputs inputs_;
    std::size_t rows_ = 0;
    std::vector<Culling> cullings_;
    std::size_t sums_ = 0; // sums whose elements may be left out
    // Inputs: the field's, then the enclosed remainder of each sum.
    formula::Program value_, gradient_, jet_;
    // Parameters: the field's own, the middle that remainders are about, then the remainders.
    formula::Program expanded_value_, expanded_gradient_, expanded_jet_;
    std::size_t middle_ = 0;            // the first parameter of the middle
    std::vector<Remainder> remainders_; // of each sum
};

// The elements that matter, and the enclosed remainder of each sum.
struct Elements {
    formula::Bindings<formula::Interval> bindings;
    std::vector<formula::Interval> rest;
    // Set if the elements are expanded. The remainders are then among the parameters, behind the
    // field's own, of which there are so many.
    std::optional<std::size_t> own_parameters{};

    bool are_expanded() const { return own_parameters.has_value(); }
};

// Evaluates over boxes. Use one per thread.
class BoxEvaluator {
public:
    BoxEvaluator(const BoxField& field, formula::Bindings<formula::Interval> bindings);

    // Binds other values to the same names.
    void bind(formula::Bindings<formula::Interval> bindings) {
        all_.bindings = std::move(bindings);
    }

    const Elements& all() const { return all_; }
    // Keeps the elements with some term over the box above `negligible` times the largest term of
    // its sum. `from` must hold for the box.
    Elements near(const Box& box, const Elements& from, double negligible);
    // Keeps the elements with some term of F or of its gradient that changes in the box by more
    // than `negligible` times the size of all terms of its sum.
    Elements changing(const Box& box, const Elements& from, double negligible);
    // Leaves out elements whose terms are known by Taylor's formula nearly as well as by
    // themselves: in all they blur F and its derivatives by no more than `part` of the width that
    // intervals of all terms over the box have. `from` must not be expanded.
    Elements expanded(const Box& box, const Elements& from, double part);

    void values(const Elements& elements, std::span<const Box> boxes,
                std::vector<formula::Interval>& values);
    // Jets without second derivatives, then with them.
    void gradients(const Elements& elements, std::span<const Box> boxes,
                   std::vector<Jet<formula::Interval>>& jets);
    void jets(const Elements& elements, std::span<const Box> boxes,
              std::vector<Jet<formula::Interval>>& jets);
    Jet<formula::Interval> jet(const Box& box);

private:
    using Evaluator = formula::Evaluator<formula::Interval>;

    void load(std::size_t lane, const Box& box);
    void load(const Elements& elements, std::span<const Box> boxes);
    void run(Evaluator& program, const Elements& elements, std::size_t outputs);
    Evaluator& of(const Elements& elements, Evaluator& plain, Evaluator& expanded) {
        return elements.are_expanded() ? expanded : plain;
    }
    // Drops elements none of whose terms matter and that are nowhere the least. `matters` compares
    // a term of a sum with what `size` computes from all terms of that sum over the box.
    template<class Size, class Matters>
    Elements cull(const Box& box, const Elements& from, Size&& size, Matters&& matters);
    // Leaves what a program tells of each element over each of the boxes in the outputs: all
    // elements over the first box, then over the next.
    void run_terms(Evaluator& program, const BoxField::Culling& culling, std::span<const Box> boxes,
                   const Elements& from, std::size_t outputs);

    const BoxField& field_;
    Elements all_;
    Evaluator value_, gradient_, jet_, expanded_value_, expanded_gradient_, expanded_jet_;
    std::vector<Evaluator> terms_, expansions_, middles_; // one for each culling
    std::vector<std::vector<formula::Interval>> inputs_, outputs_;
};

} // namespace isomotion::topology
