// A formula with kinks as the smooth formulas that it is made of.
//
// min, max, abs and the root of a sum of squares are smooth but for some |h|: min(a, b) is
// (a + b - |a - b|)/2. Where h < 0 or h > 0 the formula is that of one side. Where h = 0 its slopes
// are those of m h for all multipliers m with |m| <= 1 (Clarke 1983, 2.3.10). So let L(x, m) be the
// formula with m_j h_j in place of each |h_j| of some kinks: its critical points along x and m are
// the points of h_j = 0 at which 0 is a mean of the active slopes, and its Hessian there has c
// negative eigenvalues more than that of F along the kinks, of which there are c (Jongen and
// Pallaschke 1988; docs/topology-proofs.md).
//
// A root of c_1 v_1^2 + c_2 v_2^2 + ... has a cone where all v are 0: there it stands for
// c_1 m_1 v_1 + ... with c_1 m_1^2 + ... <= 1.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "topology/field/motion.h"
#include "topology/field/space_box.h"

namespace isomotion::topology {

// Inputs that are added to |h|, one a kink.
inline constexpr int first_height_input = first_multiplier_input + 8;

// A kink that a formula is on.
struct Kink {
    std::size_t first = 0;                  // of its multipliers
    std::vector<formula::Interval> weights; // c, one a multiplier
    // The cone is left out: multipliers are those of places beside it, sum of c m^2 = 1.
    bool is_beside = false;

    // Sum of c m^2, 1 at the ends of what slopes the kink has.
    formula::Interval reach(std::span<const formula::Interval> multipliers) const;
};

// A formula and what its names stand for.
struct BoundFormula {
    formula::Graph graph;
    formula::NodeId root{};
    formula::Bindings<formula::Interval> bindings;
};

// Divides by the signs of h, kink by kink, the outermost first; what it was once asked is kept. One
// a thread.
class KinkTree {
public:
    // Inputs of the formula are x, y, z and the clock; least() becomes min() of its elements. Kinks
    // that meet have at most so many multipliers: more equations than there are coordinates have no
    // solution unless by coincidence.
    KinkTree(BoundFormula formula, std::size_t most_multipliers);
    KinkTree(const KinkTree&) = delete;
    KinkTree& operator=(const KinkTree&) = delete;
    ~KinkTree();

    const BoundFormula& formula() const { return formula_; }
    bool has_kinks() const;

    struct Branch;
    // The smooth formulas at some places, and at clocks, of which F takes one or the other
    // everywhere; a cone's own stands for what is beside it, too. Empty where there are more than
    // `most`, or kinks that meet in too many multipliers.
    std::optional<std::vector<const Branch*>> pieces(const SpaceBox& place, formula::Interval clock,
                                                     std::size_t most);
    // ... and those of the kinks: each critical point there is one of one of these, on its sides.
    std::optional<std::vector<const Branch*>> strata(const SpaceBox& place, formula::Interval clock,
                                                     std::size_t most);

    // The root of a formula among those: L, with multipliers for inputs from first_multiplier_input
    // on, and an input besides that is added to each |h|, from first_height_input on.
    static formula::NodeId root(const Branch& branch);
    static std::span<const Kink> kinks(const Branch& branch);
    static std::span<const formula::Interval> ranges(const Branch& branch); // of multipliers
    // Tells formulas apart; the same in each tree of one formula.
    static const std::vector<char>& path(const Branch& branch);

    // Whether a place is on the formula's sides of all kinks that it isn't on.
    enum class Sides { yes, no, unknown };
    Sides is_on_sides(const Branch& branch, const SpaceBox& place, formula::Interval clock,
                      std::span<const formula::Interval> multipliers);

private:
    struct Question;
    bool descend(Branch& branch, std::span<formula::Interval> inputs, bool with_kinks,
                 std::size_t most, std::vector<const Branch*>& found);
    formula::Interval asked(const Branch& branch, std::span<const formula::Interval> inputs);
    Branch& below(Branch& branch, char side);
    std::unique_ptr<Branch> make(formula::NodeId root, std::vector<Kink> kinks,
                                 std::vector<formula::NodeId> beside, std::vector<char> path);

    BoundFormula formula_;
    std::size_t most_multipliers_;
    std::unique_ptr<Branch> root_;
};

// The motion's field; in the bindings of the motion's own, in intervals.
BoundFormula bound_formula(const Motion& motion);

} // namespace isomotion::topology
