#include "formula/graph/program.h"

#include <algorithm>
#include <cassert>
#include <map>

#include "formula/graph/functions.h"

namespace isomotion::formula {
namespace {

class Scheduler {
public:
    explicit Scheduler(const Graph& graph)
        : graph_(graph)
        , registers_(graph.size(), -1)
        , done_(graph.size(), false)
        , scope_of_(graph.size(), 0)
        , level_(graph.size(), 0) {}

    Program run(std::span<const NodeId> roots, std::uint32_t inside) {
        emit_scope(inside, {roots.begin(), roots.end()});
        for (const NodeId root : roots) program_.outputs.push_back(registers_[root]);
        return std::move(program_);
    }

private:
    // What a scope computes once loops of lower levels are done; both in ascending order.
    struct Level {
        std::map<int, std::vector<NodeId>> loops; // by array: what goes through its elements
        std::vector<NodeId> operations;
    };

    // Emits whatever `wanted` needs that can be computed with the arrays of `bound` fixed, in an
    // order where loops of one level (none of this scope feeds another) come together.
    void emit_scope(std::uint32_t bound, const std::vector<NodeId>& wanted) {
        for (const auto& [loops, operations] : levels(bound, wanted)) {
            for (const auto& [array, group] : loops) emit_loop(bound, array, group);
            for (const NodeId id : operations) {
                emit_operation(id);
                set_done(id);
            }
        }
    }

    std::vector<Level> levels(std::uint32_t bound, const std::vector<NodeId>& wanted) {
        const std::vector<NodeId> live = reachable(wanted); // of the scope's number
        std::vector<Level> levels(1);
        for (const NodeId id : live) {
            const Node& node = graph_[id];
            int level = 0;
            for (int k = 0; k < node.arity; ++k) {
                const NodeId child = node.children[std::size_t(k)];
                if (scope_of_[child] == scope_) level = std::max(level, level_[child]);
            }
            const bool is_ours = belongs(node, bound);
            if (is_over_elements(node.op) && is_ours) ++level;
            level_[id] = level;
            if (!is_ours) continue;
            if (std::size_t(level) >= levels.size()) levels.resize(std::size_t(level) + 1);
            Level& at = levels[std::size_t(level)];
            (is_over_elements(node.op) ? at.loops[node.index] : at.operations).push_back(id);
        }
        return levels;
    }

    void set_done(NodeId id) {
        done_[id] = true;
        trail_.push_back(id);
    }

    void emit_loop(std::uint32_t bound, int array, const std::vector<NodeId>& wanted) {
        std::vector<NodeId> bodies;
        std::vector<Instruction> accumulates;
        for (const NodeId id : wanted) {
            const Node& node = graph_[id];
            Instruction begin;
            begin.kind = Instruction::Kind::begin;
            begin.op = node.op;
            begin.index = array;
            begin.second = int(id);
            begin.result = registers_[id] = program_.registers++;
            if (keeps_least(node.op)) begin.operands[2] = program_.registers++;
            program_.instructions.push_back(begin);
            for (std::size_t k = 0; k < node.arity; ++k) bodies.push_back(node.children[k]);
            begin.kind = Instruction::Kind::accumulate;
            begin.arity = node.arity;
            accumulates.push_back(begin);
        }
        Instruction begin;
        begin.kind = Instruction::Kind::loop_begin;
        begin.index = array;
        program_.instructions.push_back(begin);
        const std::size_t before = trail_.size();
        emit_scope(bound | 1u << array, bodies);
        for (std::size_t w = 0; w < wanted.size(); ++w) {
            for (std::size_t k = 0; k < accumulates[w].arity; ++k)
                accumulates[w].operands[k] = registers_[graph_[wanted[w]].children[k]];
            program_.instructions.push_back(accumulates[w]);
        }
        // What a loop computes is gone after it.
        for (; trail_.size() > before; trail_.pop_back()) done_[trail_.back()] = false;
        for (const NodeId id : wanted) set_done(id);
        Instruction end;
        end.kind = Instruction::Kind::loop_end;
        program_.instructions.push_back(end);
    }

    void emit_operation(NodeId id) {
        const Node& node = graph_[id];
        Instruction instruction;
        instruction.op = node.op;
        instruction.arity = node.arity;
        instruction.index = node.index;
        instruction.second = node.second;
        instruction.value = node.value;
        for (std::size_t k = 0; k < node.arity; ++k) {
            instruction.operands[k] = registers_[node.children[k]];
            assert(instruction.operands[k] >= 0);
        }
        instruction.result = registers_[id] = program_.registers++;
        program_.instructions.push_back(instruction);
    }

    // Everything not yet done below `wanted`, bodies of loops included, in ascending order.
    std::vector<NodeId> reachable(const std::vector<NodeId>& wanted) {
        std::vector<NodeId> stack, found;
        ++scope_;
        const auto visit = [&](NodeId id) {
            if (scope_of_[id] == scope_ || done_[id]) return;
            scope_of_[id] = scope_;
            stack.push_back(id);
        };
        for (const NodeId id : wanted) visit(id);
        while (!stack.empty()) {
            const NodeId id = stack.back();
            stack.pop_back();
            found.push_back(id);
            const Node& node = graph_[id];
            for (int k = 0; k < node.arity; ++k) visit(node.children[std::size_t(k)]);
        }
        std::sort(found.begin(), found.end());
        return found;
    }

    static bool belongs(const Node& node, std::uint32_t bound) {
        return (node.arrays & ~bound) == 0;
    }

    const Graph& graph_;
    std::vector<Register> registers_;
    std::vector<bool> done_;
    std::vector<NodeId> trail_; // what is done, in order
    int scope_ = 0;             // the number of scopes that were looked at
    std::vector<int> scope_of_; // the last one that a node was found in
    std::vector<int> level_;    // of a node, in that scope
    Program program_;
};

} // namespace

Program schedule(const Graph& graph, std::span<const NodeId> roots, std::uint32_t inside) {
    return Scheduler(graph).run(roots, inside);
}

Cost cost(const Program& program, std::span<const int> counts) {
    Cost total;
    std::vector<double> repeats{1};
    for (const Instruction& instruction : program.instructions) {
        switch (instruction.kind) {
        case Instruction::Kind::loop_begin: {
            const auto array = std::size_t(instruction.index);
            const double count = array < counts.size() ? counts[array] : 0;
            repeats.push_back(repeats.back() * count);
            total.iterations += repeats.back();
            break;
        }
        case Instruction::Kind::loop_end:
            repeats.pop_back();
            break;
        case Instruction::Kind::accumulate:
            total.operations += repeats.back();
            break;
        case Instruction::Kind::operation:
            if (instruction.arity > 0) total.operations += repeats.back();
            if (instruction.op == Op::noise) {
                total.operations += operations_of_noise * repeats.back();
                total.noises += repeats.back();
            }
            if (!kernel(instruction.op).empty()) total.functions += repeats.back();
            break;
        case Instruction::Kind::begin:
            break;
        }
    }
    return total;
}

} // namespace isomotion::formula
