// Runs a Program on the CPU for any number type with Operations<T>: at one point, or at blocks of
// points (structure of arrays, vectorised by the compiler).
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "formula/evaluate/lanes.h"
#include "formula/evaluate/plan.h"
#include "formula/graph/program.h"
#include "formula/interval/chebyshev_enclosure.h"
#include "formula/interval/noise_enclosure.h"

namespace isomotion::formula {

template<class T> struct ArrayColumns {
    int count = 0;
    std::vector<std::vector<T>> fields; // [field][element]; unused fields may be empty

    bool operator==(const ArrayColumns&) const = default;
};

// The values of a formula's names, apart from its inputs.
template<class T> struct Bindings {
    std::vector<T> parameters;
    std::vector<ArrayColumns<T>> arrays;
    std::uint64_t seed = 0; // of random(i, k)

    std::vector<int> counts() const { // elements of each array
        std::vector<int> counts;
        for (const auto& array : arrays) counts.push_back(array.count);
        return counts;
    }
    bool operator==(const Bindings&) const = default;
};

template<class To, class From> Bindings<To> convert(const Bindings<From>& from) {
    Bindings<To> to;
    to.parameters.assign(from.parameters.begin(), from.parameters.end());
    to.seed = from.seed;
    for (const auto& array : from.arrays) {
        ArrayColumns<To> columns;
        columns.count = array.count;
        for (const auto& field : array.fields)
            columns.fields.emplace_back(field.begin(), field.end());
        to.arrays.push_back(std::move(columns));
    }
    return to;
}

// Holds the registers, so that evaluation allocates no memory. Use one evaluator per thread.
// Instantiated for float, double and Interval. Programs for numbers are lowered; those for Interval
// may hold chebyshev, and should (see enclosure.h).
template<class T> class Evaluator {
public:
    static constexpr int block = 32; // points evaluated together
    // Points in a block if there are no more; a single point is evaluated alone.
    static constexpr int half = 16, few = 8;

    explicit Evaluator(const Program& program);

    // inputs[k] is the value of input k; writes one value per output.
    void point(const Bindings<T>& bindings, std::span<const T> inputs, std::span<T> outputs);
    // inputs[k][i] is input k of point i, for any number of points; writes outputs[o][i].
    void points(const Bindings<T>& bindings, std::span<const std::span<const T>> inputs,
                std::span<const std::span<T>> outputs);

private:
    // Values of T are computed as Values.
    template<class Value>
    void one(const Bindings<T>& bindings, std::span<const T> inputs, std::span<T> outputs);
    // `count` points from `first` on; count is at most Count.
    template<int Count, class Value>
    void together(const Bindings<T>& bindings, std::span<const std::span<const T>> inputs,
                  std::span<const std::span<T>> outputs, std::size_t first, std::size_t count);
    template<int Count, class Value> void run(const Bindings<T>& bindings);
    template<int Count, class Value> Lanes<Value> lanes(Register r);

    Plan plan_;
    Registers<typename Lanes<T>::Part> registers_;                // [register][part][lane]
    std::map<std::pair<int, int>, ChebyshevEnclosure> chebyshev_; // by degree and derivative
    std::map<int, NoiseEnclosure> noise_;                         // by order, packed
    struct OpenLoop {
        std::size_t begin;
        int array;
        int element;
    };
    std::vector<OpenLoop> loops_;
};

extern template class Evaluator<float>;
extern template class Evaluator<double>;
extern template class Evaluator<Interval>;

// random(i, k) of animation expressions: a hash of the seed and both arguments, in [0, 1).
double random_unit(std::uint64_t seed, double i, double k);

} // namespace isomotion::formula
