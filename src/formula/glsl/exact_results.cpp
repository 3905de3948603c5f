#include "formula/glsl/exact_results.h"

#include "formula/graph/functions.h"

namespace isomotion::formula {
namespace {

bool is_choice(Op op) { return op == Op::min || op == Op::max || op == Op::select; }

// Registers that what jumps comes from, by arithmetic and operations without rounding.
std::vector<bool> what_decides_jumps(const Program& program) {
    std::vector<bool> decides(std::size_t(program.registers), false);
    for (auto now = program.instructions.rbegin(); now != program.instructions.rend(); ++now) {
        if (now->kind != Instruction::Kind::operation) continue;
        const bool passes_numbers = is_arithmetic(now->op) || is_choice(now->op) ||
                                    now->op == Op::negate || now->op == Op::abs;
        if (!has_steps(now->op) && !(passes_numbers && decides[std::size_t(now->result)])) continue;
        for (std::size_t k = 0; k < now->arity; ++k) decides[std::size_t(now->operands[k])] = true;
    }
    return decides;
}

enum class Stays { never, over_some_boxes, always };

Stays stays(const Instruction& now, const std::vector<Stays>& known) {
    const auto of = [&](std::size_t k) { return known[std::size_t(now.operands[k])]; };
    const auto any = [&](std::size_t from) {
        for (std::size_t k = from; k < now.arity; ++k) {
            if (of(k) != Stays::never) return Stays::over_some_boxes;
        }
        return Stays::never;
    };
    if (now.op == Op::constant || now.op == Op::parameter || now.op == Op::element)
        return Stays::always;
    if (has_steps(now.op)) return Stays::over_some_boxes;
    if (now.op == Op::select) return any(2);
    if (is_choice(now.op)) return any(0);
    if (now.op == Op::negate || now.op == Op::abs) return of(0);
    if (!is_arithmetic(now.op)) return Stays::never;
    const bool is_by_0 = now.op == Op::multiply && // over some boxes
                         (of(0) == Stays::over_some_boxes || of(1) == Stays::over_some_boxes);
    const bool both = of(0) != Stays::never && of(1) != Stays::never;
    return is_by_0 || both ? Stays::over_some_boxes : Stays::never;
}

} // namespace

std::vector<bool> exact_results(const Program& program) {
    const std::vector<bool> decides = what_decides_jumps(program);
    std::vector<Stays> known(std::size_t(program.registers), Stays::never);
    std::vector<bool> exact(std::size_t(program.registers), false);
    for (const Instruction& now : program.instructions) {
        if (now.kind != Instruction::Kind::operation) continue;
        const auto result = std::size_t(now.result);
        known[result] = stays(now, known);
        exact[result] = is_arithmetic(now.op) && decides[result] && known[result] != Stays::never;
    }
    return exact;
}

} // namespace isomotion::formula
