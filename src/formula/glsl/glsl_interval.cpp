#include "formula/glsl/glsl_interval.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <regex>

#include <fmt/format.h>

#include "formula/glsl/array_texels.h"
#include "formula/glsl/exact_results.h"
#include "formula/glsl/kernel_calls.h"
#include "formula/graph/functions.h"
#include "formula/graph/lowering.h"
#include "formula/interval/noise_enclosure.h"

namespace isomotion::formula {
namespace {

// What is known of a register's values when the text is written.
struct Known {
    std::string text;
    bool point = false;        // `text` is a number, else an interval
    bool not_negative = false; // then no lower end is below 0 either
    bool positive_constant = false;
    // Whether it may be exactly 0 over some boxes, by a comparison: the slope of max(1, x) where x
    // is less. It is to stay 0 until it meets a factor without bounds, such as the slope of a root
    // at 0.
    bool may_rest = false;
    bool may_be_subnormal = false; // a number that is given, which drivers may take for 0
};

using Floats = std::numeric_limits<float>;
using Doubles = std::numeric_limits<double>;

std::string float_text(float value) { return glsl_literal(double(value)); }

// "dvec2" for "vec2".
std::string on_doubles(const std::string& glsl) {
    return std::regex_replace(glsl, std::regex(R"(\bvec(?=[24]\b))"), "dvec");
}

// A constant in doubles: the number itself, or an interval around one that is infinite or too
// small. NaN gives the entire line.
Known constant_on_doubles(double value) {
    Known known;
    known.not_negative = value >= 0;
    known.positive_constant = value > 0;
    known.may_rest = value == 0;
    const double size = std::abs(value);
    if (std::isnan(value)) {
        known.text = "IM_ENTIRE";
    } else if (std::isinf(value)) {
        known.text =
            value > 0 ? "dvec2(IM_LARGEST, IM_INFINITY)" : "dvec2(-IM_INFINITY, -IM_LARGEST)";
    } else if (size > 0 && size < Doubles::min()) {
        known.text = value > 0 ? "dvec2(0.0, IM_SMALLEST)" : "dvec2(-IM_SMALLEST, 0.0)";
        known.positive_constant = false;
    } else {
        known.text = glsl_double_literal(value);
        known.point = true;
    }
    return known;
}

// The floats around a number.
Known constant(double value) {
    Known known;
    known.not_negative = value >= 0;
    known.positive_constant = value > 0;
    known.may_rest = value == 0;
    const double size = std::abs(value);
    if (std::isnan(value)) {
        known.text = "IM_ENTIRE";
    } else if (size > double(Floats::max())) {
        known.text =
            value > 0 ? "vec2(IM_LARGEST, IM_INFINITY)" : "vec2(-IM_INFINITY, -IM_LARGEST)";
    } else if (size > 0 && size < double(Floats::min())) { // drivers may take it for 0
        known.text = value > 0 ? "vec2(0.0, IM_SMALLEST)" : "vec2(-IM_SMALLEST, 0.0)";
        known.positive_constant = false;
    } else if (const auto near = float(value); double(near) == value) {
        known.text = float_text(near);
        known.point = true;
    } else {
        const float other = std::nextafter(near, double(near) < value ? HUGE_VALF : -HUGE_VALF);
        known.text = fmt::format("vec2({}, {})", float_text(std::min(near, other)),
                                 float_text(std::max(near, other)));
    }
    return known;
}

// The function of shaders/interval/ an operation calls, or empty for what arithmetic.glsl has or
// GLSL does exactly.
std::string_view interval_kernel(Op op) { return op == Op::chebyshev ? name(op) : kernel(op); }

// T_n^(k)(1), rounded up.
float rounded_chebyshev_at_one(int n, int k) {
    double product = 1;
    for (int j = 0; j < k; ++j) product *= (double(n) * n - double(j) * j) / (2.0 * j + 1);
    return float(std::min(product * 1.000001, double(Floats::max())));
}

class IntervalWriter {
public:
    IntervalWriter(const Program& program, const IntervalSignature& signature,
                   const ArrayPacking& packing, const IntervalNumbers& numbers)
        : program_(program)
        , signature_(signature)
        , packing_(packing)
        , doubles_(numbers.numbers == Numbers::doubles)
        , listed_(numbers.listed)
        , type_(doubles_ ? "dvec2" : "vec2")
        , known_(std::size_t(program.registers))
        , is_exact_(exact_results(program)) {}

    std::string write() {
        text_ = (doubles_ ? on_doubles(signature_.head) : signature_.head) + " {\n";
        for (std::size_t at = 0; at < program_.instructions.size(); ++at) {
            instruction(program_.instructions[at], at);
        }
        std::string outputs;
        for (std::size_t o = 0; o < program_.outputs.size(); ++o) {
            const std::string output = interval(program_.outputs[o]);
            if (signature_.result.empty()) line("{} = {};", signature_.outputs.at(o), output);
            outputs += (o == 0 ? "" : ", ") + output;
        }
        if (!signature_.result.empty())
            line("return {}{}({});", doubles_ ? "d" : "", signature_.result, outputs);
        return text_ + "}\n";
    }

private:
    template<class... Args> void line(fmt::format_string<Args...> format, Args&&... args) {
        text_.append(std::size_t(indent_) * 4, ' ');
        text_ += fmt::format(format, std::forward<Args>(args)...) + "\n";
    }

    // A result that is a number where shaders/interval/exact.glsl can tell.
    std::string kept_exact(const Instruction& now, const std::string& value) const {
        const auto is_given = [&](std::size_t k) { // drivers may take it for 0
            return known_[std::size_t(now.operands[k])].may_be_subnormal;
        };
        if (!is_exact_[std::size_t(now.result)] || is_given(0) || is_given(1)) return value;
        const std::string a = interval(now.operands[0]), b = interval(now.operands[1]);
        switch (now.op) {
        case Op::add:
            return fmt::format("im_exact_sum({}, {}, {})", a, b, value);
        case Op::subtract:
            return fmt::format("im_exact_sum({}, -{}.yx, {})", a, b, value);
        case Op::multiply:
            return fmt::format("im_exact_product({}, {}, {})", a, b, value);
        default:
            return fmt::format("im_exact_quotient({}, {}, {})", a, b, value);
        }
    }

    void instruction(const Instruction& now, std::size_t at) {
        switch (now.kind) {
        case Instruction::Kind::begin:
            begin(now);
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
        switch (now.op) { // leaves need no statement: their text stands where they are used
        case Op::constant:
            known(now.result) = doubles_ ? constant_on_doubles(now.value) : constant(now.value);
            return;
        case Op::input:
            known(now.result).text = signature_.inputs.at(std::size_t(now.index));
            return;
        case Op::parameter:
            known(now.result) = {glsl_parameter(now.index), true};
            known(now.result).may_be_subnormal = true;
            return;
        case Op::element:
            known(now.result) = {element_text(now.index, now.second, packing_), true};
            known(now.result).may_be_subnormal = true;
            return;
        default:
            operation(now);
            known(now.result).may_be_subnormal = keeps_subnormals(now);
        }
    }

    // What rounds gives 0 or a normal number.
    bool keeps_subnormals(const Instruction& now) const {
        const bool is_select = now.op == Op::select;
        const bool is_exact = is_select || now.op == Op::negate || now.op == Op::abs ||
                              now.op == Op::min || now.op == Op::max;
        for (std::size_t k = is_select ? 2 : 0; is_exact && k < std::size_t(now.arity); ++k)
            if (known_[std::size_t(now.operands[k])].may_be_subnormal) return true;
        return false;
    }

    bool is_listed(const Instruction& now) const { return listed_ && listed_->array == now.index; }

    std::string least_of_none(const Instruction& now) const {
        // That of all elements is put in its place, where it is more than this.
        if (is_listed(now)) return fmt::format("{}(array{}_least)", type_, now.index);
        return fmt::format("{}(array{}_least, IM_INFINITY)", type_, now.index);
    }

    void begin(const Instruction& now) {
        if (keeps_least(now.op)) define(now.operands[2], least_of_none(now), true);
        if (now.op == Op::least) {
            define(now.result, least_of_none(now), true);
            known(now.result).may_be_subnormal = is_listed(now);
            return;
        }
        if (now.op == Op::sum && is_listed(now)) {
            const auto own = std::ranges::find(listed_->sums, NodeId(now.second));
            if (own != listed_->sums.end()) {
                const auto which = own - listed_->sums.begin();
                define(now.result, fmt::format("{}(array{}_rest[{}])", type_, now.index, which),
                       false);
                known(now.result).may_be_subnormal = true;
                return;
            }
        }
        define(now.result, fmt::format("{}(0.0)", type_), true);
    }

    void accumulate(const Instruction& now) {
        Known& result = known(now.result);
        const Register key = now.operands[0];
        if (now.op == Op::sum) {
            result.not_negative = result.not_negative && known(key).not_negative;
            line("{} = {};", result.text,
                 limited(fmt::format("im_add({}, {})", result.text, interval(key)),
                         result.not_negative));
        } else if (now.op == Op::least) {
            result.not_negative = known(key).not_negative;
            result.may_be_subnormal = result.may_be_subnormal || known(key).may_be_subnormal;
            line("{0} = min({0}, {1});", result.text, interval(key));
        } else {
            const std::string& least = known(now.operands[2]).text;
            const bool picks = now.op == Op::pick;
            result.not_negative = !picks || known(now.operands[1]).not_negative;
            result.may_be_subnormal = picks && known(now.operands[1]).may_be_subnormal;
            const std::string value =
                picks ? interval(now.operands[1]) : fmt::format("{}(e{} + 1)", type_, now.index);
            line("{0} = im_select({1}, {2}, {3}, {0});", result.text, interval(key), least, value);
            line("{0} = min({0}, {1});", least, interval(key));
        }
    }

    void operation(const Instruction& now) {
        const Register a = now.operands[0], b = now.operands[1];
        const bool a_positive = known(a).not_negative;
        const bool b_positive = now.arity > 1 && known(b).not_negative;
        switch (now.op) {
        case Op::negate:
            if (known(a).point) {
                known(now.result) = {fmt::format("(-{})", known(a).text), true};
            } else {
                define(now.result, fmt::format("-{}.yx", known(a).text), false);
                known(now.result).may_rest = known(a).may_rest;
            }
            return;
        case Op::add: {
            const bool positive = a_positive && b_positive;
            return add(now, limited(call("im_add", a, b), positive), positive);
        }
        case Op::subtract:
            return add(now, call("im_subtract", a, b), false);
        case Op::multiply:
            return multiply(now);
        case Op::divide:
            // 0/0 would be the entire line.
            return define(now.result, kept_exact(now, call("im_divide", a, b)),
                          known(a).positive_constant && b_positive);
        case Op::power: {
            const std::string exponent = known(b).point ? known(b).text : interval(b);
            return define(now.result, fmt::format("im_pow({}, {})", interval(a), exponent),
                          a_positive);
        }
        case Op::select: {
            const Register then = now.operands[2], otherwise = now.operands[3];
            define(now.result,
                   fmt::format("im_select({}, {}, {}, {})", interval(a), interval(b),
                               interval(then), interval(otherwise)),
                   known(then).not_negative && known(otherwise).not_negative);
            known(now.result).may_rest =
                (known(then).may_rest && !known(otherwise).may_be_subnormal) ||
                (known(otherwise).may_rest && !known(then).may_be_subnormal);
            return;
        }
        case Op::noise:
            return define(
                now.result,
                fmt::format("im_noise({}, {}, {}{}, {})", interval(a), interval(b),
                            interval(now.operands[2]), glsl_noise_order(now),
                            float_text(float(noise_bound(NoiseOrder::unpacked(now.index))))),
                false);
        case Op::chebyshev:
            if (now.second >= 2) {
                const auto bound = float_text(rounded_chebyshev_at_one(now.index, now.second));
                return define(now.result,
                              fmt::format("im_chebyshev_steep({}, {})", bound, interval(a)), false);
            }
            if (now.second == 0 && now.index > highest_whole_degree) {
                const double reach = chebyshev_reach(now.index);
                const double stop = std::cosh(now.index * std::acosh(reach));
                return define(now.result,
                              fmt::format("im_chebyshev_stopped({}, {}, {}, {})", now.index,
                                          float_text(float(reach)), float_text(float(stop)),
                                          interval(a)),
                              false);
            }
            return define(now.result,
                          fmt::format("im_chebyshev{}({}, {})", now.second == 0 ? "" : "_slope",
                                      now.index, interval(a)),
                          false);
        default: {
            const Traits& row = *traits(now.op);
            const bool positive =
                row.is_never_negative([&](int k) { return k == 0 ? a_positive : b_positive; });
            const std::string function =
                fmt::format("{}{}", row.shader == Shader::built_in ? "" : "im_", name(now.op));
            return define(now.result, now.arity == 1 ? call(function, a) : call(function, a, b),
                          positive);
        }
        }
    }

    void add(const Instruction& now, std::string value, bool positive) {
        const Register result = now.result, a = now.operands[0], b = now.operands[1];
        value = kept_exact(now, value);
        const bool may_rest = known(a).may_rest && known(b).may_rest;
        if (may_rest) {
            value =
                fmt::format("im_unless_zero(im_hull({}, {}), {})", interval(a), interval(b), value);
        }
        define(result, value, positive);
        known(result).may_rest = may_rest;
    }

    void multiply(const Instruction& now) {
        const Register result = now.result;
        Register a = now.operands[0], b = now.operands[1];
        if (a == b) return define(result, kept_exact(now, call("im_square", a)), true);
        if (known(b).point) std::swap(a, b);
        if (!known(b).not_negative && !known(a).point) std::swap(a, b);
        const bool positive = known(a).not_negative && known(b).not_negative;
        std::string value;
        if (known(a).point) {
            const bool up = known(a).positive_constant;
            value = limited(fmt::format("{}({}, {})", up ? "im_scale_up" : "im_scale",
                                        known(a).text, interval(b)),
                            positive);
        } else {
            value = call(positive                ? "im_multiply_not_negative"
                         : known(b).not_negative ? "im_multiply_by_not_negative"
                                                 : "im_multiply",
                         a, b);
        }
        value = kept_exact(now, value);
        bool may_rest = false;
        for (const Register factor : {a, b}) {
            if (known(factor).point || !known(factor).may_rest) continue;
            value = fmt::format("im_unless_zero({}, {})", interval(factor), value);
            may_rest = true;
        }
        define(result, value, positive);
        known(result).may_rest = may_rest;
    }

    static std::string limited(const std::string& text, bool not_negative) {
        return not_negative ? "im_not_negative(" + text + ")" : text;
    }

    template<class... Registers>
    std::string call(std::string_view function, Registers... arguments) const {
        std::string list;
        for (const Register r : {arguments...}) list += (list.empty() ? "" : ", ") + interval(r);
        return fmt::format("{}({})", function, list);
    }

    std::string interval(Register r) const {
        const Known& known = known_[std::size_t(r)];
        return known.point ? fmt::format("{}({})", type_, known.text) : known.text;
    }

    void define(Register r, const std::string& value, bool not_negative) {
        known(r) = {fmt::format("v{}", r), false, not_negative};
        line("{} v{} = {};", type_, r, value);
    }

    Known& known(Register r) { return known_[std::size_t(r)]; }

    const Program& program_;
    const IntervalSignature& signature_;
    const ArrayPacking& packing_;
    const bool doubles_;
    const ListedArray* listed_;
    const std::string_view type_; // of intervals
    std::vector<Known> known_;
    std::vector<bool> is_exact_; // exact_results.h
    std::string text_;
    int indent_ = 1;
};

} // namespace

std::string emit_interval_glsl(const Program& program, const IntervalSignature& signature,
                               const ArrayPacking& packing, const IntervalNumbers& numbers) {
    return IntervalWriter(program, signature, packing, numbers).write();
}

std::set<std::string> interval_kernels_used(const Program& program) {
    std::set<std::string> kernels;
    for (const Instruction& now : program.instructions) {
        if (now.kind != Instruction::Kind::operation) continue;
        if (const std::string_view name = interval_kernel(now.op); !name.empty())
            kernels.emplace(name);
    }
    const std::vector<bool> exact = exact_results(program);
    if (std::ranges::find(exact, true) != exact.end()) kernels.emplace("exact");
    return kernels;
}

IntervalSignature value_interval_signature() {
    return {"vec2 field_interval(vec2 x, vec2 y, vec2 z)", {"x", "y", "z"}, "vec2", {}};
}

IntervalSignature directional_interval_signature() {
    return {"vec4 field_directional_interval(vec2 x, vec2 y, vec2 z, vec2 dx, vec2 dy, vec2 dz)",
            {"x", "y", "z", "dx", "dy", "dz"},
            "vec4",
            {}};
}

IntervalSignature gradient_interval_signature() {
    return {"void field_gradient_interval(vec2 x, vec2 y, vec2 z, out vec2 gx, out vec2 gy, "
            "out vec2 gz)",
            {"x", "y", "z"},
            "",
            {"gx", "gy", "gz"}};
}

IntervalSignature rough_signature() {
    return {"vec4 field_rough(vec2 x, vec2 y, vec2 z)", {"x", "y", "z"}, "vec4", {}};
}

IntervalSignature breaks_signature() {
    return {"vec4 field_breaks(vec2 x, vec2 y, vec2 z)", {"x", "y", "z"}, "vec4", {}};
}

std::string glsl_value_interval(const EnclosurePrograms& programs, const ArrayPacking& packing,
                                const IntervalNumbers& numbers) {
    return emit_interval_glsl(programs.value, value_interval_signature(), packing, numbers);
}

std::string glsl_directional_interval(const EnclosurePrograms& programs,
                                      const ArrayPacking& packing, const IntervalNumbers& numbers) {
    return emit_interval_glsl(programs.directional, directional_interval_signature(), packing,
                              numbers);
}

std::string glsl_gradient_interval(const EnclosurePrograms& programs, const ArrayPacking& packing,
                                   const IntervalNumbers& numbers) {
    return emit_interval_glsl(programs.gradient, gradient_interval_signature(), packing, numbers);
}

std::string glsl_rough(const EnclosurePrograms& programs, const ArrayPacking& packing,
                       const IntervalNumbers& numbers) {
    return emit_interval_glsl(programs.rough, rough_signature(), packing, numbers);
}

std::string glsl_breaks(const EnclosurePrograms& programs, const ArrayPacking& packing,
                        const IntervalNumbers& numbers) {
    return emit_interval_glsl(programs.breaks, breaks_signature(), packing, numbers);
}

std::string glsl_hessian_interval(const Program& bend, const ArrayPacking& packing,
                                  const IntervalNumbers& numbers) {
    return emit_interval_glsl(bend,
                              {"void field_hessian_interval(vec2 x, vec2 y, vec2 z, vec2 dx, vec2 "
                               "dy, vec2 dz, out vec2 f, "
                               "out vec2 slope, out vec2 bx, out vec2 by, out vec2 bz)",
                               {"x", "y", "z", "dx", "dy", "dz"},
                               "",
                               {"f", "slope", "bx", "by", "bz"}},
                              packing, numbers);
}

} // namespace isomotion::formula
