#include "formula/kernel_calls.h"

namespace isomotion::formula {
namespace {

// The kernel an operation calls, or empty for what GLSL does exactly.
std::string_view kernel(Op op) {
    switch (op) {
    case Op::sqrt:
    case Op::exp:
    case Op::log:
    case Op::sin:
    case Op::cos:
    case Op::tan:
    case Op::sinh:
    case Op::cosh:
    case Op::tanh:
    case Op::asin:
    case Op::acos:
    case Op::atan:
    case Op::divide:
        return name(op);
    case Op::power:
        return "pow";
    default:
        return {};
    }
}

bool is_operation(const Instruction& instruction) {
    return instruction.kind == Instruction::Kind::operation;
}

class Planner {
public:
    explicit Planner(const Program& program)
        : program_(program) {
        for (const Instruction& now : program_.instructions) {
            if (is_operation(now)) definitions_[now.result] = &now;
        }
    }

    KernelCalls plan() {
        find_pairs();
        for (const Instruction& now : program_.instructions) {
            if (!is_operation(now) || plan_.results.count(now.result) > 0) continue;
            const std::string_view name = kernel(now.op);
            if (name.empty()) continue;
            add_call({name, {now.operands.begin(), now.operands.begin() + now.arity}, 1},
                     {now.result});
        }
        return std::move(plan_);
    }

private:
    void add_call(KernelCall call, const std::vector<Register>& results) {
        for (std::size_t k = 0; k < results.size(); ++k) {
            plan_.results[results[k]] = {int(plan_.calls.size()), int(k)};
        }
        plan_.calls.push_back(std::move(call));
    }

    void find_pairs() {
        std::map<Register, Register> sines, cosines;             // argument -> result
        std::map<Register, std::map<Register, Register>> powers; // base -> exponent -> result
        for (const Instruction& now : program_.instructions) {
            if (!is_operation(now)) continue;
            const Register a = now.operands[0];
            if (now.op == Op::sin) sines[a] = now.result;
            if (now.op == Op::cos) cosines[a] = now.result;
            if (now.op == Op::power) powers[a][now.operands[1]] = now.result;
        }
        for (const auto& [a, sine] : sines) {
            const auto cosine = cosines.find(a);
            if (cosine != cosines.end()) add_call({"sin_cos", {a}, 2}, {sine, cosine->second});
        }
        for (const auto& [a, of_base] : powers) {
            for (const auto& [b, upper] : of_base) {
                for (const auto& [c, lower] : of_base) {
                    if (!is_one_less(c, b)) continue;
                    if (plan_.results.count(upper) > 0 || plan_.results.count(lower) > 0) continue;
                    add_call({"pow_and_lower", {a, b}, 2}, {upper, lower});
                }
            }
        }
    }

    // Whether register `lower` is register `upper` minus 1.
    bool is_one_less(Register lower, Register upper) const {
        const Instruction& of_lower = *definitions_.at(lower);
        const Instruction& of_upper = *definitions_.at(upper);
        if (of_lower.op == Op::constant && of_upper.op == Op::constant) {
            return of_lower.value == of_upper.value - 1;
        }
        if (of_lower.op != Op::subtract || of_lower.operands[0] != upper) return false;
        const Instruction& subtrahend = *definitions_.at(of_lower.operands[1]);
        return subtrahend.op == Op::constant && subtrahend.value == 1;
    }

    const Program& program_;
    std::map<Register, const Instruction*> definitions_;
    KernelCalls plan_;
};

} // namespace

KernelCalls kernel_calls(const Program& program) { return Planner(program).plan(); }

std::set<std::string> kernels_used(const Program& program) {
    std::set<std::string> kernels;
    for (const Instruction& now : program.instructions) {
        if (!is_operation(now)) continue;
        if (const std::string_view name = kernel(now.op); !name.empty()) kernels.emplace(name);
    }
    return kernels;
}

} // namespace isomotion::formula
