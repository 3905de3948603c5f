#include "formula/evaluate/evaluate.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <limits>
#include <type_traits>

#include "formula/evaluate/clones.h"
#include "formula/graph/functions.h"
#include "formula/graph/operations.h"
#include "formula/interval/interval_operations.h"
#include "formula/interval/rounding_upwards.h"
#include "formula/interval/upward.h"

// Loops over lanes for wider registers too; the values are the same, for nothing is contracted.
// `flatten` puts all that a loop calls into each version: what stays a call is made for no
// register.
#define ISOMOTION_WIDER ISOMOTION_CLONES("avx512f", "avx2") __attribute__((flatten))

namespace isomotion::formula {

double random_unit(std::uint64_t seed, double i, double k) {
    // splitmix64's finaliser over the three words; -0 and 0 are one argument.
    std::uint64_t h = seed;
    for (const double argument : {i, k}) {
        h ^= std::bit_cast<std::uint64_t>(argument == 0 ? 0.0 : argument);
        h += 0x9E3779B97F4A7C15u;
        h = (h ^ (h >> 30)) * 0xBF58476D1CE4E5B9u;
        h = (h ^ (h >> 27)) * 0x94D049BB133111EBu;
        h ^= h >> 31;
    }
    return double(h >> 11) * 0x1p-53;
}

template<> struct Lanes<Upward> : LanesOfEnds<Upward> { using LanesOfEnds::LanesOfEnds; };

namespace {

template<class T> constexpr bool is_interval = std::is_same_v<T, Interval>;
template<class Value> constexpr bool is_upward = std::is_same_v<Value, Upward>;
template<class Value> constexpr bool is_enclosure = is_interval<Value> || is_upward<Value>;

// What values of T are computed as.
template<class T> struct ComputedAs { using Value = T; };
#if ISOMOTION_MAY_ROUND_UPWARDS
template<> struct ComputedAs<Interval> { using Value = Upward; };
#endif
template<class T> using Computed = typename ComputedAs<T>::Value;

template<class Value> bool can_compute() { return !is_upward<Value> || can_round_upwards(); }

// How the processor rounds while values are computed.
template<class Value> struct Rounding {
    void pause() {}
    void resume() {}
};
template<> struct Rounding<Upward> : RoundingUpwards {};

// Whether the function is a call for each point, which takes as long as dozens of products.
template<class Value> constexpr bool is_called(Op op) {
    return is_enclosure<Value> && op != Op::abs && op != Op::sign && op != Op::sqrt &&
           op != Op::exp && op != Op::floor;
}

// As in a shader: folded in double, a constant may be more than a float holds.
template<class Value> Value constant(double value) {
    if constexpr (is_enclosure<Value>) {
        return value;
    } else {
        return Value(std::clamp(value, double(std::numeric_limits<Value>::lowest()),
                                double(std::numeric_limits<Value>::max())));
    }
}

template<class Value> Value random(std::uint64_t seed, Value i, Value k) {
    if constexpr (is_enclosure<Value>) {
        const Interval first = i, second = k;
        return is_point(first) && is_point(second)
                   ? Interval(random_unit(seed, first.lo, second.lo))
                   : Interval(0, 1);
    } else {
        return Value(random_unit(seed, double(i), double(k)));
    }
}

// `each` sets the result at each point.
template<class Value, class Each>
[[gnu::always_inline]] inline void multiply(Product product, const Lanes<Value>& a,
                                            const Lanes<Value>& b, const Each& each) {
    using Do = Operations<Value>;
    if (product == Product::by_uniform) {
        const Value factor = b[0];
        const Interval ends = factor;
        if (is_point(ends) && ends.lo > 0)
            return each([&](int l) { return times_positive(a[l], ends.lo); });
        if (is_point(ends) && ends.lo < 0)
            return each([&](int l) { return -times_positive(a[l], -ends.lo); });
        if (ends.lo < 0 && ends.hi <= 0)
            return each([&](int l) { return -times_not_negative(a[l], -factor); });
        if (ends.lo >= 0 && ends.hi > 0) product = Product::by_not_negative;
    }
    switch (product) {
    case Product::square:
        return each([&](int l) { return Do::square(a[l]); });
    case Product::by_not_negative:
        return each([&](int l) { return times_not_negative(a[l], b[l]); });
    case Product::of_not_negative:
        return each([&](int l) { return product_not_negative(a[l], b[l]); });
    case Product::by_uniform:
    case Product::any:
        return each([&](int l) { return Do::multiply(a[l], b[l]); });
    }
}

} // namespace

template<class T>
Evaluator<T>::Evaluator(const Program& program)
    : plan_(plan(program, is_interval<T>))
    , registers_(std::size_t(plan_.registers) * Lanes<T>::parts * block) {
    for (const Step& step : plan_.steps) {
        if (step.op == Op::noise) noise_.try_emplace(step.index, NoiseOrder::unpacked(step.index));
        if (step.op != Op::chebyshev) continue;
        const std::pair which{step.index, step.second};
        if (!chebyshev_.contains(which))
            chebyshev_.emplace(which, ChebyshevEnclosure(which.first, which.second));
    }
    loops_.reserve(plan_.deepest);
}

template<class T> template<int Count, class Value> Lanes<Value> Evaluator<T>::lanes(Register r) {
    return {registers_.data() + std::size_t(r) * Lanes<Value>::parts * Count, Count};
}

template<class T>
void Evaluator<T>::point(const Bindings<T>& bindings, std::span<const T> inputs,
                         std::span<T> outputs) {
    if (can_compute<Computed<T>>()) {
        one<Computed<T>>(bindings, inputs, outputs);
    } else {
        one<T>(bindings, inputs, outputs);
    }
}

template<class T>
template<class Value>
void Evaluator<T>::one(const Bindings<T>& bindings, std::span<const T> inputs,
                       std::span<T> outputs) {
    for (std::size_t k = 0; k < plan_.inputs.size(); ++k) {
        if (plan_.inputs[k] >= 0) lanes<1, Value>(plan_.inputs[k]).set(0, inputs[k]);
    }
    run<1, Value>(bindings);
    for (std::size_t o = 0; o < outputs.size(); ++o) {
        outputs[o] = lanes<1, Value>(plan_.outputs[o])[0];
    }
}

template<class T>
void Evaluator<T>::points(const Bindings<T>& bindings, std::span<const std::span<const T>> inputs,
                          std::span<const std::span<T>> outputs) {
    using Value = Computed<T>;
    const std::size_t total = inputs.empty() ? 0 : inputs[0].size();
    const bool are_alone = !can_compute<Value>();
    for (std::size_t first = 0; are_alone && first < total; ++first)
        together<1, T>(bindings, inputs, outputs, first, 1);
    for (std::size_t first = 0; !are_alone && first < total; first += block) {
        const std::size_t count = std::min<std::size_t>(block, total - first);
        if (count == 1) {
            together<1, Value>(bindings, inputs, outputs, first, count);
        } else if (count <= few) {
            together<few, Value>(bindings, inputs, outputs, first, count);
        } else if (count <= half) {
            together<half, Value>(bindings, inputs, outputs, first, count);
        } else {
            together<block, Value>(bindings, inputs, outputs, first, count);
        }
    }
}

template<class T>
template<int Count, class Value>
void Evaluator<T>::together(const Bindings<T>& bindings, std::span<const std::span<const T>> inputs,
                            std::span<const std::span<T>> outputs, std::size_t first,
                            std::size_t count) {
    for (std::size_t k = 0; k < plan_.inputs.size(); ++k) {
        if (plan_.inputs[k] < 0) continue;
        const Lanes<Value> to = lanes<Count, Value>(plan_.inputs[k]);
        const std::span<const T> from = inputs[k].subspan(first, count);
        for (std::size_t lane = 0; lane < count; ++lane) to.set(int(lane), from[lane]);
        // Lanes past the end repeat the last point: no branch inside, nothing undefined.
        for (std::size_t lane = count; lane < Count; ++lane) to.set(int(lane), from[count - 1]);
    }
    run<Count, Value>(bindings);
    for (std::size_t o = 0; o < outputs.size(); ++o) {
        const Lanes<Value> from = lanes<Count, Value>(plan_.outputs[o]);
        for (std::size_t lane = 0; lane < count; ++lane) {
            outputs[o][first + lane] = from[int(lane)];
        }
    }
}

template<class T>
template<int Count, class Value>
ISOMOTION_WIDER void Evaluator<T>::run(const Bindings<T>& bindings) {
    using Do = Operations<Value>;
    const auto& code = plan_.steps;
    loops_.clear();
    [[maybe_unused]] Rounding<Value> rounding;
    for (std::size_t at = 0; at < code.size(); ++at) {
        const Step& now = code[at];
        const bool is_operation = now.kind == Instruction::Kind::operation; // most are
        if (!is_operation && now.kind == Instruction::Kind::loop_begin) {
            if (bindings.arrays[std::size_t(now.index)].count > 0) {
                loops_.push_back({at, now.index, 0});
                continue;
            }
            for (int depth = 1; depth > 0;) { // an empty array: to the matching end
                ++at;
                if (code[at].kind == Instruction::Kind::loop_begin) ++depth;
                if (code[at].kind == Instruction::Kind::loop_end) --depth;
            }
            continue;
        }
        if (!is_operation && now.kind == Instruction::Kind::loop_end) {
            OpenLoop& loop = loops_.back();
            if (++loop.element < bindings.arrays[std::size_t(loop.array)].count) {
                at = loop.begin;
            } else {
                loops_.pop_back();
            }
            continue;
        }
        const Lanes<Value> to = lanes<Count, Value>(now.result);
        const Lanes<Value> a = lanes<Count, Value>(now.operands[0]);
        const Lanes<Value> b = lanes<Count, Value>(now.operands[1]);
        const auto all = [&](Value value) {
            for (int lane = 0; lane < Count; ++lane) to.set(lane, value);
        };
        const auto each = [&](auto&& value) {
            if (Count > 1 && now.is_uniform) return all(value(0));
            ISOMOTION_LANES_APART
            for (int lane = 0; lane < Count; ++lane) to.set(lane, value(lane));
        };
        // The error bounds of functions ask for the nearest double.
        [[maybe_unused]] const auto nearest = [&](auto&& compute) {
            rounding.pause();
            compute();
            rounding.resume();
        };
        // Once for lanes next to each other with the same argument.
        [[maybe_unused]] const auto each_of_runs = [&](auto&& value) {
            for (int lane = 0; lane < Count; ++lane) {
                const bool is_known = lane > 0 && a[lane] == a[lane - 1];
                to.set(lane, is_known ? to[lane - 1] : value(lane));
            }
        };
        if (!is_operation && now.kind == Instruction::Kind::begin) {
            all(now.op == Op::least ? Do::least_of_none() : Value(0));
            if (!keeps_least(now.op)) continue;
            const Lanes<Value> least = lanes<Count, Value>(now.operands[2]);
            for (int lane = 0; lane < Count; ++lane) least.set(lane, Do::least_of_none());
            continue;
        }
        if (!is_operation) { // accumulates
            if (now.op == Op::sum) {
                each([&](int l) { return Do::add(to[l], a[l]); });
            } else if (now.op == Op::least) { // what is no number is passed over
                each([&](int l) { return Do::min(a[l], to[l]); });
            } else {
                const Lanes<Value> least = lanes<Count, Value>(now.operands[2]);
                const Value number = Value(loops_.back().element + 1);
                each([&](int l) {
                    return Do::select(a[l], least[l], now.op == Op::pick ? b[l] : number, to[l]);
                });
                for (int l = 0; l < Count; ++l) least.set(l, Do::min(a[l], least[l]));
            }
            continue;
        }
        switch (now.op) {
        case Op::constant:
            all(constant<Value>(now.value));
            break;
        case Op::input:
            assert(!"put into its register before");
            break;
        case Op::parameter:
            all(bindings.parameters[std::size_t(now.index)]);
            break;
        case Op::element: {
            const auto loop = std::find_if(loops_.begin(), loops_.end(),
                                           [&](const OpenLoop& l) { return l.array == now.index; });
            const auto& array = bindings.arrays[std::size_t(now.index)];
            all(array.fields[std::size_t(now.second)][std::size_t(loop->element)]);
            break;
        }
        case Op::negate:
            each([&](int l) { return Do::negate(a[l]); });
            break;
#define ROW(name, ...)                                                                             \
    case Op::name:                                                                                 \
        if constexpr (Op::name == Op::abs) {                                                       \
            each([&](int l) { return Do::name(a[l]); });                                           \
        } else if constexpr (is_called<Value>(Op::name)) {                                         \
            nearest([&] { each_of_runs([&](int l) { return Do::name(a[l]); }); });                 \
        } else {                                                                                   \
            nearest([&] { each([&](int l) { return Do::name(a[l]); }); });                         \
        }                                                                                          \
        break;
            ISOMOTION_FUNCTIONS(ROW)
#undef ROW
#define ROW(name, shader, ...)                                                                     \
    case Op::name:                                                                                 \
        if constexpr (Op::name == Op::multiply && is_enclosure<Value>) {                           \
            multiply(now.product, a, b, each);                                                     \
        } else if constexpr (Shader::shader == Shader::kernel && !is_arithmetic(Op::name)) {       \
            nearest([&] { each([&](int l) { return Do::name(a[l], b[l]); }); });                   \
        } else {                                                                                   \
            each([&](int l) { return Do::name(a[l], b[l]); });                                     \
        }                                                                                          \
        break;
            ISOMOTION_OPERATIONS_OF_TWO(ROW)
#undef ROW
        case Op::random:
            each([&](int l) { return random(bindings.seed, a[l], b[l]); });
            break;
        case Op::noise: {
            const Lanes<Value> c = lanes<Count, Value>(now.operands[2]);
            if constexpr (is_enclosure<Value>) {
                const NoiseEnclosure& enclose = noise_.at(now.index);
                nearest([&] { each([&](int l) { return enclose(a[l], b[l], c[l]); }); });
            } else {
                const NoiseOrder order = NoiseOrder::unpacked(now.index);
                each([&](int l) { return noise<Value>(a[l], b[l], c[l], order); });
            }
            break;
        }
        case Op::select: {
            const Lanes<Value> c = lanes<Count, Value>(now.operands[2]),
                               d = lanes<Count, Value>(now.operands[3]);
            each([&](int l) { return Do::select(a[l], b[l], c[l], d[l]); });
            break;
        }
        case Op::chebyshev:
            if constexpr (is_enclosure<Value>) {
                const ChebyshevEnclosure& enclose = chebyshev_.at({now.index, now.second});
                nearest([&] { each([&](int l) { return enclose(a[l]); }); });
            } else {
                assert(!"lowered before scheduling");
            }
            break;
        case Op::sum:
        case Op::least:
        case Op::pick:
        case Op::which:
            assert(!"turned into a loop");
            break;
        case Op::at:
            assert(!"put in its place by a call");
            break;
        }
    }
}

template class Evaluator<float>;
template class Evaluator<double>;
template class Evaluator<Interval>;

} // namespace isomotion::formula
