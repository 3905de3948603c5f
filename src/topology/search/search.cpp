#include "topology/search/search.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "base/workers.h"
#include "formula/interval/prune.h"
#include "topology/search/critical_system.h"

namespace isomotion::topology {
namespace {

using formula::Interval;
using IntervalJet = Jet<Interval>;

// A box is divided into this many tasks, whatever the number of threads.
constexpr std::size_t tasks_at_least = 64;
// At most so many boxes near each other share their elements.
constexpr std::size_t family_size = 96;
// A family that takes up no more than this part of the place that its elements were chosen for gets
// elements of its own; and when it has become so small, they are chosen from fewer.
constexpr double shrunk = 0.25, much_shrunk = 1.0 / 64;
// What no box below may miss, as a part of the largest term; and how much terms that are left out
// may blur a sum in a family, as a part of what intervals of all its terms blur it.
constexpr double negligible = 1e-12, blur = 0.02;
// Boxes evaluated together.
constexpr std::size_t together = 64;
// Where second derivatives end fewer boxes than this part they cost more than they save. After so
// many boxes of one size that is known.
constexpr double worth_hessians = 0.25;
constexpr std::int64_t hessians_to_judge = 16;
// A root is sought in boxes smaller than this part of the domain, whatever Krawczyk's operator
// says.
constexpr double smallest_without_doubt = 1e-3;
// Boxes up to so many times the smallest are among the smallest.
constexpr double among_smallest = 16;
// A box that shrinks to less than this part of itself is not divided.
constexpr double worth_narrowing = 0.6;
// With more unresolved boxes than this in a task the smallest box grows: a curve of them.
constexpr std::size_t too_many = 256;

bool meet(const Box& a, const Box& b) {
    for (std::size_t k = 0; k < most_variables; ++k) {
        if (a[k].hi < b[k].lo || b[k].hi < a[k].lo) return false;
    }
    return true;
}
bool contains(const Box& a, const Box& b) {
    for (std::size_t k = 0; k < most_variables; ++k) {
        if (!formula::contains(a[k], b[k])) return false;
    }
    return true;
}

// How much the equations vary along each side of a box, as a part of all.
using Smear = std::array<double, most_variables>;

class Task {
public:
    Task(const MovingField& field, const SearchOptions& searching, Enclosures& enclosures,
         Numbers& numbers)
        : field_(field)
        , searching_(searching)
        , n_(std::size_t(field.variables()))
        , d_(n_ - 1)
        , smallest_(searching.smallest)
        , enclosures_(enclosures)
        , numbers_(numbers) {}

    SearchResult run(const Box& box) {
        const auto all = std::make_shared<const Elements>(enclosures_.all());
        std::vector<Family> families{{{box}, {all, formula::infinity}, {all, formula::infinity}}};
        std::vector<Box> batch, smaller;
        while (!families.empty()) {
            Family now = std::move(families.back());
            families.pop_back();
            const Box around = hull_of(now.boxes);
            narrow(now, around);
            const Elements& own = *now.own.elements;
            smaller.clear();
            const bool inside = enclosures_.place(around) == Enclosures::Place::inside;
            while (!now.boxes.empty() || !waiting_.empty()) {
                if (is_stopped()) return std::move(found_);
                next_.clear();
                if (!now.boxes.empty() && waiting_.size() < together) {
                    const std::size_t count = std::min(together, now.boxes.size());
                    batch.assign(now.boxes.end() - std::ptrdiff_t(count), now.boxes.end());
                    now.boxes.resize(now.boxes.size() - count);
                    sift(own, batch, inside);
                } else {
                    settle(own);
                }
                smaller.insert(smaller.end(), next_.begin(), next_.end());
            }
            split_family(smaller, now, families);
        }
        return std::move(found_);
    }

private:
    bool is_stopped() const { return searching_.stopped && searching_.stopped(); }

    // Elements for a box of such a volume.
    struct Chosen {
        std::shared_ptr<const Elements> elements;
        double volume;
    };
    // Boxes near each other that share the elements that matter there.
    struct Family {
        std::vector<Box> boxes;
        Chosen kept; // without those that matter nowhere in the family
        Chosen own;  // with the sum of the others by Taylor's formula
    };

    void narrow(Family& family, const Box& around) {
        const double extent = volume(around);
        if (!(extent <= shrunk * family.own.volume)) return;
        if (extent <= much_shrunk * family.kept.volume) {
            family.kept = {std::make_shared<const Elements>(
                               enclosures_.near(around, *family.kept.elements, negligible)),
                           extent};
        }
        family.own = {std::make_shared<const Elements>(
                          enclosures_.expanded(around, *family.kept.elements, blur)),
                      extent};
    }
    // The volume of a box, as a part of the domain's.
    double volume(const Box& box) const {
        double product = 1;
        for (std::size_t k = 0; k < n_; ++k) {
            const double side = part(box, k);
            if (side > 0) product *= side;
        }
        return product;
    }

    Box hull_of(const std::vector<Box>& boxes) const {
        Box all = boxes[0];
        for (const Box& box : boxes) {
            for (std::size_t k = 0; k < n_; ++k) all[k] = hull(all[k], box[k]);
        }
        return all;
    }

    // Splits a family by halves of its longest side, until each family is small or has few boxes.
    void split_family(std::vector<Box> boxes, const Family& of,
                      std::vector<Family>& families) const {
        if (boxes.size() <= family_size) {
            if (!boxes.empty()) families.push_back({std::move(boxes), of.kept, of.own});
            return;
        }
        // The family is split along the side on which the most boxes fit side by side.
        std::size_t side = 0;
        double most = 0, at = 0;
        for (std::size_t k = 0; k < n_; ++k) {
            double low = formula::infinity, high = -formula::infinity, all = 0;
            for (const Box& box : boxes) {
                low = std::min(low, mid(box[k]));
                high = std::max(high, mid(box[k]));
                all += box[k].hi - box[k].lo;
            }
            const double spread = (high - low) * double(boxes.size());
            if (!(spread > most * all)) continue;
            most = spread / all;
            side = k;
            at = low + (high - low) / 2;
        }
        const auto upper = std::partition(boxes.begin(), boxes.end(),
                                          [&](const Box& box) { return mid(box[side]) <= at; });
        std::vector<Box> rest(upper, boxes.end());
        boxes.erase(upper, boxes.end());
        if (boxes.empty() || rest.empty()) { // by rounding
            std::vector<Box>& all = boxes.empty() ? rest : boxes;
            families.push_back({std::move(all), of.kept, of.own});
            return;
        }
        split_family(std::move(boxes), of, families);
        split_family(std::move(rest), of, families);
    }

    // The largest side in space, as a part of the domain's; on corners the clock's.
    double spatial_size(const Box& box) const {
        double size = 0;
        for (std::size_t k = 0; k < std::max<std::size_t>(d_, 1); ++k) {
            size = std::max(size, part(box, k));
        }
        return size;
    }
    double part(const Box& box, std::size_t k) const {
        const double whole = field_.domain()[k].hi - field_.domain()[k].lo;
        return whole > 0 ? (box[k].hi - box[k].lo) / whole : 0;
    }

    bool is_known(const Box& box) const {
        return std::any_of(found_.points.begin(), found_.points.end(), [&](const auto& point) {
            for (std::size_t k = 0; k < n_; ++k) {
                if (!contains(point.alone[k], box[k])) return false;
            }
            return true;
        });
    }

    bool may_be_critical(const IntervalJet& jet) const {
        if (!contains(jet.value, 0.0)) return false;
        for (std::size_t k = 0; k < d_; ++k) {
            if (!contains(jet.gradient[k], 0.0)) return false;
        }
        return true;
    }

    Point middle(const Box& box) const {
        Point m{};
        for (std::size_t k = 0; k < n_; ++k) m[k] = mid(box[k]);
        return m;
    }

    // Sifts boxes by F and first derivatives; what is left and worth it waits for second ones.
    void sift(const Elements& elements, std::vector<Box>& wave, bool inside) {
        std::erase_if(wave, [&](const Box& box) {
            ++found_.work.boxes;
            if (is_known(box)) return is_done(Test::known);
            return !inside && enclosures_.place(box) == Enclosures::Place::outside &&
                   is_done(Test::place);
        });
        // Functions of the clock alone are evaluated once for boxes of one time next to each other.
        std::ranges::stable_sort(
            wave, {}, [&](const Box& box) { return std::pair(box[n_ - 1].lo, box[n_ - 1].hi); });
        enclosures_.gradients(elements, wave, jets_);
        for (std::size_t b = 0; b < wave.size(); ++b) {
            const Box& box = wave[b];
            if (!contains(jets_[b].value, 0.0)) {
                is_done(Test::value);
            } else if (!may_be_critical(jets_[b])) {
                is_done(Test::gradient);
            } else if (is_worth_hessians(box)) {
                waiting_.push_back({box, jets_[b].gradient});
            } else {
                divide(box, typical_smear(box));
            }
        }
    }

    void settle(const Elements& elements) {
        const auto taken = waiting_.end() - std::ptrdiff_t(std::min(together, waiting_.size()));
        centres_.clear();
        for (auto one = taken; one != waiting_.end(); ++one)
            centres_.push_back(at_point(middle(one->box)));
        enclosures_.gradients(elements, centres_, at_centres_);
        // What first derivatives end takes no second ones.
        now_.clear();
        std::size_t kept = 0;
        for (auto one = taken; one != waiting_.end(); ++one) {
            const auto b = std::size_t(one - taken);
            const Interval value =
                mean_value(one->box, centres_[b], at_centres_[b].value, one->gradient);
            if (!contains(value, 0.0)) {
                ++hessians_[size_class(one->box)].ended;
                is_done(Test::value);
                continue;
            }
            now_.push_back(one->box);
            at_centres_[kept++] = at_centres_[b];
        }
        waiting_.erase(taken, waiting_.end());
        enclosures_.jets(elements, now_, jets_);
        for (std::size_t b = 0; b < now_.size() && !is_stopped(); ++b) {
            const auto divided = found_.work.removed[std::size_t(Test::divided)];
            settle(now_[b], jets_[b], at_centres_[b]);
            if (found_.work.removed[std::size_t(Test::divided)] == divided) {
                ++hessians_[size_class(now_[b])].ended;
            }
        }
    }

    // Whether, among boxes of one size, second derivatives have ended enough of them so far; every
    // sixteenth is tried all the same.
    bool is_worth_hessians(const Box& box) {
        Hessians& hessians = hessians_[size_class(box)];
        const bool is_worth = hessians.tried < hessians_to_judge ||
                              double(hessians.ended) >= worth_hessians * double(hessians.tried) ||
                              ++hessians.skipped % 16 == 0;
        hessians.tried += is_worth;
        return is_worth;
    }

    // Halvings of the domain's sides that lead to the box.
    std::size_t size_class(const Box& box) const {
        return std::min(std::size_t(std::max(-std::log2(volume(box)), 0.0)), hessians_.size() - 1);
    }

    bool is_done(Test test) {
        found_.work.count(test);
        return true;
    }

    // F over the box by its value in the middle and its slopes.
    Interval mean_value(const Box& box, const Box& centre, Interval value,
                        const std::array<Interval, most_variables>& gradient) const {
        for (std::size_t k = 0; k < n_; ++k) value = value + gradient[k] * (box[k] - centre[k]);
        return value;
    }

    // Mean values: with the derivatives over the box, values keep near those in its middle.
    bool sharpen(const Box& box, const Point& m, IntervalJet& jet, const IntervalJet& at_m) const {
        Box off{};
        for (std::size_t k = 0; k < n_; ++k) off[k] = box[k] - Interval(m[k]);
        for (std::size_t i = 0; i < d_; ++i) {
            Interval gradient = at_m.gradient[i];
            for (std::size_t j = 0; j < n_; ++j) gradient = gradient + jet.hessian[i][j] * off[j];
            jet.gradient[i] = intersect(jet.gradient[i], gradient);
            if (is_empty(jet.gradient[i]) || !contains(jet.gradient[i], 0.0)) return false;
        }
        if (!contains(mean_value(box, at_point(m), at_m.value, jet.gradient), 0.0)) return false;
        // F is enclosed to second order in space.
        Interval second = at_m.value + jet.gradient[d_] * off[d_];
        for (std::size_t i = 0; i < d_; ++i) {
            Interval gradient = at_m.gradient[i] + Interval(0.5) * jet.hessian[i][i] * off[i];
            for (std::size_t j = 0; j < i; ++j) gradient = gradient + jet.hessian[i][j] * off[j];
            second = second + gradient * off[i];
        }
        return contains(second, 0.0);
    }

    void settle(Box box, IntervalJet jet, const IntervalJet& at_m) {
        const Point m = middle(box);
        if (!may_be_critical(jet) || !sharpen(box, m, jet, at_m)) {
            return found_.work.count(Test::hessian);
        }
        const IntervalMatrix slopes = jacobian(jet, n_);
        const Box at_middle = residual(at_m, n_);
        const auto y = middle_inverse(slopes, int(n_));
        if (y && may_tell(box, estimate(box, at_middle, slopes, *y, int(n_)))) {
            const Krawczyk k = krawczyk(box, m, at_middle, slopes, *y, int(n_));
            if (k.is_empty) return found_.work.count(Test::krawczyk);
            const bool may_be_alone = k.contraction < 1 && holds_middle(box, k);
            if (k.is_inside || may_be_alone || is_small_about_root(box, k)) {
                if (const auto point = isolate(field_, enclosures_, numbers_, box)) {
                    found_.points.push_back(*point);
                    return found_.work.count(Test::isolated);
                }
            }
            double shrinks = 1;
            for (std::size_t i = 0; i < n_; ++i) {
                const double before = box[i].hi - box[i].lo;
                box[i] = intersect(box[i], k.image[i]);
                if (is_empty(box[i])) return found_.work.count(Test::krawczyk);
                if (before > 0) shrinks *= (box[i].hi - box[i].lo) / before;
            }
            if (shrinks < worth_narrowing) {
                next_.push_back(box);
                return found_.work.count(Test::narrowed);
            }
        }
        divide(box, slopes);
    }

    // Whether Krawczyk's operator seems to end the box or to narrow it by as much as counts below;
    // in doubt, yes.
    bool may_tell(const Box& box, const ImageEstimate& image) const {
        constexpr double doubt = 1.05;
        if (spatial_size(box) < smallest_without_doubt) return true;
        double shrinks = 1;
        bool may_be_alone = true;
        for (std::size_t i = 0; i < n_; ++i) {
            const double half = (box[i].hi - box[i].lo) / 2;
            const double shift = std::abs(image.shift[i]), reach = image.reach[i];
            if (doubt * shift > half + reach) return true;
            may_be_alone &= reach < doubt * half && shift < doubt * half;
            if (half > 0)
                shrinks *=
                    (std::min(half, shift + reach) + std::min(half, reach - shift)) / 2 / half;
        }
        return may_be_alone || shrinks < doubt * worth_narrowing;
    }

    // Whether the box holds the middle of its image, which is about where its root would be. To
    // isolate a root takes all elements of sums, and fails where there is none.
    bool holds_middle(const Box& box, const Krawczyk& k) const {
        for (std::size_t i = 0; i < n_; ++i) {
            if (!contains(box[i], mid(k.image[i]))) return false;
        }
        return true;
    }

    // Whether the box is so small that a root is sought in it whatever else the image tells. While
    // it isn't among the smallest, its image is to have its middle in it, or beside it by less than
    // half of a side: a root on a face is between two boxes.
    bool is_small_about_root(const Box& box, const Krawczyk& k) const {
        const double size = spatial_size(box);
        if (!(size < smallest_without_doubt)) return false;
        if (size < among_smallest * smallest_) return true;
        for (std::size_t i = 0; i < n_; ++i) {
            const double beside = 0.5 * (box[i].hi - box[i].lo), at = mid(k.image[i]);
            if (at < box[i].lo - beside || at > box[i].hi + beside) return false;
        }
        return true;
    }

    // Halves twice the side by which the equations vary most, where each equation counts by its
    // part that each side has. A box is divided into four since second derivatives cost more than
    // they exclude: they are worth evaluating at every other halving.
    void divide(const Box& box, const IntervalMatrix& slopes) {
        Smear smear{};
        for (std::size_t i = 0; i < n_; ++i) {
            std::array<double, most_variables> parts{};
            double all = 0;
            for (std::size_t k = 0; k < n_; ++k) {
                parts[k] = magnitude(slopes[i][k]) * (box[k].hi - box[k].lo);
                all += parts[k];
            }
            if (!(all > 0) || std::isinf(all)) continue;
            for (std::size_t k = 0; k < n_; ++k) smear[k] += parts[k] / all;
        }
        for (std::size_t k = 0; k < n_; ++k) {
            const double side = part(box, k);
            if (side > 0) smear_[k] += 0.01 * (smear[k] / side - smear_[k]);
        }
        divide(box, smear);
    }

    void divide(const Box& box, Smear smear) {
        const auto first = side_to_halve(box, smear);
        if (!first) {
            found_.unresolved.push_back(box);
            found_.work.count(Test::smallest);
            if (found_.unresolved.size() % too_many == 0) smallest_ *= 4;
            return;
        }
        found_.work.count(Test::divided);
        smear[*first] /= 2;
        for (const Box& half : halves(box, *first)) {
            const auto second = side_to_halve(half, smear);
            if (second) {
                for (const Box& quarter : halves(half, *second)) next_.push_back(quarter);
            } else {
                next_.push_back(half);
            }
        }
    }

    Smear typical_smear(const Box& box) const {
        Smear smear{};
        for (std::size_t k = 0; k < n_; ++k) smear[k] = smear_[k] * part(box, k);
        return smear;
    }

    std::optional<std::size_t> side_to_halve(const Box& box, const Smear& smear) const {
        double most = 0, widest = 0;
        for (std::size_t k = 0; k < n_; ++k) widest = std::max(widest, part(box, k));
        std::optional<std::size_t> side;
        for (std::size_t k = 0; k < n_; ++k) {
            const double width = part(box, k);
            // Slivers help nobody.
            if (!(width > smallest_) || width < widest / 64) continue;
            if (!formula::is_divisible(box[k])) continue;
            const double by = smear[k] + 1e-3 * width / widest;
            if (by <= most) continue;
            most = by;
            side = k;
        }
        return side;
    }

    static std::array<Box, 2> halves(const Box& box, std::size_t side) {
        std::array<Box, 2> two{box, box};
        two[0][side].hi = two[1][side].lo = mid(box[side]);
        return two;
    }

    const MovingField& field_;
    const SearchOptions& searching_;
    std::size_t n_, d_;
    double smallest_;
    Enclosures& enclosures_;
    Numbers& numbers_;
    SearchResult found_;
    struct Hessians {
        std::int64_t tried = 0, ended = 0, skipped = 0;
    };
    std::array<Hessians, 128> hessians_{};
    Smear smear_{}; // of late, for each whole side
    struct Waiting {
        Box box;
        std::array<Interval, most_variables> gradient;
    };
    std::vector<Waiting> waiting_;
    std::vector<Box> next_, now_, centres_;
    std::vector<IntervalJet> jets_, at_centres_;
};

} // namespace

std::vector<Box> tasks(const MovingField& field) {
    const auto n = std::size_t(field.variables());
    std::vector<Box> boxes{field.domain()};
    std::size_t whole = 0; // sides, one after the other, that no box was halved along
    for (std::size_t side = 0; boxes.size() < tasks_at_least && whole < n; side = (side + 1) % n) {
        std::vector<Box> halves;
        for (const Box& box : boxes) {
            if (!formula::is_divisible(box[side])) {
                halves.push_back(box);
                continue;
            }
            Box low = box, high = box;
            low[side].hi = high[side].lo = mid(box[side]);
            halves.push_back(low);
            halves.push_back(high);
        }
        whole = halves.size() > boxes.size() ? 0 : whole + 1;
        boxes = std::move(halves);
    }
    return boxes;
}

const char* name_of(Test test) {
    constexpr std::array<const char*, std::size_t(Test::count)> names{
        "inside a known point's box",
        "outside of the bounds",
        "F",
        "a derivative",
        "second derivatives",
        "Krawczyk: none",
        "Krawczyk: one",
        "narrowed",
        "divided",
        "smallest",
    };
    return names[std::size_t(test)];
}

Work& Work::operator+=(const Work& other) {
    boxes += other.boxes;
    for (std::size_t k = 0; k < removed.size(); ++k) removed[k] += other.removed[k];
    return *this;
}

void put_in_order(std::vector<CriticalPoint>& points) {
    std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) {
        return std::lexicographical_compare(
            a.where.rbegin(), a.where.rend(), b.where.rbegin(), b.where.rend(),
            [](const Interval& x, const Interval& y) { return x.lo < y.lo; });
    });
}

void put_together(SearchResult& all) {
    put_in_order(all.points);
    std::vector<CriticalPoint> points;
    std::vector<Box> one_or_two; // boxes of roots that may be one
    for (const CriticalPoint& point : all.points) {
        const bool is_new =
            std::none_of(points.begin(), points.end(), [&](const CriticalPoint& known) {
                if (!meet(known.where, point.where)) return false;
                if (contains(known.alone, point.where) || contains(point.alone, known.where)) {
                    return true;
                }
                one_or_two.push_back(point.where);
                return false;
            });
        if (is_new) points.push_back(point);
    }
    all.points = std::move(points);
    std::erase_if(all.unresolved, [&](const Box& box) {
        return std::any_of(all.points.begin(), all.points.end(),
                           [&](const auto& point) { return contains(point.alone, box); });
    });
    all.unresolved.insert(all.unresolved.end(), one_or_two.begin(), one_or_two.end());
}

std::vector<Box> merged(std::vector<Box> boxes, const Box& domain, double gap) {
    for (bool changed = true; changed;) {
        changed = false;
        std::vector<Box> fewer;
        for (const Box& box : boxes) {
            Box wide = box;
            for (std::size_t k = 0; k < most_variables; ++k) {
                const double by = gap * (domain[k].hi - domain[k].lo);
                wide[k] = {wide[k].lo - by, wide[k].hi + by};
            }
            const auto near = std::find_if(fewer.begin(), fewer.end(),
                                           [&](const Box& other) { return meet(wide, other); });
            if (near == fewer.end()) {
                fewer.push_back(box);
                continue;
            }
            for (std::size_t k = 0; k < most_variables; ++k) {
                (*near)[k] = hull((*near)[k], box[k]);
            }
            changed = true;
        }
        boxes = std::move(fewer);
    }
    return boxes;
}

namespace {

std::vector<Box> smallest_within(const std::vector<Box>& wholes, const std::vector<Box>& parts,
                                 const MovingField& field) {
    const auto n = std::size_t(field.variables());
    const auto size = [&](const Box& box) {
        double most = 0;
        for (std::size_t k = 0; k < n; ++k) {
            const double whole = field.domain()[k].hi - field.domain()[k].lo;
            if (whole > 0) most = std::max(most, (box[k].hi - box[k].lo) / whole);
        }
        return most;
    };
    std::vector<Box> smallest = wholes;
    for (const Box& part : parts) {
        for (std::size_t k = 0; k < wholes.size(); ++k) {
            if (contains(wholes[k], part) && size(part) < size(smallest[k])) smallest[k] = part;
        }
    }
    return smallest;
}

} // namespace

SearchResult search(const MovingField& field, const SearchOptions& searching) {
    const std::vector<Box> boxes = tasks(field);
    std::vector<SearchResult> parts(boxes.size());
    const auto seek = [&] {
        return
            [&, enclosures = Enclosures(field), numbers = Numbers(field)](std::size_t k) mutable {
                parts[k] = Task(field, searching, enclosures, numbers).run(boxes[k]);
            };
    };
    base::share({boxes.size(), searching.threads, searching.stopped, searching.progress}, seek);
    SearchResult all;
    for (SearchResult& part : parts) {
        all.points.insert(all.points.end(), part.points.begin(), part.points.end());
        all.unresolved.insert(all.unresolved.end(), part.unresolved.begin(), part.unresolved.end());
        all.work += part.work;
    }
    put_together(all);
    // There may be thousands, and one who waits for the end is to wait no longer.
    const bool is_late = searching.stopped && searching.stopped();
    const double gap = is_late ? formula::infinity : 4 * searching.smallest;
    const std::vector<Box> parts_of_these = all.unresolved;
    all.unresolved = merged(std::move(all.unresolved), field.domain(), gap);
    if (!is_late) all.smallest = smallest_within(all.unresolved, parts_of_these, field);
    return all;
}

} // namespace isomotion::topology
