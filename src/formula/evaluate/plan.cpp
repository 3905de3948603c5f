#include "formula/evaluate/plan.h"

#include <algorithm>
#include <utility>

#include "formula/graph/functions.h"

namespace isomotion::formula {
namespace {

using Kind = Instruction::Kind;

std::span<const Register> operands(const Instruction& instruction) {
    return std::span(instruction.operands).first(instruction.arity);
}

bool is_input(const Instruction& instruction) {
    return instruction.kind == Kind::operation && instruction.op == Op::input;
}

// Where the value of each register is last asked for: at its own instruction, if nowhere.
class LastUses {
public:
    explicit LastUses(const Program& program)
        : defined_(std::size_t(program.registers), 0)
        , last_(std::size_t(program.registers), 0) {
        const auto& code = program.instructions;
        std::vector<std::size_t> ends(code.size()); // of the loop that begins here
        std::vector<std::size_t> open;
        for (std::size_t at = 0; at < code.size(); ++at) {
            if (code[at].kind == Kind::loop_begin) open.push_back(at);
            if (code[at].kind != Kind::loop_end) continue;
            ends[open.back()] = at;
            open.pop_back();
        }
        // A loop asks again, in its next round, for what was computed before it.
        const auto use = [&](Register r, std::size_t at) {
            std::size_t until = at;
            for (const std::size_t begin : open) {
                if (begin < defined_[std::size_t(r)]) continue;
                until = ends[begin];
                break;
            }
            last_[std::size_t(r)] = std::max(last_[std::size_t(r)], until);
        };
        for (std::size_t at = 0; at < code.size(); ++at) {
            const Instruction& now = code[at];
            if (now.kind == Kind::loop_begin) open.push_back(at);
            if (now.kind == Kind::loop_end) open.pop_back();
            if (now.kind == Kind::operation || now.kind == Kind::begin) {
                define(now.result, at);
                if (now.kind == Kind::begin && keeps_least(now.op)) define(now.operands[2], at);
            }
            if (now.kind == Kind::operation || now.kind == Kind::accumulate) {
                for (const Register r : operands(now)) use(r, at);
            }
            if (now.kind == Kind::accumulate) {
                use(now.result, at);
                if (keeps_least(now.op)) use(now.operands[2], at);
            }
        }
        for (const Register r : program.outputs) last_[std::size_t(r)] = code.size();
    }

    std::size_t operator[](Register r) const { return last_[std::size_t(r)]; }

private:
    void define(Register r, std::size_t at) {
        defined_[std::size_t(r)] = last_[std::size_t(r)] = at;
    }

    std::vector<std::size_t> defined_, last_;
};

// What is known of the value in each register of the program, whatever the inputs are.
class KnownValues {
public:
    explicit KnownValues(const Program& program)
        : is_uniform_(std::size_t(program.registers), 0)
        , is_not_negative_(std::size_t(program.registers), 0)
        , is_positive_number_(std::size_t(program.registers), 0) {}

    void learn(const Instruction& now) {
        const auto r = std::size_t(now.result);
        if (now.kind == Kind::begin) return;
        is_uniform_[r] = !is_input(now) && std::ranges::all_of(operands(now), [&](Register of) {
            return is_uniform(of);
        });
        is_not_negative_[r] = tell_not_negative(now);
        is_positive_number_[r] =
            now.kind == Kind::operation && now.op == Op::constant && now.value > 0;
    }

    bool is_uniform(Register r) const { return is_uniform_[std::size_t(r)] != 0; }
    // Enclosures begin at 0 at least.
    bool is_not_negative(Register r) const { return is_not_negative_[std::size_t(r)] != 0; }

private:
    bool tell_not_negative(const Instruction& now) const {
        const auto operand = [&](std::size_t k) { return is_not_negative(now.operands[k]); };
        if (now.kind == Kind::accumulate) return now.op == Op::sum && operand(0);
        switch (now.op) {
        case Op::constant:
            return now.value >= 0;
        case Op::multiply:
            if (now.operands[0] == now.operands[1]) return true;
            break;
        case Op::divide: // 0/0 is the entire line
            return is_positive_number_[std::size_t(now.operands[0])] != 0 && operand(1);
        case Op::select:
            return operand(2) && operand(3);
        default:
            break;
        }
        const Traits* row = traits(now.op);
        return row && row->is_never_negative(operand);
    }

    std::vector<char> is_uniform_, is_not_negative_, is_positive_number_;
};

Product product(Step& step, const KnownValues& known) {
    Register &a = step.operands[0], &b = step.operands[1];
    if (a == b) return Product::square;
    if (known.is_uniform(a)) std::swap(a, b);
    if (known.is_uniform(b)) return Product::by_uniform;
    if (known.is_not_negative(a)) std::swap(a, b);
    if (!known.is_not_negative(b)) return Product::any;
    return known.is_not_negative(a) ? Product::of_not_negative : Product::by_not_negative;
}

// Gives values registers, each as long as it is asked for.
class Allotment {
public:
    explicit Allotment(std::size_t values)
        : place_of_(values, -1) {}

    void put(Register value) {
        if (free_.empty()) free_.push_back(count_++);
        place_of_[std::size_t(value)] = free_.back();
        free_.pop_back();
    }
    void leave(Register value) { free_.push_back(place_of_[std::size_t(value)]); }
    void share(Register value, Register with) {
        place_of_[std::size_t(value)] = place_of_[std::size_t(with)];
    }

    Register of(Register value) const { return place_of_[std::size_t(value)]; }
    int count() const { return count_; }

private:
    std::vector<Register> place_of_, free_;
    int count_ = 0;
};

} // namespace

Plan plan(const Program& program, bool enclosures) {
    Plan made;
    const LastUses last_uses(program);
    KnownValues known(program);
    Allotment places(std::size_t(program.registers));
    std::vector<std::vector<Register>> leaving(program.instructions.size() + 1);
    const auto put = [&](Register value) {
        places.put(value);
        leaving[last_uses[value]].push_back(value);
    };
    std::vector<Register> input_values; // the value that each input was first read as
    // Inputs are there from the beginning to the end.
    for (const Instruction& now : program.instructions) {
        if (!is_input(now)) continue;
        const auto index = std::size_t(now.index);
        if (index >= input_values.size()) input_values.resize(index + 1, -1);
        if (input_values[index] < 0) {
            input_values[index] = now.result;
            places.put(now.result);
        } else {
            places.share(now.result, input_values[index]);
        }
    }
    for (const Register value : input_values)
        made.inputs.push_back(value < 0 ? -1 : places.of(value));

    std::size_t depth = 0;
    for (std::size_t at = 0; at < program.instructions.size(); ++at) {
        Step step{program.instructions[at]};
        const bool has_result = step.kind != Kind::loop_begin && step.kind != Kind::loop_end;
        if (step.kind == Kind::loop_begin) made.deepest = std::max(made.deepest, ++depth);
        if (step.kind == Kind::loop_end) --depth;
        if (has_result) known.learn(step);
        if (!is_input(step)) {
            // Results don't take the place of operands, which loops over lanes may read later.
            if (step.kind == Kind::operation || step.kind == Kind::begin) put(step.result);
            if (step.kind == Kind::begin && keeps_least(step.op)) put(step.operands[2]);
            if (step.kind == Kind::operation) {
                step.is_uniform = known.is_uniform(step.result);
                if (enclosures && step.op == Op::multiply) step.product = product(step, known);
            }
            const std::size_t read = step.kind == Kind::begin ? 0 : step.arity;
            for (std::size_t k = 0; k < read; ++k) step.operands[k] = places.of(step.operands[k]);
            // Nobody reads the others, and everybody computes where they are.
            for (std::size_t k = read; k < 2; ++k) step.operands[k] = 0;
            if (has_result && step.kind != Kind::operation && keeps_least(step.op))
                step.operands[2] = places.of(step.operands[2]);
            if (has_result) step.result = places.of(step.result);
            made.steps.push_back(step);
        }
        for (const Register value : leaving[at]) places.leave(value);
    }
    made.registers = places.count();
    for (const Register value : program.outputs) made.outputs.push_back(places.of(value));
    return made;
}

} // namespace isomotion::formula
