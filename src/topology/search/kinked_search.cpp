#include "topology/search/kinked_search.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/workers.h"
#include "formula/interval/prune.h"
#include "topology/field/rising.h"
#include "topology/search/critical_system.h"
#include "topology/search/stratum_places.h"

namespace isomotion::topology {
namespace {

using formula::Interval, formula::Judged;
using Branch = KinkTree::Branch;

// Smooth formulas that a box may be asked for.
constexpr std::size_t most_pieces = 48, most_strata = 96;
// Parts of the domain: larger boxes are halved first, if they have a kink.
constexpr double small = 0.3;
// Slopes of a cone are taken from so many parts of each multiplier's range.
constexpr int parts_of_range = 16;
constexpr int most_narrowings = 6;
// Ranges of two and more multipliers are divided, so far and into so many.
constexpr double narrowest_part = 1.0 / 32;
constexpr int most_parts = 64;
// With more unresolved boxes than this in a task the smallest box grows: a curve of them.
constexpr std::size_t too_many_kinked = 64;

enum class Verdict { nothing, point, open };

bool may_be_0(const Jet<Interval>& jet, std::size_t derivatives) {
    if (!contains(jet.value, 0.0)) return false;
    for (std::size_t k = 0; k < derivatives; ++k) {
        if (!contains(jet.gradient[k], 0.0)) return false;
    }
    return true;
}

// What a thread evaluates with.
class Worker {
public:
    Worker(const Motion& motion, const Stratum& stratum)
        : motion_(motion)
        , stratum_(stratum)
        , tree_(bound_formula(motion), std::size_t(stratum.dimension()))
        , whole_(with_field(motion, tree_.formula(), tree_.formula().root), stratum)
        , places_(motion, stratum)
        , enclosures_(whole_) {}

    struct Formula {
        std::shared_ptr<const Selection> selection;
        Enclosures enclosures;
        Numbers numbers;

        explicit Formula(std::shared_ptr<const Selection> of)
            : selection(std::move(of))
            , enclosures(selection->field())
            , numbers(selection->field()) {}
        const MovingField& field() const { return selection->field(); }
    };

    const MovingField& whole() const { return whole_; }
    Enclosures& enclosures() { return enclosures_; }
    KinkTree& tree() { return tree_; }
    SpaceBox place(const Box& box) const { return places_.at(whole_, box); }
    // Formulas are made again where they are asked for later: a search may meet very many.
    void forget_formulas() {
        if (formulas_.size() > most_kept) formulas_.clear();
    }
    Formula& formula(const Branch& branch) {
        auto& made = formulas_[&branch];
        if (!made) {
            made = std::make_unique<Formula>(
                std::make_shared<Selection>(motion_, stratum_, tree_, branch));
        }
        return *made;
    }

private:
    static constexpr std::size_t most_kept = 512;

    const Motion& motion_;
    Stratum stratum_;
    KinkTree tree_;
    MovingField whole_;
    StratumPlaces places_;
    Enclosures enclosures_;
    std::map<const Branch*, std::unique_ptr<Formula>> formulas_;
};

class KinkedTask {
public:
    KinkedTask(Worker& worker, const SearchOptions& searching)
        : worker_(worker)
        , searching_(searching)
        , d_(std::size_t(worker.whole().dimension()))
        , smallest_(searching.smallest) {}

    KinkedResult run(const Box& box) {
        const auto judge = [&](const Box& now) {
            if (is_stopped()) return Judged::refused;
            worker_.forget_formulas();
            ++found_.work.boxes;
            if (is_settled(now)) return Judged::settled;
            if (size(now) > smallest_) return Judged::open;
            found_.unresolved.push_back(now);
            if (found_.unresolved.size() % too_many_kinked == 0) smallest_ *= 4;
            return Judged::settled;
        };
        if (!formula::prune(box, worker_.whole().domain(), sides(), judge))
            found_.unresolved.push_back(box); // the search was stopped
        return std::move(found_);
    }

private:
    bool is_stopped() const { return searching_.stopped && searching_.stopped(); }

    formula::Sides sides() const { return {0, d_ + 1}; }
    double size(const Box& box) const {
        return formula::longest_side(box, worker_.whole().domain(), sides()).part;
    }

    bool is_settled(const Box& box) {
        Enclosures& enclosures = worker_.enclosures();
        if (enclosures.place(box) == Enclosures::Place::outside) return true;
        std::vector<Jet<Interval>> jets;
        enclosures.gradients(enclosures.all(), {&box, 1}, jets);
        if (!may_be_0(jets[0], d_)) return true;

        const SpaceBox place = worker_.place(box);
        const auto pieces = worker_.tree().pieces(place, box[d_], most_pieces);
        if (!pieces) return false;
        if (is_regular(box, *pieces)) return true;
        if (pieces->size() > 1 && size(box) > small) return false;
        const auto strata = worker_.tree().strata(place, box[d_], most_strata);
        if (!strata) return false;
        const std::size_t before = found_.points.size();
        const bool are_settled = std::ranges::all_of(*strata, [&](const Branch* branch) {
            return !is_stopped() && solve(box, *branch) != Verdict::open;
        });
        // The points are found again when the halves are searched.
        if (!are_settled) found_.points.resize(before);
        return are_settled;
    }

    // The variables of a formula: all of its multipliers with a box.
    static Box with_multipliers(const MovingField& field, const Box& box) {
        Box all = field.domain();
        const auto d = std::size_t(field.dimension());
        std::copy_n(box.begin(), d, all.begin());
        all[field.clock()] = box[d];
        return all;
    }
    Box of_coordinates(const MovingField& field, const Box& box) const {
        Box own{};
        std::copy_n(box.begin(), d_, own.begin());
        own[d_] = box[field.clock()];
        return own;
    }

    // Whether 0 is in no hull of slopes of those pieces that may be 0 in the box.
    bool is_regular(const Box& box, std::span<const Branch* const> pieces) {
        std::vector<Box> gradients;
        std::vector<Jet<Interval>> jets, at_middle;
        for (const Branch* branch : pieces) {
            if (is_stopped()) return false;
            Worker::Formula& formula = worker_.formula(*branch);
            Enclosures& enclosures = formula.enclosures;
            const Box all = with_multipliers(formula.field(), box);
            enclosures.gradients(enclosures.all(), {&all, 1}, jets);
            if (!contains(jets[0].value, 0.0)) continue;
            Box middle = all;
            for (Interval& side : middle) side = mid(side);
            enclosures.gradients(enclosures.all(), {&middle, 1}, at_middle);
            Interval value = at_middle[0].value;
            const auto n = std::size_t(formula.field().variables());
            for (std::size_t k = 0; k < n; ++k)
                value = value + jets[0].gradient[k] * (all[k] - middle[k]);
            if (!contains(value, 0.0)) continue;
            Box& gradient = gradients.emplace_back();
            std::copy_n(jets[0].gradient.begin(), d_, gradient.begin());
        }
        constexpr std::array<std::size_t, 3> axes{0, 1, 2};
        return gradients.empty() || rising_direction(gradients, std::span(axes).first(d_));
    }

    Verdict solve(const Box& box, const Branch& branch) {
        Worker::Formula& formula = worker_.formula(branch);
        const Box all = with_multipliers(formula.field(), box);
        for (const Kink& kink : formula.selection->kinks()) {
            if (kink.is_beside)
                return is_off_beside(formula, all, kink) ? Verdict::nothing : Verdict::open;
        }
        return solve_parts(formula, branch, all);
    }

    // Multipliers of kinks inside of others enter as products: parts of their ranges, until in each
    // of them all is linear enough.
    Verdict solve_parts(Worker::Formula& formula, const Branch& branch, const Box& all) {
        const MovingField& field = formula.field();
        const auto d = std::size_t(field.dimension());
        const formula::Sides multipliers{d, field.clock()};
        const bool is_alone = field.clock() < d + 2;
        Verdict verdict = Verdict::nothing;
        int tries = 0;
        const auto judge = [&](const Box& now) {
            const Verdict here = solve(formula, branch, now);
            if (here == Verdict::point) verdict = here;
            if (here != Verdict::open) return Judged::settled;
            const bool is_narrow =
                formula::longest_side(now, all, multipliers).part <= narrowest_part;
            return is_narrow || is_alone || tries++ > most_parts ? Judged::refused : Judged::open;
        };
        return formula::prune(all, all, multipliers, judge) ? verdict : Verdict::open;
    }

    // Beside a cone the multipliers' reach is 1: no slopes there are 0 together.
    static bool is_off_beside(Worker::Formula& formula, const Box& all, const Kink& kink) {
        const MovingField& field = formula.field();
        const auto d = std::size_t(field.dimension());
        std::vector<Box> cells{all};
        for (std::size_t k = 0; k < kink.weights.size(); ++k) {
            std::vector<Box> parts;
            for (const Box& cell : cells) {
                const std::size_t side = d + kink.first + k;
                const double from = cell[side].lo, step = (cell[side].hi - from) / parts_of_range;
                for (int p = 0; p < parts_of_range; ++p) {
                    Box& made = parts.emplace_back(cell);
                    if (p > 0) made[side].lo = from + p * step;
                    if (p + 1 < parts_of_range) made[side].hi = from + (p + 1) * step;
                }
            }
            cells = std::move(parts);
        }
        std::erase_if(cells, [&](const Box& cell) {
            return !contains(kink.reach(formula.selection->multipliers(cell)), 1.0);
        });
        std::vector<Jet<Interval>> jets;
        formula.enclosures.gradients(formula.enclosures.all(), cells, jets);
        return std::ranges::none_of(jets, [&](const auto& jet) { return may_be_0(jet, d); });
    }

    Verdict solve(Worker::Formula& formula, const Branch& branch, Box x) {
        const auto n = std::size_t(formula.field().variables());
        Enclosures& enclosures = formula.enclosures;
        for (int narrowing = 0; narrowing < most_narrowings; ++narrowing) {
            if (!narrow_multipliers(formula, x)) return Verdict::nothing;
            const Jet<Interval> jet = enclosures.jet(x);
            if (!may_be_0(jet, n - 1)) return Verdict::nothing;
            Point m{};
            for (std::size_t k = 0; k < n; ++k) m[k] = mid(x[k]);
            const auto at_m = residual(enclosures.jet(at_point(m)), n);
            const IntervalMatrix slopes = jacobian(jet, n);
            if (is_off(x, m, at_m, slopes, n)) return Verdict::nothing;
            const auto y = middle_inverse(slopes, int(n));
            if (!y) return Verdict::open;
            const Krawczyk k = krawczyk(x, m, at_m, slopes, *y, int(n));
            if (k.is_empty) return Verdict::nothing;
            if (k.is_inside || k.contraction < 1) {
                if (const auto point = isolate(formula.field(), enclosures, formula.numbers, x))
                    return judge(formula, branch, *point);
            }
            double shrinks = 1;
            for (std::size_t i = 0; i < n; ++i) {
                const double before = x[i].hi - x[i].lo;
                x[i] = intersect(x[i], k.image[i]);
                if (is_empty(x[i])) return Verdict::nothing;
                if (before > 0) shrinks *= (x[i].hi - x[i].lo) / before;
            }
            if (!(shrinks < 0.9)) break;
        }
        return Verdict::open;
    }

    // The slopes f along the coordinates are linear in the multipliers, f(m) = f(m_0) + S (m -
    // m_0): where they are 0, m = m_0 - P f(m_0) - (P S - 1)(m - m_0) for any P, best the
    // pseudoinverse of the middle of S. False if there are no such multipliers.
    static bool narrow_multipliers(Worker::Formula& formula, Box& x) {
        const MovingField& field = formula.field();
        const auto d = std::size_t(field.dimension());
        const std::size_t c = formula.selection->multipliers();
        if (c == 0) return true;
        Enclosures& enclosures = formula.enclosures;
        Box at_middle = x;
        for (std::size_t j = 0; j < c; ++j) at_middle[d + j] = mid(x[d + j]);
        const Jet<Interval> jet = enclosures.jet(x), f = enclosures.jet(at_middle);
        const auto slope = [&](std::size_t i, std::size_t j) { return jet.hessian[i][d + j]; };
        Matrix squared{};
        for (std::size_t i = 0; i < d; ++i) {
            for (std::size_t j = 0; j < c; ++j) {
                if (std::isinf(magnitude(slope(i, j)))) return true;
                for (std::size_t l = 0; l < c; ++l)
                    squared[j][l] += mid(slope(i, j)) * mid(slope(i, l));
            }
        }
        const auto y = inverse(squared, int(c));
        if (!y) return true;
        for (std::size_t j = 0; j < c; ++j) {
            std::array<Interval, 3> row{}; // of P
            for (std::size_t i = 0; i < d; ++i) {
                double entry = 0;
                for (std::size_t l = 0; l < c; ++l) entry += (*y)[j][l] * mid(slope(i, l));
                row[i] = entry;
            }
            Interval image = at_middle[d + j];
            for (std::size_t i = 0; i < d; ++i) image = image - row[i] * f.gradient[i];
            for (std::size_t l = 0; l < c; ++l) {
                Interval rest(j == l ? -1.0 : 0.0);
                for (std::size_t i = 0; i < d; ++i) rest = rest + row[i] * slope(i, l);
                image = image - rest * (x[d + l] - at_middle[d + l]);
            }
            if (std::isnan(image.lo) || std::isnan(image.hi)) return true;
            x[d + j] = intersect(x[d + j], image);
            if (is_empty(x[d + j])) return false;
        }
        const auto multipliers = formula.selection->multipliers(x);
        return std::ranges::none_of(formula.selection->kinks(), [&](const Kink& kink) {
            return kink.reach(multipliers).lo > 1;
        });
    }

    // Whether some equation has no root, by mean values.
    static bool is_off(const Box& x, const Point& m, const Box& at_m, const IntervalMatrix& slopes,
                       std::size_t n) {
        for (std::size_t i = 0; i < n; ++i) {
            Interval value = at_m[i];
            for (std::size_t k = 0; k < n; ++k)
                value = value + slopes[i][k] * (x[k] - Interval(m[k]));
            if (!contains(value, 0.0)) return true;
        }
        return false;
    }

    // A root of a formula is a critical point of F where F is that formula and 0 inside of the hull
    // of all slopes.
    Verdict judge(Worker::Formula& formula, const Branch& branch, const CriticalPoint& point) {
        const Selection& selection = *formula.selection;
        const auto multipliers = selection.multipliers(point.where);
        const Box own = of_coordinates(formula.field(), point.where);
        const SpaceBox place = worker_.place(own);
        bool is_certain = true;
        for (const Kink& kink : selection.kinks()) {
            const Interval reach = kink.reach(multipliers);
            if (reach.lo > 1) return Verdict::nothing;
            is_certain &= reach.hi < 1;
        }
        switch (worker_.tree().is_on_sides(branch, place, own[d_], multipliers)) {
        case KinkTree::Sides::no:
            return Verdict::nothing;
        case KinkTree::Sides::unknown:
            return Verdict::open;
        case KinkTree::Sides::yes:
            break;
        }
        if (!is_certain) return Verdict::open;
        int across = 0;
        const std::vector<Interval> heights = selection.heights(point.where, place);
        for (std::size_t k = 0; k < heights.size(); ++k) {
            const int sign = sign_of(heights[k]);
            if (sign == 0) return Verdict::open;
            if (sign < 0) across += int(selection.kinks()[k].weights.size());
        }
        found_.points.push_back(
            {formula.selection, point, across, std::vector(KinkTree::path(branch))});
        return Verdict::point;
    }

    Worker& worker_;
    const SearchOptions& searching_;
    std::size_t d_;
    double smallest_;
    KinkedResult found_;
};

// Keeps each point once: points of one formula may be found from several boxes.
void put_together(KinkedResult& all) {
    std::map<std::vector<char>, std::vector<KinkedPoint>> by_formula;
    for (KinkedPoint& point : all.points) by_formula[point.path].push_back(std::move(point));
    all.points.clear();
    for (auto& [path, points] : by_formula) {
        SearchResult of_one;
        for (const KinkedPoint& point : points) of_one.points.push_back(point.point);
        topology::put_together(of_one);
        const MovingField& field = points[0].of->field();
        for (const CriticalPoint& kept : of_one.points) {
            const auto is_it = [&](const KinkedPoint& point) {
                return point.point.where == kept.where && point.point.alone == kept.alone;
            };
            all.points.push_back(*std::ranges::find_if(points, is_it));
        }
        for (const Box& box : of_one.unresolved) {
            Box own{};
            const auto d = std::size_t(field.dimension());
            std::copy_n(box.begin(), d, own.begin());
            own[d] = box[field.clock()];
            all.unresolved.push_back(own);
        }
    }
    std::ranges::stable_sort(all.points, {}, [](const KinkedPoint& point) {
        return point.point.where[point.of->field().clock()].lo;
    });
}

} // namespace

KinkedResult search_kinked(const Motion& motion, const Stratum& stratum,
                           const SearchOptions& searching) {
    KinkedResult all;
    {
        const KinkTree tree(bound_formula(motion), std::size_t(stratum.dimension()));
        all.field = std::make_shared<MovingField>(
            with_field(motion, tree.formula(), tree.formula().root), stratum);
    }
    const std::vector<Box> boxes = tasks(*all.field);
    std::vector<KinkedResult> parts(boxes.size());
    const auto seek = [&] {
        return [&, worker = std::make_shared<Worker>(motion, stratum)](std::size_t k) {
            parts[k] = KinkedTask(*worker, searching).run(boxes[k]);
        };
    };
    base::share({boxes.size(), searching.threads, searching.stopped, searching.progress}, seek);
    for (KinkedResult& part : parts) {
        all.points.insert(all.points.end(), part.points.begin(), part.points.end());
        all.unresolved.insert(all.unresolved.end(), part.unresolved.begin(), part.unresolved.end());
        all.work += part.work;
    }
    put_together(all);
    all.unresolved = merged(std::move(all.unresolved), all.field->domain(), 4 * searching.smallest);
    return all;
}

} // namespace isomotion::topology
