#include "formula/glsl/glsl.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <map>

#include <fmt/format.h>

#include "formula/glsl/array_texels.h"
#include "formula/glsl/kernel_calls.h"
#include "formula/graph/functions.h"
#include "formula/graph/operations.h"

namespace isomotion::formula {
namespace {

constexpr std::array components{"x", "y", "z", "w"};

class Writer {
public:
    Writer(const Program& program, const GlslSignature& signature, const ArrayPacking& packing)
        : program_(program)
        , signature_(signature)
        , packing_(packing)
        , kernels_(kernel_calls(program))
        , names_(std::size_t(program.registers)) {
        for (const Instruction& now : program.instructions) {
            if (now.op != Op::constant || now.kind != Instruction::Kind::operation) continue;
            names_[std::size_t(now.result)] = glsl_literal(now.value);
        }
    }

    std::string write() {
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
        case Instruction::Kind::begin:
            line("float {} = {};", declare(now.result),
                 now.op == Op::least ? least_of_none(now) : "0.0");
            if (keeps_least(now.op))
                line("float {} = {};", declare(now.operands[2]), least_of_none(now));
            return;
        case Instruction::Kind::loop_begin:
            line("for (int e{0} = 0; e{0} < array{0}_count; ++e{0}) {{", now.index);
            ++indent_;
            for (const int texel : texels_read(program_, at, packing_)) {
                line("vec4 a{0}_{1} = array{0}_texel(e{0}, {1});", now.index, texel);
            }
            return;
        case Instruction::Kind::loop_end:
            --indent_;
            line("}}");
            return;
        case Instruction::Kind::accumulate:
            accumulate(now);
            return;
        case Instruction::Kind::operation:
            break;
        }
        std::string& name = names_[std::size_t(now.result)];
        switch (now.op) { // leaves need no statement: their text stands where they are used
        case Op::constant:
            return;
        case Op::input:
            name = signature_.inputs.at(std::size_t(now.index));
            return;
        case Op::parameter:
            name = glsl_parameter(now.index);
            return;
        case Op::element:
            name = element_text(now.index, now.second, packing_);
            return;
        default:
            break;
        }
        if (const auto result = kernels_.results.find(now.result);
            result != kernels_.results.end()) {
            kernel_result(now.result, result->second);
            return;
        }
        const std::string value = expression(now);
        line("float {} = {};", declare(now.result), value);
    }

    static std::string least_of_none(const Instruction& now) {
        return fmt::format("array{}_least", now.index);
    }

    // Comparisons pass over what is no number, where min() need not.
    void accumulate(const Instruction& now) {
        const std::string result = text_of(now.result);
        if (now.op == Op::sum) return line("{} += {};", result, operand(now, 0));
        const std::string key = operand(now, 0);
        if (now.op == Op::least) return line("{0} = {1} < {0} ? {1} : {0};", result, key);
        const std::string least = text_of(now.operands[2]);
        const std::string value =
            now.op == Op::pick ? operand(now, 1) : fmt::format("float(e{} + 1)", now.index);
        line("{} = {} < {} ? {} : {};", result, key, least, value, result);
        line("{0} = {1} < {0} ? {1} : {0};", least, key);
    }

    std::string expression(const Instruction& now) const {
        const auto a = [&] { return operand(now, 0); };
        const auto b = [&] { return operand(now, 1); };
        switch (now.op) {
        case Op::negate:
            return "-" + a();
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
            assert(unary_traits(now.op) && kernel(now.op).empty());
            return fmt::format("{}({})", name(now.op), a());
        }
    }

    // The first result to come makes the call.
    void kernel_result(Register r, const KernelResult& result) {
        const KernelCall& call = kernels_.calls[std::size_t(result.call)];
        const bool single = call.results == 1;
        auto [name, first] = call_names_.try_emplace(result.call);
        if (first) {
            name->second = fmt::format("{}{}", single ? "v" : "w", r);
            std::string arguments;
            for (const Register argument : call.arguments) {
                arguments += (arguments.empty() ? "" : ", ") + text_of(argument);
            }
            line("{} {} = im_{}({}{});", single ? "float" : "vec2", name->second, call.kernel,
                 arguments, call.numbers);
        }
        names_[std::size_t(r)] = name->second + (single ? "" : result.component == 0 ? ".x" : ".y");
    }

    std::string operand(const Instruction& now, std::size_t k) const {
        return text_of(now.operands[k]);
    }
    std::string text_of(Register r) const {
        const std::string& name = names_[std::size_t(r)];
        return name.front() == '-' ? "(" + name + ")" : name;
    }

    const std::string& declare(Register r) {
        return names_[std::size_t(r)] = fmt::format("v{}", r);
    }

    const Program& program_;
    const GlslSignature& signature_;
    const ArrayPacking& packing_;
    const KernelCalls kernels_;
    std::vector<std::string> names_;
    std::map<int, std::string> call_names_; // what the results of calls made so far are called
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

std::string glsl_double_literal(double value) {
    constexpr double exact_by_any_driver = 1 << 24;
    if (value == std::floor(value) && std::abs(value) < exact_by_any_driver && !std::signbit(value))
        return fmt::format("{}.0lf", value);
    // NVIDIA's compiler rounds decimal fractions to a neighbour of the nearest double.
    const auto bits = std::bit_cast<std::uint64_t>(value);
    return fmt::format("packDouble2x32(uvec2({:#010x}u, {:#010x}u))", std::uint32_t(bits),
                       std::uint32_t(bits >> 32));
}

std::string glsl_least_of_none() {
    return glsl_literal(double(Operations<float>::least_of_none()));
}

std::string glsl_parameter(int index) {
    return fmt::format("parameters[{}].{}", index / 4, components[std::size_t(index % 4)]);
}

} // namespace isomotion::formula
