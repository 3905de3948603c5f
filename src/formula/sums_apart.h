// Programs taken apart: an array's sums, term by term, and what is done with the sums.
//
// So they may be evaluated with the elements side by side, and over some elements in place of all.
// What asks for the least element counts as a sum, whose terms are the keys, and the values of a
// pick.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "formula/graph/program.h"

namespace isomotion::formula {

struct SumsApart {
    int places = 0;          // inputs of the whole program
    std::vector<int> fields; // of the array, that terms read
    Program terms;           // inputs: those of the whole, then fields -> the terms of each sum
    Program rest;            // inputs: those of the whole, then sums -> the outputs of the whole
    struct Sum {
        NodeId node; // in the graph that it was taken from; ascending
        Op op;
        int term; // its first output of `terms`
    };
    std::vector<Sum> sums;

    int first_field() const { return places; } // input of `terms`
    int first_sum() const { return places; }   // input of `rest`
};

// Takes a program with `places` inputs. None if a sum over `array` holds another sum or lies in
// one.
std::optional<SumsApart> sums_apart(const Graph& graph, std::span<const NodeId> roots, int array,
                                    int places);

// The sums over the array below the roots, ascending, and what asks for its least element; empty
// also if one holds another sum or lies in one.
std::vector<NodeId> sums_over(const Graph& graph, std::span<const NodeId> roots, int array);

// Fields of an array's current element as inputs from `first` on, for substitute(). Fields that are
// new are added to `fields`.
class FieldsAsInputs {
public:
    FieldsAsInputs(std::vector<int>& fields, int array, int first)
        : fields_(fields)
        , array_(array)
        , first_(first) {}

    NodeId operator()(Graph& graph, const Node& node, NodeId rebuilt) const;

private:
    std::vector<int>& fields_;
    int array_, first_;
};

} // namespace isomotion::formula
