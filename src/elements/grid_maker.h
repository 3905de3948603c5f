// Finds which elements matter in which cells, for a field and the values of a frame.
#pragma once

#include <memory>
#include <optional>

#include "elements/element_grid.h"
#include "elements/least_at_roots.h"
#include "elements/sums_at_roots.h"
#include "elements/tolerance.h"
#include "formula/element_kernels.h"

namespace isomotion::elements {

// Makes grids for one array of a field. A list leaves out elements whose terms are 0 by interval
// arithmetic. For kernels that fade without end it leaves out the smallest terms as long as they
// add up to less than part_left_out (tolerance.h) of the sum's size at roots. For least(array, key)
// it leaves out elements with keys so large that no root depends on them. If no bound is found, a
// list holds all elements.
class GridMaker {
public:
    // None if the terms of the array's sums, or the key of its least element, are not kernels of a
    // distance (element_kernels.h).
    static std::optional<GridMaker> of(const formula::Field& field, int array);

    ElementGrid make(const formula::Bindings<float>& bindings, const Region& region,
                     const GridLimits& limits) const;

    int array() const { return kernels_.array; }

private:
    GridMaker(const formula::Field& field, formula::ElementKernels kernels);

    // Where each element matters, and the consequences for roots.
    struct Measured {
        RootFree root_free;
        Tolerances left_out;
        std::vector<LevelSet> sets; // all sets of the first element, then of the next
        std::vector<float> sizes;   // ElementTerms::sizes(), which root_free reads
        std::unique_ptr<const ElementTerms> terms; // if some sets are boxes, or for a least
    };
    Measured measure(const formula::Bindings<float>& bindings, const Region& region,
                     int threads) const;
    RootFree root_free(const ElementTerms& terms, const formula::Bindings<float>& bindings,
                       const Region& region, Tolerances& left_out) const;
    // The key size above which keys are irrelevant, and the consequences for roots.
    float least_left_out(const LeastAtRoots& at_roots, const ElementTerms& terms,
                         const formula::Bindings<float>& bindings, const Region& region,
                         RootFree& root_free) const;
    static Tolerances choose(const ElementTerms& terms, std::vector<double> little,
                             const Region& region);

    formula::ElementKernels kernels_;
    SumsAtRoots roots_;
    std::optional<LeastAtRoots> least_;
};

} // namespace isomotion::elements
