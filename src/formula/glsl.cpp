#include "formula/glsl.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>

#include <fmt/format.h>

namespace isomotion::formula {
namespace {

constexpr std::array components{"x", "y", "z", "w"};

// The kernel of shaders/math/ an operation calls, or empty for what GLSL does exactly.
std::string_view kernel(Op op) {
    switch (op) {
    case Op::sqrt:
        return "sqrt";
    case Op::exp:
        return "exp";
    case Op::log:
        return "log";
    case Op::sin:
        return "sin";
    case Op::cos:
        return "cos";
    case Op::tan:
        return "tan";
    case Op::sinh:
        return "sinh";
    case Op::cosh:
        return "cosh";
    case Op::tanh:
        return "tanh";
    case Op::asin:
        return "asin";
    case Op::acos:
        return "acos";
    case Op::atan:
        return "atan";
    case Op::divide:
        return "divide";
    case Op::power:
        return "pow";
    default:
        return {};
    }
}

class Writer {
public:
    Writer(const Program& program, const GlslSignature& signature, const ArrayPacking& packing)
        : program_(program)
        , signature_(signature)
        , packing_(packing)
        , names_(std::size_t(program.registers)) {}

    std::string write() {
        find_pairs();
        text_ = signature_.head + " {\n";
        for (std::size_t at = 0; at < program_.instructions.size(); ++at) {
            instruction(program_.instructions[at], at);
        }
        std::string outputs;
        for (const Register r : program_.outputs) {
            outputs += (outputs.empty() ? "" : ", ") + names_[std::size_t(r)];
        }
        line("return {}({});", signature_.result, outputs);
        return text_ + "}\n";
    }

private:
    template<class... Args> void line(fmt::format_string<Args...> format, Args&&... args) {
        text_.append(std::size_t(indent_) * 4, ' ');
        text_ += fmt::format(format, std::forward<Args>(args)...) + "\n";
    }

    void instruction(const Instruction& now, std::size_t at) {
        switch (now.kind) {
        case Instruction::Kind::zero:
            line("float {} = 0.0;", declare(now.result));
            return;
        case Instruction::Kind::loop_begin:
            line("for (int e{0} = 0; e{0} < array{0}_count; ++e{0}) {{", now.index);
            ++indent_;
            for (const int texel : texels_read(now.index, at)) {
                line("vec4 a{0}_{1} = array{0}_texel(e{0}, {1});", now.index, texel);
            }
            return;
        case Instruction::Kind::loop_end:
            --indent_;
            line("}}");
            return;
        case Instruction::Kind::accumulate:
            line("{} += {};", names_[std::size_t(now.result)], operand(now, 0));
            return;
        case Instruction::Kind::operation:
            break;
        }
        std::string& name = names_[std::size_t(now.result)];
        switch (now.op) { // leaves need no statement: their text stands where they are used
        case Op::constant:
            name = glsl_literal(now.value);
            return;
        case Op::input:
            name = signature_.inputs.at(std::size_t(now.index));
            return;
        case Op::parameter:
            name = glsl_parameter(now.index);
            return;
        case Op::element: {
            const int slot = slot_of(now.index, now.second);
            name = fmt::format("a{}_{}.{}", now.index, slot / 4, components[std::size_t(slot % 4)]);
            return;
        }
        default:
            break;
        }
        if (const auto pair = pairs_.find(now.result); pair != pairs_.end()) {
            const auto& [call, component] = pair->second;
            // The first of the two to come makes the call.
            const auto [known, first] = calls_.try_emplace(call, fmt::format("w{}", now.result));
            if (first) {
                line("vec2 {} = {};", known->second,
                     call.sine_cosine ? fmt::format("im_sin_cos({})", text_of(call.a))
                                      : fmt::format("im_pow_and_lower({}, {})", text_of(call.a),
                                                    exponent(call.b)));
            }
            name = known->second + component;
            return;
        }
        const std::string value = expression(now);
        line("float {} = {};", declare(now.result), value);
    }

    std::string expression(const Instruction& now) const {
        const auto a = [&] { return operand(now, 0); };
        const auto b = [&] { return operand(now, 1); };
        switch (now.op) {
        case Op::negate:
            return "-" + a();
        case Op::abs:
            return fmt::format("abs({})", a());
        case Op::sign:
            return fmt::format("sign({})", a());
        case Op::floor:
            return fmt::format("floor({})", a());
        case Op::add:
            return fmt::format("{} + {}", a(), b());
        case Op::subtract:
            return fmt::format("{} - {}", a(), b());
        case Op::multiply:
            return fmt::format("{} * {}", a(), b());
        case Op::min:
            return fmt::format("min({}, {})", a(), b());
        case Op::max:
            return fmt::format("max({}, {})", a(), b());
        case Op::select:
            return fmt::format("{} < {} ? {} : {}", a(), b(), operand(now, 2), operand(now, 3));
        default:
            break;
        }
        const std::string_view function = kernel(now.op);
        assert(!function.empty());
        return now.arity == 1 ? fmt::format("im_{}({})", function, a())
                              : fmt::format("im_{}({}, {})", function, a(), b());
    }

    std::string operand(const Instruction& now, std::size_t k) const {
        return text_of(now.operands[k]);
    }
    std::string text_of(Register r) const {
        const std::string& name = names_[std::size_t(r)];
        return name.front() == '-' ? "(" + name + ")" : name;
    }

    // Values whose slope is a sibling: the sine and the cosine of a, a^b and a^(b-1). One kernel
    // gives both for little more than one.
    struct PairCall {
        bool sine_cosine;
        Register a, b;
        auto operator<=>(const PairCall&) const = default;
    };

    void find_pairs() {
        std::map<PairCall, Register> sines, cosines, powers;
        for (const Instruction& now : program_.instructions) {
            if (now.kind != Instruction::Kind::operation) continue;
            definitions_[now.result] = &now;
            const Register a = now.operands[0];
            if (now.op == Op::sin) sines[{true, a, -1}] = now.result;
            if (now.op == Op::cos) cosines[{true, a, -1}] = now.result;
            if (now.op == Op::power) powers[{false, a, now.operands[1]}] = now.result;
        }
        for (const auto& [call, sine] : sines) {
            const auto cosine = cosines.find(call);
            if (cosine == cosines.end()) continue;
            pairs_[sine] = {call, ".x"};
            pairs_[cosine->second] = {call, ".y"};
        }
        for (const auto& [upper, result] : powers) {
            for (auto lower = powers.lower_bound({false, upper.a, -1});
                 lower != powers.end() && lower->first.a == upper.a; ++lower) {
                if (!is_one_less(lower->first.b, upper.b)) {
                    continue;
                }
                if (pairs_.count(result) > 0 || pairs_.count(lower->second) > 0) continue;
                pairs_[result] = {upper, ".x"};
                pairs_[lower->second] = {upper, ".y"};
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

    // a^2.5 may be asked for, by its sibling a^1.5, before the literal 2.5 had its turn.
    std::string exponent(Register r) const {
        const Instruction& definition = *definitions_.at(r);
        return definition.op == Op::constant ? glsl_literal(definition.value) : text_of(r);
    }

    const std::string& declare(Register r) {
        return names_[std::size_t(r)] = fmt::format("v{}", r);
    }

    int slot_of(int array, int field) const {
        const auto& fields = packing_.at(std::size_t(array));
        const auto it = std::find(fields.begin(), fields.end(), field);
        assert(it != fields.end());
        return int(it - fields.begin());
    }

    // The texels of array `array` that the loop beginning at instruction `at` uses, inner loops
    // over other arrays included.
    std::set<int> texels_read(int array, std::size_t at) const {
        std::set<int> texels;
        int depth = 0;
        for (; at < program_.instructions.size(); ++at) {
            const Instruction& now = program_.instructions[at];
            if (now.kind == Instruction::Kind::loop_begin) ++depth;
            if (now.kind == Instruction::Kind::loop_end && --depth == 0) break;
            if (now.kind == Instruction::Kind::operation && now.op == Op::element &&
                now.index == array) {
                texels.insert(slot_of(array, now.second) / 4);
            }
        }
        return texels;
    }

    const Program& program_;
    const GlslSignature& signature_;
    const ArrayPacking& packing_;
    std::vector<std::string> names_;
    std::map<Register, const Instruction*> definitions_;
    std::map<Register, std::pair<PairCall, const char*>> pairs_; // by result: call and component
    std::map<PairCall, std::string> calls_;                      // made so far, and their names
    std::string text_;
    int indent_ = 1;
};

} // namespace

std::string emit_glsl(const Program& program, const GlslSignature& signature,
                      const ArrayPacking& packing) {
    return Writer(program, signature, packing).write();
}

std::string glsl_literal(double value) {
    // GLSL has no literal for these; the formula that folds to one is refused by the parser, so
    // only saturation remains.
    const auto narrow = float(std::clamp(value, -3.4028234e38, 3.4028234e38));
    std::string text = fmt::format("{}", narrow);
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text;
}

std::string glsl_parameter(int index) {
    return fmt::format("parameters[{}].{}", index / 4, components[std::size_t(index % 4)]);
}

std::set<std::string> kernels_used(const Program& program) {
    std::set<std::string> kernels;
    for (const Instruction& now : program.instructions) {
        if (now.kind != Instruction::Kind::operation) continue;
        if (const std::string_view k = kernel(now.op); !k.empty()) kernels.emplace(k);
    }
    return kernels;
}

} // namespace isomotion::formula
