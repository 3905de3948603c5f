// F over boxes of n unknowns, with its derivatives, in intervals.
//
// A sum is evaluated over those elements alone that matter in a box. What the others add to it is
// enclosed once, for that box, and holds for all boxes in it (Elements). What asks for the least
// element keeps those that may be it somewhere in the box.
#pragma once

#include <map>
#include <span>
#include <utility>
#include <vector>

#include "formula/evaluate/evaluate.h"
#include "formula/graph/program.h"
#include "topology/field/jet.h"

namespace isomotion::topology {

// The programs. One for all threads.
class BoxField {
public:
    // Inputs of the graph: the unknowns, then `ends`: the least and the greatest value of the last
    // unknown in a box, and [-1, 1].
    struct Inputs {
        std::size_t unknowns = 0;
        bool has_ends = false;

        std::size_t count() const { return unknowns + (has_ends ? 3 : 0); }
    };

    BoxField() = default;
    // `jet` is that of jet_over_boxes(), with the first `rows` rows of second derivatives.
    // Elements may be left out of those arrays whose loops hold no others.
    BoxField(formula::Graph graph, std::span<const formula::NodeId> jet, Inputs inputs,
             std::size_t rows);

    std::size_t unknowns() const { return inputs_.unknowns; }

private:
    friend class BoxEvaluator;

    struct Culling {
        int array = 0;             // whose elements are left out
        std::vector<int> fields;   // columns of the array that terms depend on
        formula::Program terms;    // inputs: all of the field's, then fields; one element's part of
                                   // each sum, then each key that may be the least
        std::size_t first_sum = 0; // position among the sums of all arrays
        std::vector<char> is_first_order; // whether F or its gradient has the sum
        std::size_t keys = 0;
    };
    // Sums over an array, and the keys of what asks for its least element.
    struct Loops {
        std::vector<formula::NodeId> sums, keys;
    };
    static std::map<int, Loops> loops_to_cull(const formula::Graph& graph,
                                              std::span<const formula::NodeId> roots);
    Culling culling(formula::Graph& graph, int array, const Loops& loops,
                    std::span<const formula::NodeId> first_order) const;

    Inputs inputs_;
    std::size_t rows_ = 0;
    std::vector<Culling> cullings_;
    std::size_t sums_ = 0; // whose elements may be left out
    // Inputs: the field's, then what is added to each sum.
    formula::Program value_, gradient_, jet_;
};

// The elements that matter, and what the others add to each sum.
struct Elements {
    formula::Bindings<formula::Interval> bindings;
    std::vector<formula::Interval> rest;
};

// Evaluates over boxes. One a thread.
class BoxEvaluator {
public:
    BoxEvaluator(const BoxField& field, formula::Bindings<formula::Interval> bindings);

    // Other values for the same names.
    void bind(formula::Bindings<formula::Interval> bindings) {
        all_.bindings = std::move(bindings);
    }

    const Elements& all() const { return all_; }
    // Keeps the elements of which some term over the box is more than `negligible` times the
    // largest term of its sum. `from` must hold for the box.
    Elements near(const Box& box, const Elements& from, double negligible);
    // Keeps the elements of which some term of F or of its gradient changes in the box by more than
    // `negligible` times the size of all terms of its sum.
    Elements changing(const Box& box, const Elements& from, double negligible);

    void values(const Elements& elements, std::span<const Box> boxes,
                std::vector<formula::Interval>& values);
    // Jets without second derivatives, and with them.
    void gradients(const Elements& elements, std::span<const Box> boxes,
                   std::vector<Jet<formula::Interval>>& jets);
    void jets(const Elements& elements, std::span<const Box> boxes,
              std::vector<Jet<formula::Interval>>& jets);
    Jet<formula::Interval> jet(const Box& box);

private:
    void load(std::size_t lane, const Box& box);
    void load(const Elements& elements, std::span<const Box> boxes);
    void run(formula::Evaluator<formula::Interval>& program, const Elements& elements,
             std::size_t outputs);
    // Without the elements of which no term matters and that are the least nowhere: a term of a sum
    // is compared with what `size` makes of all terms of that sum over the box.
    template<class Size, class Matters>
    Elements cull(const Box& box, const Elements& from, Size&& size, Matters&& matters);
    // The terms of each element over the box are then in the outputs.
    void run_terms(std::size_t culling, const Box& box, const Elements& from);

    const BoxField& field_;
    Elements all_;
    formula::Evaluator<formula::Interval> value_, gradient_, jet_;
    std::vector<formula::Evaluator<formula::Interval>> terms_; // one for each culling
    std::vector<std::vector<formula::Interval>> inputs_, outputs_;
};

} // namespace isomotion::topology
