#include "formula/glsl.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>

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
        find_sine_cosine_pairs();
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
        if (is_paired(now)) {
            // One kernel gives both; the first of the two to come calls it.
            const Register argument = now.operands[0];
            if (called_.insert(argument).second) {
                line("vec2 sc{} = im_sin_cos({});", argument, operand(now, 0));
            }
            name = fmt::format("sc{}.{}", argument, now.op == Op::sin ? "x" : "y");
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
        const std::string& name = names_[std::size_t(now.operands[k])];
        return name.front() == '-' ? "(" + name + ")" : name;
    }

    // The arguments of which both the sine and the cosine are wanted: the slope of one is the
    // other.
    void find_sine_cosine_pairs() {
        std::set<Register> sines, cosines;
        for (const Instruction& now : program_.instructions) {
            if (now.kind != Instruction::Kind::operation) continue;
            if (now.op == Op::sin) sines.insert(now.operands[0]);
            if (now.op == Op::cos) cosines.insert(now.operands[0]);
        }
        std::set_intersection(sines.begin(), sines.end(), cosines.begin(), cosines.end(),
                              std::inserter(paired_, paired_.end()));
    }
    bool is_paired(const Instruction& now) const {
        return (now.op == Op::sin || now.op == Op::cos) && paired_.count(now.operands[0]) > 0;
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
    std::set<Register> paired_, called_;
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
