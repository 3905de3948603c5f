// A surface's field F: the formula and all programs derived from it, for both back ends.
#pragma once

#include <memory>
#include <set>
#include <string>
#include <string_view>

#include "formula/evaluate/evaluate.h"
#include "formula/glsl/glsl.h"
#include "formula/glsl/kernel_calls.h"
#include "formula/graph/program.h"
#include "formula/graph/recentred.h"
#include "formula/graph/repeated_terms.h"
#include "formula/graph/vocabulary.h"

namespace isomotion::formula {

inline constexpr int first_direction = 3; // inputs 3, 4, 5: the ray's direction

struct KeptEnclosures;

struct Field {
    std::string text;           // as the user wrote it
    std::size_t nodes_read = 0; // of the graph as read from it

    // The graph keeps primitives (chebyshev) whole; the programs run their lowered form.
    Graph graph;
    NodeId root = 0;

    Program value;        // inputs x y z          -> F
    Program directional;  // inputs x y z dx dy dz -> F, dF/dt for the ray p + t d
    Program gradient;     // inputs x y z          -> F_x, F_y, F_z
    ArrayPacking packing; // the fields that each array must supply, in storage order
    double scale = 1;     // F is the user's formula times this power of two
    Origin origin;        // where, in the user's coordinates, x, y and z are 0
    // Above 0 if jumps of F across 0 are walls: the distance from a jump within which the gradient
    // is the wall's normal, see graph/walls.h.
    double wall_distance = 0;
    std::shared_ptr<KeptEnclosures> kept; // programs over boxes: enclosure.h
};

// Inputs of the vocabulary are replaced by coordinate_names. `repeated` takes the numbers of terms
// that are written out many times, and that the field reads as arrays behind the vocabulary's: see
// graph/repeated_terms.h. Without it, terms stay as they are written. Coordinates are counted from
// `origin`. Throws ParseError.
Field make_field(std::string_view text, Vocabulary vocabulary,
                 std::vector<ElementNumbers>* repeated = nullptr, const Origin& origin = {});
// What tells a field from others: its text and, where it is not 0, the point that its coordinates
// are counted from.
std::string identity(const Field& field);
// The field times a power of two.
Field scaled(Field field, double scale);
// The same field with a larger packing: after what F reads, the fields that a program beside it
// reads of arrays.
Field with_elements_of(Field field, const Program& beside);
// The same field with walls where F jumps.
Field with_walls(Field field, double distance);

// float field(vec3 p); vec2 field_directional(vec3 p, vec3 d); vec3 field_gradient(vec3 p)
GlslSignature value_signature();
GlslSignature directional_signature();
GlslSignature gradient_signature();
std::string glsl_value(const Field& field);
std::string glsl_directional(const Field& field);
std::string glsl_gradient(const Field& field);

// Evaluates the field in T (float or double) at one point.
template<class T> class FieldEvaluator {
public:
    explicit FieldEvaluator(const Field& field)
        : value_(field.value)
        , directional_(field.directional)
        , gradient_(field.gradient) {}

    T value(const Bindings<T>& bindings, const std::array<T, 3>& p) {
        T f{};
        value_.point(bindings, p, {&f, 1});
        return f;
    }
    // F and dF/dt.
    std::array<T, 2> directional(const Bindings<T>& bindings, const std::array<T, 3>& p,
                                 const std::array<T, 3>& d) {
        const std::array<T, 6> inputs{p[0], p[1], p[2], d[0], d[1], d[2]};
        std::array<T, 2> result{};
        directional_.point(bindings, inputs, result);
        return result;
    }
    std::array<T, 3> gradient(const Bindings<T>& bindings, const std::array<T, 3>& p) {
        std::array<T, 3> result{};
        gradient_.point(bindings, p, result);
        return result;
    }

private:
    Evaluator<T> value_, directional_, gradient_;
};

} // namespace isomotion::formula
