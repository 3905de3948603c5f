#include "formula/evaluate.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <limits>

#include "formula/operations.h"

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

template<class T>
Evaluator<T>::Evaluator(const Program& program)
    : program_(&program)
    , registers_(std::size_t(program.registers) * block) {
    int inputs = 0, depth = 0, deepest = 0;
    for (const Instruction& instruction : program.instructions) {
        if (instruction.kind == Instruction::Kind::loop_begin) deepest = std::max(deepest, ++depth);
        if (instruction.kind == Instruction::Kind::loop_end) --depth;
        if (instruction.op == Op::input) inputs = std::max(inputs, instruction.index + 1);
    }
    inputs_.resize(std::size_t(inputs) * block);
    loops_.reserve(std::size_t(deepest));
}

template<class T>
void Evaluator<T>::point(const Bindings<T>& bindings, std::span<const T> inputs,
                         std::span<T> outputs) {
    run<1>(bindings, inputs);
    for (std::size_t o = 0; o < outputs.size(); ++o) {
        outputs[o] = registers_[std::size_t(program_->outputs[o])];
    }
}

template<class T>
void Evaluator<T>::points(const Bindings<T>& bindings, std::span<const std::span<const T>> inputs,
                          std::span<const std::span<T>> outputs) {
    const std::size_t total = inputs.empty() ? 0 : inputs[0].size();
    for (std::size_t first = 0; first < total; first += block) {
        const std::size_t count = std::min<std::size_t>(block, total - first);
        for (std::size_t k = 0; k < inputs.size() && k * block < inputs_.size(); ++k) {
            // Lanes past the end repeat the last point: no branch inside, nothing undefined.
            for (std::size_t lane = 0; lane < block; ++lane) {
                inputs_[k * block + lane] = inputs[k][first + std::min(lane, count - 1)];
            }
        }
        run<block>(bindings, inputs_);
        for (std::size_t o = 0; o < outputs.size(); ++o) {
            const T* from = &registers_[std::size_t(program_->outputs[o]) * block];
            std::copy_n(from, count, outputs[o].begin() + std::ptrdiff_t(first));
        }
    }
}

template<class T>
template<int Lanes>
void Evaluator<T>::run(const Bindings<T>& bindings, std::span<const T> inputs) {
    using Do = Operations<T>;
    const auto& code = program_->instructions;
    loops_.clear();
    for (std::size_t at = 0; at < code.size(); ++at) {
        const Instruction& now = code[at];
        const auto reg = [&](Register r) { return registers_.data() + std::size_t(r) * Lanes; };
        if (now.kind == Instruction::Kind::loop_begin) {
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
        if (now.kind == Instruction::Kind::loop_end) {
            OpenLoop& loop = loops_.back();
            if (++loop.element < bindings.arrays[std::size_t(loop.array)].count) {
                at = loop.begin;
            } else {
                loops_.pop_back();
            }
            continue;
        }
        T* const to = reg(now.result);
        if (now.kind == Instruction::Kind::zero) {
            std::fill_n(to, Lanes, T(0));
            continue;
        }
        const T* const a =
            reg(now.kind == Instruction::Kind::accumulate || now.arity > 0 ? now.operands[0]
                                                                           : now.result);
        const T* const b = reg(now.arity > 1 ? now.operands[1] : now.result);
        const auto each = [&](auto&& value) {
            for (int lane = 0; lane < Lanes; ++lane) to[lane] = value(lane);
        };
        if (now.kind == Instruction::Kind::accumulate) {
            each([&](int lane) { return to[lane] + a[lane]; });
            continue;
        }
        switch (now.op) {
        case Op::constant:
            // As in a shader: folded in double, a constant may be more than a float holds.
            std::fill_n(to, Lanes,
                        T(std::clamp(now.value, double(std::numeric_limits<T>::lowest()),
                                     double(std::numeric_limits<T>::max()))));
            break;
        case Op::input:
            each([&](int lane) { return inputs[std::size_t(now.index * Lanes + lane)]; });
            break;
        case Op::parameter:
            std::fill_n(to, Lanes, bindings.parameters[std::size_t(now.index)]);
            break;
        case Op::element: {
            const auto loop = std::find_if(loops_.begin(), loops_.end(),
                                           [&](const OpenLoop& l) { return l.array == now.index; });
            const auto& array = bindings.arrays[std::size_t(now.index)];
            std::fill_n(to, Lanes,
                        array.fields[std::size_t(now.second)][std::size_t(loop->element)]);
            break;
        }
        case Op::negate:
            each([&](int l) { return Do::negate(a[l]); });
            break;
        case Op::abs:
            each([&](int l) { return Do::abs(a[l]); });
            break;
        case Op::sign:
            each([&](int l) { return Do::sign(a[l]); });
            break;
        case Op::sqrt:
            each([&](int l) { return Do::sqrt(a[l]); });
            break;
        case Op::exp:
            each([&](int l) { return Do::exp(a[l]); });
            break;
        case Op::log:
            each([&](int l) { return Do::log(a[l]); });
            break;
        case Op::sin:
            each([&](int l) { return Do::sin(a[l]); });
            break;
        case Op::cos:
            each([&](int l) { return Do::cos(a[l]); });
            break;
        case Op::tan:
            each([&](int l) { return Do::tan(a[l]); });
            break;
        case Op::sinh:
            each([&](int l) { return Do::sinh(a[l]); });
            break;
        case Op::cosh:
            each([&](int l) { return Do::cosh(a[l]); });
            break;
        case Op::tanh:
            each([&](int l) { return Do::tanh(a[l]); });
            break;
        case Op::asin:
            each([&](int l) { return Do::asin(a[l]); });
            break;
        case Op::acos:
            each([&](int l) { return Do::acos(a[l]); });
            break;
        case Op::atan:
            each([&](int l) { return Do::atan(a[l]); });
            break;
        case Op::floor:
            each([&](int l) { return Do::floor(a[l]); });
            break;
        case Op::add:
            each([&](int l) { return Do::add(a[l], b[l]); });
            break;
        case Op::subtract:
            each([&](int l) { return Do::subtract(a[l], b[l]); });
            break;
        case Op::multiply:
            each([&](int l) { return Do::multiply(a[l], b[l]); });
            break;
        case Op::divide:
            each([&](int l) { return Do::divide(a[l], b[l]); });
            break;
        case Op::min:
            each([&](int l) { return Do::min(a[l], b[l]); });
            break;
        case Op::max:
            each([&](int l) { return Do::max(a[l], b[l]); });
            break;
        case Op::power:
            each([&](int l) { return Do::power(a[l], b[l]); });
            break;
        case Op::random:
            each([&](int l) { return T(random_unit(bindings.seed, double(a[l]), double(b[l]))); });
            break;
        case Op::select: {
            const T* const c = reg(now.operands[2]);
            const T* const d = reg(now.operands[3]);
            each([&](int l) { return Do::select(a[l], b[l], c[l], d[l]); });
            break;
        }
        case Op::chebyshev:
        case Op::sum:
            assert(!"lowered before scheduling, or turned into a loop");
            break;
        }
    }
}

template class Evaluator<float>;
template class Evaluator<double>;

} // namespace isomotion::formula
