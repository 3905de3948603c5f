#include "formula/glsl/glsl_model.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

#include "formula/graph/chebyshev_form.h"
#include "formula/graph/degree.h"
#include "formula/graph/lowering.h"

namespace isomotion::formula {
namespace {

// How a number's literal differs from it: by half a unit in the last place of a float at most.
constexpr const char* no_rounding = "0.0";
constexpr const char* float_rounding = "6.0e-8";

// What is known of a register when the text is written.
struct KnownNumber {
    std::string text;
    bool is_number = false; // else a model
    bool is_constant = false;
    double value = 0; // of a constant
};

// A constant that a float can be near to by its relative rounding.
bool is_ordinary(double value) {
    const double size = std::abs(value);
    return value == 0 || (size >= double(std::numeric_limits<float>::min()) &&
                          size <= double(std::numeric_limits<float>::max()));
}

// By which a float is multiplied exactly, but where it leaves their range.
bool is_power_of_two(double value) {
    int exponent = 0;
    const double part = std::abs(std::frexp(value, &exponent));
    return part == 0.5 && std::abs(exponent) < 20;
}

class ModelWriter {
public:
    ModelWriter(const Program& program, std::string type, Numbers numbers)
        : program_(program)
        , type_(std::move(type))
        , doubles_(numbers == Numbers::doubles)
        , known_(std::size_t(program.registers)) {}

    // None where an operation has no model.
    std::optional<std::string> write() {
        text_ = fmt::format("{0} field_model({0} x, {0} y, {0} z) {{\n", type_);
        for (const Instruction& now : program_.instructions) {
            if (now.kind != Instruction::Kind::operation || !operation(now)) return std::nullopt;
        }
        const KnownNumber& f = known_[std::size_t(program_.outputs.at(0))];
        text_ += fmt::format("    return {};\n}}\n", model(f));
        return std::move(text_);
    }

private:
    bool operation(const Instruction& now) {
        constexpr std::array inputs{"x", "y", "z"};
        KnownNumber& result = known_[std::size_t(now.result)];
        switch (now.op) {
        case Op::constant:
            result = {number(now.value), true, true, now.value};
            return is_ordinary(now.value);
        case Op::input:
            result = {inputs.at(std::size_t(now.index)), false, false, 0};
            return true;
        case Op::parameter:
            result = {fmt::format("REAL({})", glsl_parameter(now.index)), true, false, 0};
            return true;
        default:
            break;
        }
        if (now.arity > 2) return false;
        const std::string value = of_operands(now);
        if (value.empty()) return false;
        result = {fmt::format("v{}", now.result), false, false, 0};
        text_ += fmt::format("    {} v{} = {};\n", type_, now.result, value);
        return true;
    }

    std::string of_operands(const Instruction& now) const {
        const KnownNumber& a = known_[std::size_t(now.operands[0])];
        const KnownNumber& b = known_[std::size_t(now.operands[now.arity > 1 ? 1 : 0])];
        switch (now.op) {
        case Op::negate:
            return fmt::format("md_negate({})", model(a));
        case Op::add:
            return a.is_number ? shifted(b, a) : shifted(a, b);
        case Op::subtract:
            return b.is_number
                       ? fmt::format("md_shift({}, -({}), {})", model(a), b.text, rounding(b))
                   : a.is_number
                       ? shifted({fmt::format("md_negate({})", b.text), false, false, 0}, a)
                       : fmt::format("md_subtract({}, {})", model(a), model(b));
        case Op::multiply:
            if (now.operands[0] == now.operands[1]) return fmt::format("md_square({})", model(a));
            return a.is_number ? scaled(b, a) : scaled(a, b);
        case Op::divide:
            return divided(a, b);
        case Op::min:
            return a.is_number == b.is_number
                       ? fmt::format("md_min({}, {})", model(a), model(b))
                       : fmt::format("md_below({}, {})", model(a.is_number ? b : a),
                                     model(a.is_number ? a : b));
        case Op::max:
            return a.is_number == b.is_number
                       ? fmt::format("md_max({}, {})", model(a), model(b))
                       : fmt::format("md_above({}, {})", model(a.is_number ? b : a),
                                     model(a.is_number ? a : b));
        default:
            return {};
        }
    }

    std::string shifted(const KnownNumber& a, const KnownNumber& by) const {
        return by.is_number ? fmt::format("md_shift({}, {}, {})", model(a), by.text, rounding(by))
                            : fmt::format("md_add({}, {})", model(a), model(by));
    }

    std::string scaled(const KnownNumber& a, const KnownNumber& by) const {
        if (by.is_constant && is_power_of_two(by.value))
            return fmt::format("md_scale_by_power({}, {})", by.text, model(a));
        return by.is_number ? fmt::format("md_scale({}, {}, {})", by.text, model(a), rounding(by))
                            : fmt::format("md_multiply({}, {})", model(a), model(by));
    }

    std::string divided(const KnownNumber& a, const KnownNumber& by) const {
        if (!by.is_number) return {};
        return fmt::format("md_divide({}, {}, {})", model(a), by.text, rounding(by));
    }

    std::string model(const KnownNumber& known) const {
        return known.is_number ? fmt::format("md_of_{}({}, {})", type_, known.text, rounding(known))
                               : known.text;
    }

    std::string number(double value) const {
        return doubles_ ? glsl_double_literal(value) : glsl_literal(value);
    }

    // The relative rounding of a number.
    const char* rounding(const KnownNumber& known) const {
        const bool is_exact =
            doubles_ || !known.is_constant || double(float(known.value)) == known.value;
        return is_exact ? no_rounding : float_rounding;
    }

    const Program& program_;
    const std::string type_;
    const bool doubles_;
    std::vector<KnownNumber> known_;
    std::string text_;
};

// F with Chebyshev polynomials in the place of what is written by angles, and few products.
Program modelled(const Field& field) {
    Graph graph = field.graph;
    graph.fold_exactly();
    const NodeId root = with_whole_chebyshev(graph, field.root, true);
    return schedule(graph, std::array{lower_to_fewest_products(graph, root)});
}

std::optional<int> degree_of(const Field& field) {
    Graph graph = field.graph;
    graph.fold_exactly();
    return degree(graph, with_whole_chebyshev(graph, field.root, false));
}

} // namespace

int modelled_degree(const Field& field) {
    const auto found = degree_of(field);
    // Beyond them what is left out is too much, and compiling takes too long.
    constexpr int most = 64;
    constexpr std::size_t longest = 400;
    if (!found || *found > most) return 0;
    const Program program = modelled(field);
    if (program.instructions.size() > longest) return 0;
    return ModelWriter(program, "Model", Numbers::floats).write() ? std::max(*found, 1) : 0;
}

std::string glsl_value_model(const Field& field, const std::string& type, Numbers numbers) {
    auto text = ModelWriter(modelled(field), type, numbers).write();
    if (!text) throw std::logic_error("a field without models");
    return std::move(*text);
}

} // namespace isomotion::formula
