#include "formula/graph/program.h"

#include <algorithm>
#include <cassert>
#include <map>

namespace isomotion::formula {
namespace {

class Scheduler {
public:
    explicit Scheduler(const Graph& graph)
        : graph_(graph)
        , registers_(graph.size(), -1) {}

    Program run(std::span<const NodeId> roots, std::uint32_t inside) {
        std::vector<bool> done(graph_.size(), false);
        emit_scope(inside, {roots.begin(), roots.end()}, done);
        for (const NodeId root : roots) program_.outputs.push_back(registers_[root]);
        return std::move(program_);
    }

private:
    // Emits whatever `wanted` needs that can be computed with the arrays of `bound` fixed, in an
    // order where sums of one level (no sum of this scope feeds another) come together.
    void emit_scope(std::uint32_t bound, const std::vector<NodeId>& wanted,
                    std::vector<bool>& done) {
        const std::vector<NodeId> live = reachable(wanted, done);
        std::map<NodeId, int> level_of;
        int deepest = 0;
        for (const NodeId id : live) {
            const Node& node = graph_[id];
            int level = 0;
            for (int k = 0; k < node.arity; ++k) {
                const auto it = level_of.find(node.children[std::size_t(k)]);
                if (it != level_of.end()) level = std::max(level, it->second);
            }
            if (node.op == Op::sum && belongs(node, bound)) ++level;
            level_of[id] = level;
            deepest = std::max(deepest, level);
        }
        for (int level = 0; level <= deepest; ++level) {
            std::map<int, std::vector<NodeId>> sums;
            for (const NodeId id : live) {
                const Node& node = graph_[id];
                if (node.op != Op::sum || !belongs(node, bound) || level_of[id] != level) continue;
                sums[node.index].push_back(id);
            }
            for (const auto& [array, group] : sums) emit_loop(bound, array, group, done);
            for (const NodeId id : live) {
                const Node& node = graph_[id];
                if (node.op == Op::sum || !belongs(node, bound) || level_of[id] != level) continue;
                emit_operation(id);
                done[id] = true;
            }
        }
    }

    void emit_loop(std::uint32_t bound, int array, const std::vector<NodeId>& sums,
                   std::vector<bool>& done) {
        std::vector<NodeId> bodies;
        for (const NodeId id : sums) {
            Instruction zero;
            zero.kind = Instruction::Kind::zero;
            zero.result = registers_[id] = program_.registers++;
            program_.instructions.push_back(zero);
            bodies.push_back(graph_[id].children[0]);
        }
        Instruction begin;
        begin.kind = Instruction::Kind::loop_begin;
        begin.index = array;
        program_.instructions.push_back(begin);
        std::vector<bool> done_inside = done; // what a loop computes is gone after it
        emit_scope(bound | 1u << array, bodies, done_inside);
        for (const NodeId id : sums) {
            Instruction accumulate;
            accumulate.kind = Instruction::Kind::accumulate;
            accumulate.result = registers_[id];
            accumulate.operands[0] = registers_[graph_[id].children[0]];
            program_.instructions.push_back(accumulate);
            done[id] = true;
        }
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

    // Everything not yet done below `wanted`, bodies of sums included, in ascending order.
    std::vector<NodeId> reachable(const std::vector<NodeId>& wanted,
                                  const std::vector<bool>& done) const {
        std::vector<NodeId> stack, found;
        std::vector<bool> seen(graph_.size(), false);
        const auto visit = [&](NodeId id) {
            if (seen[id] || done[id]) return;
            seen[id] = true;
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
            break;
        case Instruction::Kind::zero:
            break;
        }
    }
    return total;
}

} // namespace isomotion::formula
