// F and its derivatives in space and by the clock, over boxes as intervals and at points as
// doubles.
//
// A stratum of the bounds is its inside, a face, an edge or a corner: there the coordinates that
// are not free follow the bounds, and F is a function of those that are, and of the clock.
// Everything below is about these variables: x, y, z without the fixed ones, then the clock. Where
// all three are free they may drift with the surface (ComovingFrame): then it is about their places
// at rest.
//
// Of sums over an array only the elements that matter in a box are evaluated; what the others add
// to each sum is enclosed once for the box and all boxes in it (Elements).
#pragma once

#include <array>
#include <span>
#include <vector>

#include "formula/evaluate/evaluate.h"
#include "formula/graph/program.h"
#include "formula/interval/interval.h"
#include "topology/field/comoving_frame.h"
#include "topology/field/motion.h"

namespace isomotion::topology {

inline constexpr std::size_t most_variables = 4;

using Box = std::array<formula::Interval, most_variables>; // those beyond the variables stay 0
using Point = std::array<double, most_variables>;

inline Box at_point(const Point& p) { return {p[0], p[1], p[2], p[3]}; }

struct Stratum {
    enum class End : char { free, low, high };
    std::array<End, 3> axes{End::free, End::free, End::free};

    int dimension() const;
    bool operator==(const Stratum&) const = default;
};

// All strata of a box, its inside first.
std::vector<Stratum> strata_of_box();

// Enclosures of all that F does over a box, or its values at a point.
template<class T> struct Jet {
    T value{};
    std::array<T, most_variables> gradient{};
    // Second derivatives; the row of the clock stays 0: nothing asks.
    std::array<std::array<T, most_variables>, most_variables> hessian{};
};

class MovingField {
public:
    MovingField(const Motion& motion, const Stratum& stratum, const ComovingFrame& drift = {});

    int variables() const { return variables_; }
    int dimension() const { return variables_ - 1; }
    const Stratum& stratum() const { return stratum_; }
    // Holds the stratum at all times.
    const Box& domain() const { return domain_; }
    // Free coordinate k of the points in a box.
    formula::Interval x(const Box& box, std::size_t k) const;

private:
    friend class Enclosures;
    friend class Numbers;

    // Inputs after the variables, of which there are none where the coordinates don't drift: the
    // clock's ends, and [-1, 1].
    std::size_t ends() const { return comoving_.rests() ? 0 : 3; }
    std::size_t first_rest() const { return std::size_t(variables_) + ends(); }
    // The roots with what is linear in the clock by its values at the clock's ends.
    std::vector<formula::NodeId> between_ends(formula::Graph& graph,
                                              std::span<const formula::NodeId> roots) const;

    struct Culling {
        int array = -1;          // whose elements are left out; -1: none
        std::vector<int> fields; // of the array, that terms depend on
        formula::Program
            terms; // inputs: variables, ends, then fields; one element's part of each sum
        int sums = 0;
    };

    // The roots with an input added to each sum whose elements are culled.
    std::vector<formula::NodeId> with_rests(formula::Graph& graph,
                                            std::span<const formula::NodeId> roots);

    Stratum stratum_;
    ComovingFrame comoving_;
    int variables_ = 0;
    Box domain_;
    Culling culling_;
    formula::Bindings<double> bindings_;
    // Inputs: the variables, their ends, then what is added to each sum.
    formula::Program value_;    // F
    formula::Program gradient_; // F, first derivatives
    formula::Program jet_;      // F, first derivatives, second ones: by rows from the diagonal on
    formula::Program numbers_;  // the same for doubles
    formula::Program place_;    // at least 0 in the closed stratum, for each condition
    formula::Program inward_;   // derivatives of F inwards along the fixed axes
};

// The elements that matter, and what the others add to each sum.
struct Elements {
    formula::Bindings<formula::Interval> bindings;
    std::vector<formula::Interval> rest;
};

// Evaluates over boxes. One a thread.
class Enclosures {
public:
    explicit Enclosures(const MovingField& field);

    const Elements& all() const { return all_; }
    // Those of `from` that matter in the box, which `from` must hold for: of which some term is
    // more than `negligible` times the largest such term.
    Elements near(const Box& box, const Elements& from, double negligible);

    // Jets without second derivatives, and with them.
    void gradients(const Elements& elements, std::span<const Box> boxes,
                   std::vector<Jet<formula::Interval>>& jets);
    void jets(const Elements& elements, std::span<const Box> boxes,
              std::vector<Jet<formula::Interval>>& jets);
    Jet<formula::Interval> jet(const Box& box);
    void values(const Elements& elements, std::span<const Box> boxes,
                std::vector<formula::Interval>& values);

    enum class Place { outside, inside, unknown };
    Place place(const Box& box); // in the stratum
    // r^2 - |x - c|^2 of the sphere that bounds the inside.
    formula::Interval reach(const Box& box);
    // The derivatives of F inwards along the fixed axes.
    std::vector<formula::Interval> inward(const Box& box);

private:
    // At least 0 in the closed stratum.
    std::span<const formula::Interval> conditions(const Box& box);
    void load(const Elements& elements, std::span<const Box> boxes);
    void run(formula::Evaluator<formula::Interval>& program, const Elements& elements,
             std::size_t outputs);

    const MovingField& field_;
    Elements all_;
    formula::Evaluator<formula::Interval> value_, gradient_, jet_, place_, inward_, terms_;
    std::vector<std::vector<formula::Interval>> inputs_, outputs_;
    std::vector<formula::Interval> conditions_;
};

// Evaluates at points, with all elements.
class Numbers {
public:
    explicit Numbers(const MovingField& field);

    Jet<double> jet(const Point& point);
    void jets(std::span<const Point> points, std::vector<Jet<double>>& jets);

private:
    const MovingField& field_;
    formula::Evaluator<double> evaluator_;
    std::vector<std::vector<double>> inputs_, outputs_;
};

} // namespace isomotion::topology
