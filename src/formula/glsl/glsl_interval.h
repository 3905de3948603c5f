// Writes a Program as GLSL on intervals.
//
// As glsl.h, but for programs of enclosure.h, and with vec2s (lo, hi), or dvec2s: functions of
// shaders/interval/. Parameters, elements and constants that are floats are points and multiply as
// one number. A constant between two floats is the interval of both. On doubles all constants are
// points. Values that are never negative by their operations alone (squares, roots and the like)
// are known to be so, which saves half of a product and keeps divisors from 0.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "formula/enclosure.h"

namespace isomotion::formula {

enum class Numbers { floats, doubles }; // the type of the intervals' ends

// An array whose lists hold the elements that matter, with F's own sums over it: nodes of the
// field's graph. The k-th sum starts with `array<n>_rest[k]`, a vec2, instead of 0;
// `array<n>_least` is the least of no listed element.
struct ListedArray {
    int array = 0;
    std::vector<NodeId> sums;
};

struct IntervalNumbers {
    IntervalNumbers(Numbers ends = Numbers::floats, const ListedArray* listed_array = nullptr)
        : numbers(ends)
        , listed(listed_array) {}
    Numbers numbers;
    const ListedArray* listed;
};

struct IntervalSignature {
    std::string head;                 // "vec4 field_directional_interval(vec2 x, ...)"
    std::vector<std::string> inputs;  // the name of input k, a vec2
    std::string result;               // the type that takes the outputs in order, or empty and
    std::vector<std::string> outputs; // the variables that they are assigned to
};

std::string emit_interval_glsl(const Program& program, const IntervalSignature& signature,
                               const ArrayPacking& packing, const IntervalNumbers& numbers = {});

// The operations ("divide", "pow", "chebyshev", ...) for which a program needs files of
// shaders/interval/ other than arithmetic.glsl.
std::set<std::string> interval_kernels_used(const Program& program);

// Functions on floats. On doubles each vec stands for a dvec.
IntervalSignature value_interval_signature();
IntervalSignature directional_interval_signature();
IntervalSignature gradient_interval_signature();
IntervalSignature rough_signature();
IntervalSignature breaks_signature();

// vec2 field_interval(vec2 x, vec2 y, vec2 z)
std::string glsl_value_interval(const EnclosurePrograms& programs, const ArrayPacking& packing,
                                const IntervalNumbers& numbers = {});
// vec4 field_directional_interval(vec2 x, vec2 y, vec2 z, vec2 dx, vec2 dy, vec2 dz): F, dF/dt
std::string glsl_directional_interval(const EnclosurePrograms& programs,
                                      const ArrayPacking& packing,
                                      const IntervalNumbers& numbers = {});
// void field_gradient_interval(vec2 x, vec2 y, vec2 z, out vec2 gx, out vec2 gy, out vec2 gz)
std::string glsl_gradient_interval(const EnclosurePrograms& programs, const ArrayPacking& packing,
                                   const IntervalNumbers& numbers = {});

// vec4 field_rough(vec2 x, vec2 y, vec2 z): EnclosurePrograms::rough
std::string glsl_rough(const EnclosurePrograms& programs, const ArrayPacking& packing,
                       const IntervalNumbers& numbers = {});

// vec4 field_breaks(vec2 x, vec2 y, vec2 z): EnclosurePrograms::breaks
std::string glsl_breaks(const EnclosurePrograms& programs, const ArrayPacking& packing,
                        const IntervalNumbers& numbers = {});

// void field_hessian_interval(vec2 x, vec2 y, vec2 z, vec2 dx, vec2 dy, vec2 dz, out vec2 f,
//                          out vec2 slope, out vec2 bx, out vec2 by, out vec2 bz):
//                          hessian_program()
std::string glsl_hessian_interval(const Program& bend, const ArrayPacking& packing,
                                  const IntervalNumbers& numbers);

} // namespace isomotion::formula
