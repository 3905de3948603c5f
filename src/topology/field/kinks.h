// Splits a formula with kinks into smooth formulas.
//
// min, max, abs and the root of a sum of squares are smooth except for some |h|: min(a, b) is (a +
// b - |a - b|)/2. Where h < 0 or h > 0 the formula equals that of one side. Where h = 0 its slopes
// are those of m h for all multipliers m with |m| <= 1 (Clarke 1983, 2.3.10). So let L(x, m) be the
// formula with m_j h_j in place of each |h_j| of c kinks. The critical points of L along x and m
// are the points with all h_j = 0 at which 0 is a mean of the active slopes. The Hessian of L there
// has c negative eigenvalues more than that of F along the kinks (Jongen and Pallaschke 1988;
// docs/topology-proofs.md).
//
// A root of c_1 v_1^2 + c_2 v_2^2 + ... has a cone where all v are 0. There it is replaced by c_1
// m_1 v_1 + ... with c_1 m_1^2 + ... <= 1.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "topology/field/motion.h"
#include "topology/field/smooth_joints.h"
#include "topology/field/space_box.h"

namespace isomotion::topology {

// Inputs that are added to |h|, one per kink.
inline constexpr int first_height_input = first_multiplier_input + 8;

// A kink that a point of the formula is on.
struct Kink {
    std::size_t first = 0;                  // index of its first multiplier
    std::vector<formula::Interval> weights; // c, one per multiplier
    // The tip of the cone is excluded: multipliers are those of places beside it, sum of c m^2 = 1.
    bool is_beside = false;

    // Sum of c m^2. It is 1 at the ends of the range of slopes that the kink has.
    formula::Interval reach(std::span<const formula::Interval> multipliers) const;
};

// A formula and the values of its names.
struct BoundFormula {
    formula::Graph graph;
    formula::NodeId root{};
    formula::Bindings<formula::Interval> bindings;
    std::vector<Narrower> narrower{}; // what its smooth formulas may be written as
};

// Splits a formula by the signs of h, kink by kink, the outermost first. Keeps the answers to
// former questions. Use one per thread.
class KinkTree {
public:
    // Inputs of the formula are x, y, z and the clock; least() becomes min() of its elements. Kinks
    // that meet may have at most so many multipliers, since more equations than coordinates have a
    // solution only by coincidence.
    KinkTree(BoundFormula formula, std::size_t most_multipliers);
    KinkTree(const KinkTree&) = delete;
    KinkTree& operator=(const KinkTree&) = delete;
    ~KinkTree();

    const BoundFormula& formula() const { return formula_; }
    bool has_kinks() const;

    struct Branch;
    // The smooth formulas at some places and clocks: at each of these F equals one of them. The
    // formula of a cone also represents the points beside its tip. Empty if there are more than
    // `most`, or kinks that meet with too many multipliers.
    std::optional<std::vector<const Branch*>> pieces(const SpaceBox& place, formula::Interval clock,
                                                     std::size_t most);
    // The same with the formulas of the kinks: each critical point there is one of one of these, on
    // its sides.
    std::optional<std::vector<const Branch*>> strata(const SpaceBox& place, formula::Interval clock,
                                                     std::size_t most);

    // The root of such a formula: L, with multipliers as inputs from first_multiplier_input on, and
    // one more input for each |h|, which is added to it, from first_height_input on.
    static formula::NodeId root(const Branch& branch);
    static std::span<const Kink> kinks(const Branch& branch);
    static std::span<const formula::Interval> ranges(const Branch& branch); // of multipliers
    // Identifies a formula; the same in each tree of one formula.
    static const std::vector<char>& path(const Branch& branch);

    // Whether a place is on the formula's sides of all kinks that the formula isn't on.
    enum class Sides { yes, no, unknown };
    Sides is_on_sides(const Branch& branch, const SpaceBox& place, formula::Interval clock,
                      std::span<const formula::Interval> multipliers);

private:
    struct Question;
    bool descend(Branch& branch, std::span<formula::Interval> inputs, bool with_kinks,
                 std::size_t most, std::vector<const Branch*>& found);
    formula::Interval asked(const Branch& branch, std::span<const formula::Interval> inputs);
    Branch& below(Branch& branch, char side);
    std::unique_ptr<Branch> make(formula::NodeId root, std::vector<Narrower> narrower,
                                 std::vector<Kink> kinks, std::vector<formula::NodeId> beside,
                                 std::vector<char> path);

    BoundFormula formula_;
    std::size_t most_multipliers_;
    std::unique_ptr<Branch> root_;
};

// The motion's field, with the motion's own bindings as intervals.
BoundFormula bound_formula(const Motion& motion);

} // namespace isomotion::topology
