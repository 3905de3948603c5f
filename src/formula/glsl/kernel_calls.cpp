#include "formula/glsl/kernel_calls.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "formula/graph/functions.h"

namespace isomotion::formula {
namespace {

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
            add_call({name,
                      {now.operands.begin(), now.operands.begin() + now.arity},
                      1,
                      now.op == Op::noise ? glsl_noise_order(now) : std::string()},
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
        for (const auto& [a, of_base] : powers) add_power_pairs(a, of_base);
    }

    // `of_base`: results by exponent.
    void add_power_pairs(Register a, const std::map<Register, Register>& of_base) {
        std::map<double, Register> constants; // exponents by value
        std::map<Register, Register> below;   // exponents that are another minus 1, by that other
        for (const auto& [exponent, result] : of_base) {
            const Instruction* of = definition(exponent);
            if (!of) continue;
            if (of->op == Op::constant) constants[of->value] = exponent;
            if (of->op == Op::subtract && is_one(of->operands[1])) {
                below[of->operands[0]] = exponent;
            }
        }
        for (const auto& [exponent, upper] : of_base) {
            const Instruction* of = definition(exponent);
            const bool is_constant = of && of->op == Op::constant;
            const auto constant = is_constant ? constants.find(of->value - 1) : constants.end();
            const auto moving = below.find(exponent);
            if (constant == constants.end() && moving == below.end()) continue;
            const Register lower =
                of_base.at(constant != constants.end() ? constant->second : moving->second);
            if (lower == upper) continue; // 1e300 - 1 is 1e300
            if (plan_.results.count(upper) > 0 || plan_.results.count(lower) > 0) continue;
            add_call({"pow_and_lower", {a, exponent}, 2}, {upper, lower});
        }
    }

    // Null for sums, which loops add up.
    const Instruction* definition(Register r) const {
        const auto it = definitions_.find(r);
        return it == definitions_.end() ? nullptr : it->second;
    }
    bool is_one(Register r) const {
        const Instruction* of = definition(r);
        return of && of->op == Op::constant && of->value == 1;
    }

    const Program& program_;
    std::map<Register, const Instruction*> definitions_;
    KernelCalls plan_;
};

} // namespace

std::string glsl_noise_order(const Instruction& noise) {
    const NoiseOrder order = NoiseOrder::unpacked(noise.index);
    return fmt::format(", ivec3({})", fmt::join(order.along, ", "));
}

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
