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
#include "topology/field/moving_field.h"

namespace isomotion::topology {

// A kink that a formula is on.
struct Kink {
    std::size_t first = 0;                  // of its multipliers
    std::vector<formula::Interval> weights; // c, one a multiplier
    // The cone is left out: multipliers are those of places beside it, sum of c m^2 = 1.
    bool is_beside = false;

    // Sum of c m^2, 1 at the ends of what slopes the kink has.
    formula::Interval reach(std::span<const formula::Interval> multipliers) const;
};

// A smooth formula: L of the kinks that it is on, on one side of each other one.
class Selection {
public:
    // `motion` has L for its field; in the graph `formula` L has an input for each kink besides,
    // added to |h|.
    Selection(const Motion& motion, const Stratum& stratum, std::vector<Kink> on,
              const formula::Graph& formula, formula::NodeId root);

    const MovingField& field() const { return field_; }
    std::span<const Kink> kinks() const { return kinks_; }
    std::size_t multipliers() const { return multipliers_; }

    // Variables of a box or a point of the field.
    std::span<const formula::Interval> multipliers(const Box& box) const {
        return std::span(box).subspan(std::size_t(field_.dimension()), multipliers_);
    }
    // dL/d|h| for each kink. `place` and clock are those of the box.
    std::vector<formula::Interval> heights(const Box& box,
                                           const std::array<formula::Interval, 3>& place) const;

private:
    std::vector<Kink> kinks_;
    std::size_t multipliers_;
    MovingField field_;
    formula::Bindings<formula::Interval> bindings_;
    formula::Program heights_;
};

// Divides by the signs of h, kink by kink, the outermost first; what it was once asked is kept. One
// a thread.
class KinkTree {
public:
    KinkTree(const Motion& motion, const Stratum& stratum);
    KinkTree(const KinkTree&) = delete;
    KinkTree& operator=(const KinkTree&) = delete;
    ~KinkTree();

    // The motion with least() as min() of its elements.
    const Motion& motion() const { return motion_; }

    struct Branch;
    // The smooth formulas at some places, and at clocks, of which F takes one or the other
    // everywhere; a cone's own stands for what is beside it, too. Empty where there are more than
    // `most`, or kinks that meet in more multipliers than there are coordinates.
    std::optional<std::vector<const Branch*>> pieces(const std::array<formula::Interval, 3>& place,
                                                     formula::Interval clock, std::size_t most);
    // ... and those of the kinks: each critical point there is one of one of these, on its sides.
    std::optional<std::vector<const Branch*>> strata(const std::array<formula::Interval, 3>& place,
                                                     formula::Interval clock, std::size_t most);

    std::shared_ptr<const Selection> selection(const Branch& branch);
    // Whether a place is on the branch's sides of all kinks that it isn't on.
    enum class Sides { yes, no, unknown };
    Sides is_on_sides(const Branch& branch, const std::array<formula::Interval, 3>& place,
                      formula::Interval clock, std::span<const formula::Interval> multipliers);
    // Tells branches apart; the same in each tree of the motion.
    static const std::vector<char>& path(const Branch& branch);

private:
    struct Question;
    bool descend(Branch& branch, std::span<formula::Interval> inputs, bool with_kinks,
                 std::size_t most, std::vector<const Branch*>& found);
    formula::Interval asked(const Branch& branch, std::span<const formula::Interval> inputs);
    Branch& below(Branch& branch, char side);
    std::unique_ptr<Branch> make(formula::NodeId root, std::vector<Kink> kinks,
                                 std::vector<formula::NodeId> beside, std::vector<char> path);

    Stratum stratum_;
    Motion motion_;
    formula::Bindings<formula::Interval> bindings_;
    std::size_t most_multipliers_;
    std::unique_ptr<Branch> root_;
};

// Whether the motion's field has kinks that a KinkTree divides by.
bool has_kinks(const Motion& motion);

} // namespace isomotion::topology
