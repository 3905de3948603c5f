// Functions that a formula defines itself: f(u, v) = u^2 + v^2;
#pragma once

#include <array>
#include <map>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "formula/graph/graph.h"

namespace isomotion::formula {

// A call that can't be made: what() says why, and the caller knows the place.
class CallError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct OwnFunction {
    std::vector<std::string> arguments;
    NodeId body; // in OwnFunctions::bodies()
};

// A call is the function's expression with the arguments in their places. Expressions are kept in a
// graph of their own, where arguments, and names that were defined outside, are inputs. An argument
// may be taken at another point, f(x - 1, y, z): there it is not known yet, so Op::at stands for
// it.
class OwnFunctions {
public:
    Graph& bodies() { return bodies_; }
    // What stands in a body for its argument k, and for a node of the graph of its calls.
    NodeId argument(std::size_t k) { return bodies_.input(first_argument + int(k)); }
    NodeId outside(NodeId node) { return bodies_.input(first_outside + int(node)); }

    void add(std::string_view name, OwnFunction function);
    const OwnFunction* find(std::string_view name) const; // null if there is none
    std::vector<std::string> names() const;

    // The call's node. `to` may be bodies(): then what stands for nodes outside stays. `work` grows
    // by the operations that the call looks at. Throws CallError.
    NodeId call(Graph& to, const OwnFunction& function, std::span<const NodeId> arguments,
                std::size_t& work) const;
    // Whether the function's value depends on the place, or on what an argument is elsewhere.
    bool has_place(const OwnFunction& function) const;
    // One of these arrays that the function goes through.
    std::optional<int> array_of(const OwnFunction& function, std::span<const int> arrays) const;

private:
    friend NodeId at_point(Graph& graph, NodeId expression, const std::array<NodeId, 3>& point,
                           std::size_t& work);
    // Beyond all inputs that formulas have.
    static constexpr int first_argument = 1 << 17, first_outside = 1 << 18;

    Graph bodies_;
    std::map<std::string, OwnFunction, std::less<>> functions_;
};

// The expression with these in place of x, y and z, inputs 0 to 2. `work` grows likewise. Throws
// CallError.
NodeId at_point(Graph& graph, NodeId expression, const std::array<NodeId, 3>& point,
                std::size_t& work);

// Whether a node from `first` on is a constant without a value: no number, cut off, or 1/0. What a
// call makes of constants can't be told where its function is defined.
bool has_undefined_constant(const Graph& graph, std::size_t first);

} // namespace isomotion::formula
