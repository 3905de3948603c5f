#include "formula/tape/tape_words.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "formula/glsl/glsl_interval.h"
#include "formula/graph/functions.h"
#include "formula/graph/roughness.h"

namespace isomotion::formula {
namespace {

bool is_leaf(const TapeStep& step) { return step.op == Op::constant || step.op == Op::input; }

// Whether the operation takes a processor as long as dozens of products.
bool takes_long(Op op) {
    if (op == Op::chebyshev || op == Op::noise) return true;
    const Traits* row = traits(op);
    return op != Op::sqrt && !is_arithmetic(op) && row && row->shader == Shader::kernel;
}

// A constant as the interpreter reads it.
struct Literal {
    float number = 0;
    bool reaches_next = false; // stands for all up to the next float
};

// Numbers that drivers may take for 0 are 0 for all of them.
float normal(double value) {
    using Floats = std::numeric_limits<float>;
    const auto near = float(std::clamp(value, double(Floats::lowest()), double(Floats::max())));
    return std::abs(near) < Floats::min() ? 0.0f : near;
}

// The floats around an interval, unless more than two adjacent ones are.
std::optional<Literal> enclosing(Interval value) {
    using Floats = std::numeric_limits<float>;
    if (!(magnitude(value) <= double(Floats::max()))) return {};
    const bool is_zero = value.lo == 0 && value.hi == 0;
    if (!is_zero && mignitude(value) < double(Floats::min())) return {};
    auto low = float(value.lo);
    if (double(low) > value.lo) low = std::nextafter(low, -HUGE_VALF);
    if (double(low) >= value.hi) return Literal{low};
    if (double(std::nextafter(low, HUGE_VALF)) < value.hi) return {};
    return Literal{low, true};
}

// The least float that is no less, 0 or normal, or infinity.
float beyond(double end) {
    using Floats = std::numeric_limits<float>;
    if (end > double(Floats::max())) return HUGE_VALF;
    if (end < double(Floats::lowest())) return Floats::lowest();
    auto near = float(end);
    if (double(near) < end) near = std::nextafter(near, HUGE_VALF);
    if (std::abs(near) >= Floats::min()) return near;
    return end > 0 ? Floats::min() : 0.0f;
}

// Where the operation on the intervals a and b may not be smooth, v being its values; empty if it
// always is.
std::string rough_where(Op op) {
    // Beside a pole, as fast as what is divided by comes to a part of itself.
    const auto unless_far = [](const std::string& low, const std::string& high) {
        return fmt::format("!({} > {} * {})", low, least_part_of_pieces, high);
    };
    if (op == Op::select) return "!(held_a.y < held_b.x || held_b.y < held_a.x)";
    switch (breaks(op)) {
    case Breaks::nowhere:
        return "";
    case Breaks::kink_at_0:
        return "!(a.x > 0.0 || a.y < 0.0)";
    case Breaks::kink_at_1:
        return "!(im_abs(a).y < 1.0 || im_abs(a).x > 1.0)";
    case Breaks::begins_at_1:
        return "!(a.x > 1.0 || a.y < 1.0)";
    case Breaks::kink_where_same:
        return "!(a.y < b.x || b.y < a.x)";
    case Breaks::turn:
        return unless_far("1.0 + im_square(a).x", "(1.0 + im_square(a).y)");
    case Breaks::axis:
    case Breaks::cut: {
        const std::string far =
            unless_far("im_square(a).x + im_square(b).x", "(im_square(a).y + im_square(b).y)");
        return breaks(op) == Breaks::axis ? far
                                          : "a.x <= 0.0 && a.y >= 0.0 && b.x <= 0.0 || " + far;
    }
    case Breaks::pole_at_b_0:
        return unless_far("im_abs(b).x", "im_abs(b).y");
    case Breaks::base_at_0:
        return fmt::format("!(a.x > 0.0 || b.x > {:.1f})", smooth_power);
    case Breaks::pole_at_0:
        return "!(a.x > 0.0)";
    case Breaks::poles:
        return "!(v.x > -IM_LARGEST && v.y < IM_LARGEST)";
    case Breaks::steps:
        return "v.x != v.y";
    }
    return "";
}

// The operation's result v, as exact.glsl keeps it.
std::string made_exact(Op op, const std::string& v) {
    switch (op) {
    case Op::add:
        return fmt::format("im_exact_sum(a, b, {})", v);
    case Op::subtract:
        return fmt::format("im_exact_sum(a, -b.yx, {})", v);
    case Op::multiply:
        return fmt::format("im_exact_product(a, b, {})", v);
    default:
        return fmt::format("im_exact_quotient(a, b, {})", v);
    }
}

class Encoder {
public:
    Encoder(const Tape& tape, const TapeOperations& operations, int inputs)
        : tape_(tape)
        , operations_(operations)
        , inputs_(inputs)
        , last_use_(tape.steps.size(), -1)
        , register_(tape.steps.size(), -1)
        , used_(inputs + int(tape.outputs.size())) {
        for (std::size_t k = 0; k < tape.steps.size(); ++k) {
            for (std::size_t o = 0; o < tape.steps[k].arity; ++o)
                last_use_[std::size_t(tape.steps[k].operands[o])] = int(k);
        }
        for (const int output : tape.outputs)
            last_use_[std::size_t(output)] = int(tape.steps.size());
        if (operations.has_calls()) begin_group({});
    }

    TapeWords run() {
        for (std::size_t k = 0; k < tape_.steps.size(); ++k) step(int(k));
        for (std::size_t o = 0; o < tape_.outputs.size(); ++o) {
            const int from = tape_.outputs[o];
            load(from, inputs_ + int(o));
        }
        end_group();
        return {std::move(words_), used_, turns_, noises_};
    }

private:
    bool on_intervals() const { return operations_.numbers() != TapeNumbers::floats; }

    void step(int k) {
        const TapeStep& step = tape_.steps[std::size_t(k)];
        if (step.op == Op::constant) return;
        if (step.op == Op::input) {
            register_[std::size_t(k)] = step.index;
            return;
        }
        std::vector<int> loaded; // registers of constants, until the end of this step
        const bool is_call = TapeOperations::is_call(step);
        const std::uint32_t code = operations_.code(step);
        const int result = take();
        if (step.op == Op::select) {
            instruction(TapeOperations::hold, result, step.operands[0], step.operands[1], loaded);
            instruction(code, result, step.operands[2], step.operands[3], loaded);
        } else if (is_call) {
            call(code, result, step, loaded);
        } else {
            instruction(code, result, step.operands[0], step.operands[step.arity > 1 ? 1 : 0],
                        loaded);
        }
        register_[std::size_t(k)] = result;
        for (const int one : loaded) free_.push_back(one);
        for (std::size_t o = 0; o < step.arity; ++o) release(step.operands[o], k);
    }

    void release(int operand, int k) {
        int& held = register_[std::size_t(operand)];
        const bool is_own = !is_leaf(tape_.steps[std::size_t(operand)]);
        if (!is_own || held < 0 || last_use_[std::size_t(operand)] != k) return;
        free_.push_back(held);
        held = -1; // the same operand twice is released once
    }

    int take() {
        if (free_.empty()) return used_++;
        const int taken = free_.back();
        free_.pop_back();
        return taken;
    }

    // The register of an operand. Constants that an instruction has no place for are loaded.
    int in_register(int operand, std::vector<int>& loaded) {
        if (tape_.steps[std::size_t(operand)].op != Op::constant)
            return register_[std::size_t(operand)];
        const int taken = take();
        loaded.push_back(taken);
        load(operand, taken);
        return taken;
    }

    std::optional<Literal> literal(int operand) const {
        const TapeStep& step = tape_.steps[std::size_t(operand)];
        if (step.op != Op::constant) return {};
        if (on_intervals()) return enclosing(step.value);
        const bool is_nan = step.value == Interval::entire(); // as Interval takes it
        return Literal{is_nan ? std::numeric_limits<float>::quiet_NaN() : normal(mid(step.value))};
    }

    void load(int operand, int into) {
        const TapeStep& step = tape_.steps[std::size_t(operand)];
        if (step.op != Op::constant)
            return emit(TapeOperations::load, into, 0, register_[std::size_t(operand)]);
        if (const auto found = literal(operand)) return emit(TapeOperations::load, into, 0, *found);
        // Both ends, each from its float and all beyond.
        load_end(step.value.lo, into, false);
        load_end(step.value.hi, into, true);
    }

    // Joins the float beyond one end of an interval that no literal encloses.
    void load_end(double end, int into, bool is_upper) {
        const double sign = is_upper ? 1 : -1; // mirrored, lower ends are upper ones
        const auto end_beyond = float(sign) * beyond(sign * end);
        emit(is_upper ? TapeOperations::join : TapeOperations::load, into, is_upper ? into : 0,
             Literal{end_beyond});
    }

    void instruction(std::uint32_t code, int result, int a, int b, std::vector<int>& loaded) {
        const auto of_a = literal(a), of_b = literal(b);
        if (of_b) {
            const int first = in_register(a, loaded);
            return emit(code, result, first, *of_b);
        }
        if (of_a) {
            const int second = in_register(b, loaded);
            return emit(code | exchanged, result, second, *of_a);
        }
        const int first = in_register(a, loaded), second = in_register(b, loaded);
        emit(code, result, first, second);
    }

    void call(std::uint32_t code, int result, const TapeStep& step, std::vector<int>& loaded) {
        const int a = in_register(step.operands[0], loaded);
        const int b = step.arity > 1 ? in_register(step.operands[1], loaded) : a;
        if (step.arity > 2) {
            const int c = in_register(step.operands[2], loaded);
            emit(TapeOperations::hold, result, c, c);
        }
        noises_ += step.op == Op::noise;
        end_group();
        begin_group(
            {code | std::uint32_t(result) << 10 | std::uint32_t(a) << 21, std::uint32_t(b)});
    }

    void emit(std::uint32_t code, int result, int a, int b) {
        put(code, result, a, std::uint32_t(b));
    }
    void emit(std::uint32_t code, int result, int a, Literal b) {
        put(code | is_number | (b.reaches_next ? up_to_next : 0), result, a,
            std::bit_cast<std::uint32_t>(b.number));
    }
    void put(std::uint32_t code, int result, int a, std::uint32_t second) {
        words_.push_back(code | std::uint32_t(result) << 10 | std::uint32_t(a) << 21);
        words_.push_back(second);
    }

    // A call that loads the first input into itself does nothing.
    void begin_group(std::array<std::uint32_t, 2> call) {
        words_.insert(words_.end(), {call[0], call[1], 0, 0});
        group_ = words_.size();
        ++turns_;
    }

    void end_group() {
        constexpr std::size_t turn = 2 * tape_unrolled;
        std::size_t length = words_.size() - group_;
        while (length == 0 || length % turn != 0) {
            emit(TapeOperations::load, 0, 0, 0);
            length = words_.size() - group_;
        }
        if (operations_.has_calls()) words_[group_ - 2] = std::uint32_t(length / 2);
        turns_ += int(length / turn);
    }

    static constexpr std::uint32_t is_number = 1u << 7, exchanged = 1u << 8, up_to_next = 1u << 9;

    const Tape& tape_;
    const TapeOperations& operations_;
    const int inputs_;
    std::vector<int> last_use_, register_;
    std::vector<int> free_;
    int used_;
    std::vector<std::uint32_t> words_;
    std::size_t group_ = 0; // where it begins
    int turns_ = 0, noises_ = 0;
};

} // namespace

TapeOperations::TapeOperations(const Tape& whole, TapeNumbers numbers)
    : numbers_(numbers) {
    std::set<Operation> operations, calls;
    for (const TapeStep& step : whole.steps) {
        if (is_leaf(step)) continue;
        (is_call(step) ? calls : operations).insert(operation(step));
        // What these come to within a box.
        if (step.op == Op::abs || step.op == Op::multiply || step.op == Op::subtract)
            operations.insert({.op = Op::negate});
        if (step.op == Op::multiply) {
            Operation square = operation(step);
            square.of_one = true;
            operations.insert(square);
        }
    }
    operations_.assign(operations.begin(), operations.end());
    calls_.assign(calls.begin(), calls.end());
}

TapeOperations::Operation TapeOperations::operation(const TapeStep& step) const {
    const bool is_family = step.op == Op::chebyshev || step.op == Op::noise;
    return {step.op, is_family ? step.index : 0, is_family ? step.second : 0,
            step.op == Op::multiply && step.operands[0] == step.operands[1],
            step.is_exact && numbers_ != TapeNumbers::floats};
}

bool TapeOperations::is_call(const TapeStep& step) { return takes_long(step.op); }

int TapeOperations::orders_of_noise() const {
    return int(std::ranges::count(calls_, Op::noise, &Operation::op));
}

std::uint32_t TapeOperations::code(const TapeStep& step) const {
    const bool calls = is_call(step);
    const std::vector<Operation>& all = calls ? calls_ : operations_;
    const auto found = std::lower_bound(all.begin(), all.end(), operation(step));
    if (found == all.end() || *found != operation(step))
        throw std::logic_error("an operation that the whole tape does not have");
    return std::uint32_t(found - all.begin()) + (calls ? 1 : first_code);
}

bool TapeOperations::have_codes() const {
    constexpr std::size_t most = 1u << 7;
    return first_code + operations_.size() <= most && 1 + calls_.size() <= most;
}

std::set<std::string> TapeOperations::kernels() const {
    std::set<std::string> all;
    for (const auto* list : {&operations_, &calls_}) {
        for (const Operation& one : *list) {
            const Program alone = program(one);
            all.merge(numbers_ == TapeNumbers::floats ? kernels_used(alone)
                                                      : interval_kernels_used(alone));
            if (one.is_exact) all.emplace("exact");
        }
    }
    return all;
}

// The operation on inputs 0 to 3.
Program TapeOperations::program(const Operation& of) const {
    const Traits* row = traits(of.op);
    const std::uint8_t arity = of.op == Op::select  ? 4
                               : of.op == Op::noise ? 3
                               : row                ? std::uint8_t(row->arguments)
                                                    : 1;
    Program alone;
    Instruction operation{.op = of.op, .arity = arity, .index = of.index, .second = of.second};
    for (int k = 0; k < arity; ++k) {
        alone.instructions.push_back({.op = Op::input, .index = k, .result = k});
        operation.operands[std::size_t(k)] = of.of_one ? 0 : k;
    }
    operation.result = arity;
    alone.instructions.push_back(operation);
    alone.outputs = {arity};
    alone.registers = arity + 1;
    return alone;
}

std::string TapeOperations::functions(const std::string& name, const std::vector<Operation>& of,
                                      std::uint32_t first) const {
    const bool floats = numbers_ == TapeNumbers::floats;
    const std::string type = floats ? "float" : "vec2",
                      select = floats ? "IM_SELECT" : "IM_SELECT2";
    std::string text, chosen;
    for (std::size_t k = 0; k < of.size(); ++k) {
        const Program alone = program(of[k]);
        const std::string function = fmt::format("{}_{}", name, first + k);
        const std::size_t operands = alone.instructions.back().arity;
        const std::string head = fmt::format("{0} {1}({0} a, {0} b{2}{3})", type, function,
                                             operands > 2 ? fmt::format(", {} c", type) : "",
                                             operands > 3 ? fmt::format(", {} d", type) : "");
        const std::vector<std::string> inputs{"a", "b", "c", "d"};
        text += floats ? emit_glsl(alone, {head, type, inputs}, {})
                       : emit_interval_glsl(alone, {head, inputs, type, {}}, {});
        std::string result = fmt::format("{}({})", function,
                                         operands > 3   ? "held_a, held_b, a, b"
                                         : operands > 2 ? "a, b, held_a"
                                                        : "a, b");
        if (of[k].is_exact) result = made_exact(of[k].op, result);
        // Negative bases have integer powers.
        if (of[k].op == Op::power && !floats)
            result = fmt::format("IM_SELECT2(b.x == b.y, im_pow(a, b.x), {})", result);
        // Noise goes through cells, which nothing else should wait for.
        chosen += of[k].op == Op::noise
                      ? fmt::format("    if (op == {}u) v = {};\n", first + k, result)
                      : fmt::format("    v = {}(op == {}u, {}, v);\n", select, first + k, result);
        const std::string rough =
            numbers_ == TapeNumbers::decorated ? rough_where(of[k].op) : std::string();
        if (!rough.empty()) {
            chosen += fmt::format("    tape_is_rough = tape_is_rough || op == {}u && ({});\n",
                                  first + k, rough);
        }
    }
    const bool joins = !floats && first == first_code;
    if (joins) chosen += fmt::format("    v = IM_SELECT2(op == {}u, im_hull(a, b), v);\n", join);
    return fmt::format("{0}{1} {2}(uint op, {1} a, {1} b, {1} held_a, {1} held_b) {{\n"
                       "    {1} v = b;\n{3}    return v;\n}}\n",
                       text, type, name, chosen);
}

std::string TapeOperations::glsl(const std::string& prefix) const {
    std::string text = functions(prefix + "_apply", operations_, first_code);
    if (has_calls()) text += functions(prefix + "_call", calls_, 1);
    return text;
}

std::optional<TapeWords> words_of(const Tape& tape, const TapeOperations& operations, int inputs,
                                  int most) {
    TapeWords words = Encoder(tape, operations, inputs).run();
    if (words.registers > most) return {};
    return words;
}

} // namespace isomotion::formula
