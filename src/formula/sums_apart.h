// Splits programs into the terms of an array's sums and the operations on the sums.
//
// This allows evaluating the elements side by side, and evaluating sums over some elements instead
// of all. An operation that asks for the least element counts as a sum, whose terms are the keys
// and the values of a pick.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "formula/graph/program.h"

namespace isomotion::formula {

struct SumsApart {
    int places = 0;          // inputs of the whole program
    std::vector<int> fields; // fields of the array that terms read
    Program terms; // inputs: those of the whole program, then fields -> the terms of each sum
    Program rest;  // inputs: those of the whole program, then sums -> its outputs
    struct Sum {
        NodeId node; // in the original graph; ascending
        Op op;
        int term; // index of its first output of `terms`
    };
    std::vector<Sum> sums;

    int first_field() const { return places; } // input of `terms`
    int first_sum() const { return places; }   // input of `rest`
};

// Splits a program with `places` inputs. None if a sum over `array` holds another sum or lies in
// one.
std::optional<SumsApart> sums_apart(const Graph& graph, std::span<const NodeId> roots, int array,
                                    int places);

// The sums over the array below the roots, in ascending order, and the operations that ask for its
// least element. Empty also if one holds another sum or lies in one.
std::vector<NodeId> sums_over(const Graph& graph, std::span<const NodeId> roots, int array);

// Replaces fields of an array's current element by inputs from `first` on, for substitute(). Adds
// new fields to `fields`.
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
