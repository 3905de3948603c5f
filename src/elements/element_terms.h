// The terms of an array's elements at a frame, and where each exceeds a tolerance.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "elements/quadric.h"
#include "formula/element_kernels.h"

namespace isomotion::elements {

using formula::Interval;

class ElementTerms {
public:
    // `kernels` and `bindings` must outlive it. The result is the same for any number of threads.
    ElementTerms(const formula::ElementKernels& kernels, const formula::Bindings<float>& bindings,
                 const Region& region, int threads = 1);

    int count() const { return count_; }
    bool is_least() const { return kernels_.is_least; }
    int sums() const { return kernels_.sums(); }
    int quadrics() const { return kernels_.quadrics; }
    int quadric_of(int sum) const { return kernels_.quadric_of[std::size_t(sum)]; }
    const Quadric& quadric(int element, int k) const {
        return quadrics_[std::size_t(element) * std::size_t(kernels_.quadrics) + std::size_t(k)];
    }
    const formula::Bindings<float>& bindings() const { return bindings_; }

    // The level sets of elements [first, last), one for each quadric of the first element, then of
    // the next. Outside of them each term is at most the tolerance of its sum, by interval
    // arithmetic; each key of a `least` is at least its tolerance. May be called from any thread.
    void level_sets(std::span<const double> tolerance, int first, int last,
                    std::span<LevelSet> found) const;

    // Bounds of the terms' sizes in shells of their level sets. For each element and each sum there
    // are `shells` numbers, from the middle outwards; number k bounds the size where the form's
    // root is at least k / shells. It holds for all places further out as well. For keys these are
    // lower bounds.
    static constexpr int shells = 8;
    void sizes(std::span<const LevelSet> sets, int first, int last, std::span<float> found) const;

    // Terms of single elements over boxes, for sets that are boxes. Use one per thread.
    class Boxes {
    public:
        explicit Boxes(const ElementTerms& of);
        // Bounds an element's terms in these boxes, for the functions below.
        void look(int element, std::span<const std::array<Interval, 3>> boxes);
        // Whether some term of quadric k exceeds its tolerance in the box with that index.
        bool matters(int k, std::span<const double> tolerance, std::size_t box) const;
        float size(int sum, std::size_t box) const; // as sizes()
        const Interval& term(int sum, std::size_t box) const {
            return terms_[std::size_t(sum)][box];
        }

    private:
        const ElementTerms& of_;
        formula::Evaluator<Interval> evaluator_;
        std::vector<std::vector<Interval>> inputs_, terms_;
    };

    // Bounds of a sum's terms where an element's middle is at least `distance` away.
    Interval bounds(int sum, double distance) const;

private:
    class Lanes;
    class Reader;
    // Ranges over many elements.
    struct Ranges {
        std::vector<Quadric> hulls;   // for each quadric
        std::vector<Interval> fields; // in the order of the kernels' fields
    };
    bool keeps(const Interval& term, double tolerance) const;

    LevelSet box(Boxes& boxes, int element, int k, std::span<const double> tolerance) const;
    float size_of(const Interval& term) const;
    void read(int threads);
    void read_quadrics(int threads);
    void bound_anywhere();
    bool has_equal_terms() const;
    std::span<const float> column(std::size_t input) const;

    const formula::ElementKernels& kernels_;
    const formula::Bindings<float>& bindings_;
    Region region_;
    int count_ = 0;
    std::vector<Quadric> quadrics_;
    Ranges ranges_;                  // over all elements
    std::vector<Interval> anywhere_; // for each sum's terms, if some quadric bounds nothing
    formula::Bindings<Interval> parameters_;
    bool alike_ = false; // all elements have the same terms as functions of their quadrics
};

} // namespace isomotion::elements
