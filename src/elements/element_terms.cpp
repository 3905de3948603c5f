#include "elements/element_terms.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/workers.h"

namespace isomotion::elements {
namespace {

constexpr int block = formula::Evaluator<Interval>::block;
// Halvings of the logarithm of a level, which end within a hundredth of it; and the least part of
// a quadric's range that is looked at.
constexpr int halvings = 12;
constexpr double least_part = 0x1p-40;
// What rounding outwards may leave of a term that is 0.
constexpr double rounded_0 = 64 * formula::smallest_positive;

Interval oriented(const Quadric& q, double low, double high) {
    return q.sign > 0 ? Interval(low, high) : Interval(-high, -low);
}

Interval whole_range(const Quadric& q) {
    return q.is_definite ? oriented(q, q.least, q.most) : Interval::entire();
}

// What a quadric can be in that shell of a level set and beyond.
Interval beyond(const Quadric& q, const LevelSet& set, int shell) {
    if (!q.is_definite) return Interval::entire();
    double from = q.least;
    if (set.kind == LevelSet::Kind::bounded) {
        constexpr double rounding = 1e-5; // of a set's end
        const double end = set.least + (1 - rounding) * set.rise;
        const double part = double(shell * shell) / (ElementTerms::shells * ElementTerms::shells);
        from = q.least + part * (end - q.least);
    }
    return oriented(q, std::min(from, q.most), q.most);
}

double level_at(const Quadric& q, double part) {
    return std::min(q.least + part * (q.most - q.least), q.most);
}

// A quadric with the range of both.
Quadric hull(const Quadric& a, const Quadric& b) {
    Quadric both = a;
    both.is_definite = a.is_definite && b.is_definite && a.sign == b.sign && a.is_flat == b.is_flat;
    both.least = std::min(a.least, b.least);
    both.most = std::max(a.most, b.most);
    both.flattest = std::min(a.flattest, b.flattest);
    return both;
}

} // namespace

// The terms of some elements, bounded together.
class ElementTerms::Lanes {
public:
    explicit Lanes(const ElementTerms& of)
        : of_(of)
        , evaluator_(of.kernels_.terms)
        , inputs_(std::size_t(of.kernels_.first_field()) + of.kernels_.fields.size(),
                  std::vector<Interval>(block))
        , outputs_(std::size_t(of.sums()), std::vector<Interval>(block)) {
        for (int k = 0; k < 3; ++k) {
            std::ranges::fill(inputs_[std::size_t(k)],
                              Interval(of.region_.low[k], of.region_.high[k]));
        }
    }

    void set_quadric(int k, int lane, const Interval& value) {
        inputs_[std::size_t(3 + k)][std::size_t(lane)] = value;
    }
    void set_field(std::size_t f, int lane, const Interval& value) {
        inputs_[std::size_t(of_.kernels_.first_field()) + f][std::size_t(lane)] = value;
    }
    void set_elements(int first, int count) {
        for (std::size_t f = 0; f < of_.kernels_.fields.size(); ++f) {
            const std::span<const float> values = of_.column(f);
            for (int l = 0; l < count; ++l) set_field(f, l, double(values[std::size_t(first + l)]));
        }
    }
    const Interval& term(int sum, int lane) const {
        return outputs_[std::size_t(sum)][std::size_t(lane)];
    }
    void run(int count) {
        std::vector<std::span<const Interval>> from;
        for (const auto& input : inputs_) from.emplace_back(input.data(), std::size_t(count));
        std::vector<std::span<Interval>> to;
        for (auto& output : outputs_) to.emplace_back(output.data(), std::size_t(count));
        evaluator_.points(of_.parameters_, from, to);
    }

    // For each lane the level of quadric k beyond which the sums that depend on it keep their
    // tolerances. Below the quadric's least where they do everywhere, infinite where nowhere.
    std::vector<double> levels(std::span<const Quadric* const> all, int k,
                               std::span<const double> tolerance) {
        const int count = int(all.size()) / of_.quadrics();
        const auto quadric = [&](int l, int j) -> const Quadric& {
            return *all[std::size_t(l * of_.quadrics() + j)];
        };
        const auto keeps = [&](int l) {
            for (int sum = 0; sum < of_.sums(); ++sum) {
                if (of_.kernels_.quadric_of[std::size_t(sum)] == k &&
                    !of_.keeps(term(sum, l), tolerance[std::size_t(sum)])) {
                    return false;
                }
            }
            return true;
        };
        for (int l = 0; l < count; ++l) {
            for (int j = 0; j < of_.quadrics(); ++j) set_quadric(j, l, whole_range(quadric(l, j)));
        }
        run(count);
        constexpr double never = std::numeric_limits<double>::infinity();
        if (std::ranges::none_of(all, [](const Quadric* q) { return q->is_definite; })) {
            std::vector<double> levels;
            levels.reserve(std::size_t(count));
            for (int l = 0; l < count; ++l) levels.push_back(keeps(l) ? -never : never);
            return levels;
        }
        std::vector<double> levels(std::size_t(count), 0), low(levels), high(levels);
        for (int l = 0; l < count; ++l) {
            levels[std::size_t(l)] = keeps(l) ? -never : 0;
            low[std::size_t(l)] = least_part;
            high[std::size_t(l)] = 1;
        }
        const auto try_from = [&](auto&& part) {
            for (int l = 0; l < count; ++l) {
                const Quadric& q = quadric(l, k);
                if (q.is_definite) set_quadric(k, l, oriented(q, level_at(q, part(l)), q.most));
            }
            run(count);
        };
        try_from([](int) { return 1.0; });
        for (int l = 0; l < count; ++l) {
            const bool ends = quadric(l, k).is_definite && keeps(l);
            if (levels[std::size_t(l)] == 0 && !ends) levels[std::size_t(l)] = never;
        }
        const auto middle = [&](int l) {
            return std::sqrt(low[std::size_t(l)] * high[std::size_t(l)]);
        };
        for (int turn = 0; turn < halvings; ++turn) {
            try_from(middle);
            for (int l = 0; l < count; ++l) {
                const double between = middle(l);
                (keeps(l) ? high : low)[std::size_t(l)] = between;
            }
        }
        for (int l = 0; l < count; ++l) {
            double& level = levels[std::size_t(l)];
            if (std::isfinite(level)) level = level_at(quadric(l, k), high[std::size_t(l)]);
        }
        return levels;
    }

private:
    const ElementTerms& of_;
    formula::Evaluator<Interval> evaluator_;
    std::vector<std::vector<Interval>> inputs_, outputs_;
};

ElementTerms::ElementTerms(const formula::ElementKernels& kernels,
                           const formula::Bindings<float>& bindings, const Region& region,
                           int threads)
    : kernels_(kernels)
    , bindings_(bindings)
    , region_(region)
    , count_(bindings.arrays[std::size_t(kernels.array)].count) {
    parameters_.parameters.assign(bindings.parameters.begin(), bindings.parameters.end());
    parameters_.seed = bindings.seed;
    read(threads);
}

void ElementTerms::read(int threads) {
    read_quadrics(threads);
    alike_ = count_ > 0 && has_equal_terms();
    const auto is_definite = [](const Quadric& q) { return q.is_definite; };
    if (!std::ranges::all_of(ranges_.hulls, is_definite)) bound_anywhere();
}

bool ElementTerms::keeps(const Interval& term, double tolerance) const {
    return is_least() ? term.lo >= tolerance : magnitude(term) <= std::max(tolerance, rounded_0);
}

std::span<const float> ElementTerms::column(std::size_t input) const {
    return bindings_.arrays[std::size_t(kernels_.array)]
        .fields[std::size_t(kernels_.fields[input])];
}

bool ElementTerms::has_equal_terms() const {
    for (const Quadric& q : ranges_.hulls) {
        if (!q.is_definite) return false;
    }
    for (const formula::Instruction& now : kernels_.terms.instructions) {
        const bool reads = now.kind == formula::Instruction::Kind::operation &&
                           now.op == formula::Op::input && now.index >= kernels_.first_field();
        if (!reads) continue;
        const auto values = column(std::size_t(now.index - kernels_.first_field()));
        if (!std::ranges::all_of(values, [&](float v) { return v == values[0]; })) return false;
    }
    return true;
}

// Reads the quadrics of some elements at a time, as many as fit into a processor's cache.
class ElementTerms::Reader {
public:
    explicit Reader(ElementTerms& to)
        : to_(to)
        , evaluator_(to.kernels_.coefficients)
        // A program that reads no field has points all the same.
        , inputs_(std::max(to.kernels_.fields.size(), std::size_t(1)))
        , outputs_(each * std::size_t(to.quadrics())) {
        values_.parameters.assign(to.bindings_.parameters.begin(), to.bindings_.parameters.end());
        values_.seed = to.bindings_.seed;
    }

    // Their quadrics; and the ranges of these and of their fields.
    Ranges read(std::size_t first, std::size_t count) {
        Ranges ranges;
        for (auto& input : inputs_) input.assign(count, 0.0);
        for (std::size_t f = 0; f < to_.kernels_.fields.size(); ++f) {
            const auto column = to_.column(f).subspan(first, count);
            std::ranges::copy(column, inputs_[f].begin());
            Interval range{double(column[0])};
            for (const float value : column) range = formula::hull(range, Interval(double(value)));
            ranges.fields.push_back(range);
        }
        for (auto& output : outputs_) output.resize(count);
        const std::vector<std::span<const double>> from(inputs_.begin(), inputs_.end());
        const std::vector<std::span<double>> to(outputs_.begin(), outputs_.end());
        evaluator_.points(values_, from, to);
        const auto kinds = std::size_t(to_.quadrics());
        for (std::size_t e = 0; e < count; ++e) {
            for (std::size_t k = 0; k < kinds; ++k) {
                std::array<double, each> q{};
                for (std::size_t c = 0; c < each; ++c) q[c] = outputs_[k * each + c][e];
                const Quadric read = Quadric::from(q, to_.region_);
                to_.quadrics_[(first + e) * kinds + k] = read;
                if (e == 0) {
                    ranges.hulls.push_back(read);
                } else {
                    ranges.hulls[k] = hull(ranges.hulls[k], read);
                }
            }
        }
        return ranges;
    }

private:
    static constexpr std::size_t each = formula::ElementKernels::coefficients_each;

    ElementTerms& to_;
    formula::Evaluator<double> evaluator_;
    formula::Bindings<double> values_;
    std::vector<std::vector<double>> inputs_, outputs_;
};

void ElementTerms::read_quadrics(int threads) {
    constexpr std::size_t together = 1024;
    const auto elements = std::size_t(count_);
    quadrics_.resize(elements * std::size_t(quadrics()));
    std::vector<Ranges> of_turns((elements + together - 1) / together);
    base::share({of_turns.size(), threads}, [&] {
        return [&, reader = Reader(*this)](std::size_t turn) mutable {
            const std::size_t first = turn * together;
            of_turns[turn] = reader.read(first, std::min(together, elements - first));
        };
    });
    for (const Ranges& part : of_turns) {
        if (&part == of_turns.data()) {
            ranges_ = part;
            continue;
        }
        for (std::size_t k = 0; k < part.hulls.size(); ++k)
            ranges_.hulls[k] = hull(ranges_.hulls[k], part.hulls[k]);
        for (std::size_t f = 0; f < part.fields.size(); ++f)
            ranges_.fields[f] = formula::hull(ranges_.fields[f], part.fields[f]);
    }
}

void ElementTerms::level_sets(std::span<const double> tolerance, int first, int last,
                              std::span<LevelSet> found) const {
    Lanes lanes(*this);
    Boxes boxes(*this);
    const auto kinds = std::size_t(kernels_.quadrics);
    const auto set = [&](int element, int k, double level) {
        LevelSet& made = found[std::size_t(element - first) * kinds + std::size_t(k)];
        if (std::isinf(level)) {
            made = {};
            if (level > 0) made.kind = LevelSet::Kind::unbounded;
        } else {
            made = quadric(element, k).level_set(level);
        }
    };
    if (alike_) {
        // One search for all: beyond the level the terms keep their tolerances up to the largest
        // value of any.
        lanes.set_elements(first, 1);
        std::vector<const Quadric*> all;
        for (const Quadric& hull : ranges_.hulls) all.push_back(&hull);
        for (int k = 0; k < quadrics(); ++k) {
            const double level = lanes.levels(all, k, tolerance)[0];
            for (int e = first; e < last; ++e) set(e, k, level);
        }
        return;
    }
    for (int begin = first; begin < last; begin += block) {
        const int count = std::min(block, last - begin);
        lanes.set_elements(begin, count);
        std::vector<const Quadric*> all;
        for (int l = 0; l < count; ++l) {
            for (int j = 0; j < quadrics(); ++j) all.push_back(&quadric(begin + l, j));
        }
        for (int k = 0; k < quadrics(); ++k) {
            const std::vector<double> levels = lanes.levels(all, k, tolerance);
            for (int l = 0; l < count; ++l) {
                set(begin + l, k, levels[std::size_t(l)]);
                LevelSet& made = found[std::size_t(begin + l - first) * kinds + std::size_t(k)];
                const bool is_unknown =
                    made.kind == LevelSet::Kind::unbounded && !quadric(begin + l, k).is_definite;
                const bool is_wide = kernels_.read_places && made.kind == LevelSet::Kind::bounded &&
                                     glm::any(made.is_flat);
                if (!is_unknown && !is_wide) continue;
                const LevelSet in_box = box(boxes, begin + l, k, tolerance);
                if (in_box.kind != LevelSet::Kind::unbounded) made = in_box;
            }
        }
    }
}

ElementTerms::Boxes::Boxes(const ElementTerms& of)
    : of_(of)
    , evaluator_(of.kernels_.by_place)
    , inputs_(3 + of.kernels_.fields.size())
    , terms_(std::size_t(of.sums())) {}

void ElementTerms::Boxes::look(int element, std::span<const std::array<Interval, 3>> boxes) {
    for (std::size_t k = 0; k < 3; ++k) {
        inputs_[k].clear();
        for (const auto& box : boxes) inputs_[k].push_back(box[k]);
    }
    for (std::size_t f = 0; f < of_.kernels_.fields.size(); ++f)
        inputs_[3 + f].assign(boxes.size(), double(of_.column(f)[std::size_t(element)]));
    for (auto& terms : terms_) terms.resize(boxes.size());
    const std::vector<std::span<const Interval>> from(inputs_.begin(), inputs_.end());
    const std::vector<std::span<Interval>> to(terms_.begin(), terms_.end());
    evaluator_.points(of_.parameters_, from, to);
}

bool ElementTerms::Boxes::matters(int k, std::span<const double> tolerance, std::size_t box) const {
    for (int sum = 0; sum < of_.sums(); ++sum) {
        if (of_.quadric_of(sum) == k &&
            !of_.keeps(terms_[std::size_t(sum)][box], tolerance[std::size_t(sum)])) {
            return true;
        }
    }
    return false;
}

float ElementTerms::Boxes::size(int sum, std::size_t box) const {
    return of_.size_of(terms_[std::size_t(sum)][box]);
}

// Cuts slabs off the region in which the terms keep their tolerances, from each face as deep as
// halving tells.
LevelSet ElementTerms::box(Boxes& boxes, int element, int k,
                           std::span<const double> tolerance) const {
    // Places a little beyond the region, by rounding, belong to its outermost cells.
    const double beyond = 0x1p-12 * glm::length(region_.high - region_.low);
    std::array<Interval, 3> left;
    for (int axis = 0; axis < 3; ++axis)
        left[std::size_t(axis)] = {region_.low[axis] - beyond, region_.high[axis] + beyond};
    // How many slabs are free, from the first on; each is deeper than the one before.
    const auto free_slabs = [&](std::span<const std::array<Interval, 3>> slabs) {
        boxes.look(element, slabs);
        std::size_t free = 0;
        while (free < slabs.size() && !boxes.matters(k, tolerance, free)) ++free;
        return free;
    };
    LevelSet set;
    set.kind = LevelSet::Kind::unbounded;
    constexpr int parts = 8, rounds = 3; // 1 / 512 of the region
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const bool from_low : {true, false}) {
            const double face = from_low ? left[axis].lo : left[axis].hi;
            double free = face, other = from_low ? left[axis].hi : left[axis].lo;
            for (int round = 0; round < rounds; ++round) {
                std::vector<std::array<Interval, 3>> slabs;
                const auto depth = [&](int part) { return free + (other - free) * part / parts; };
                for (int part = 1; part <= parts; ++part) {
                    slabs.push_back(left);
                    const double end = part < parts ? depth(part) : other;
                    slabs.back()[axis] = from_low ? Interval(face, end) : Interval(end, face);
                }
                const int found = int(free_slabs(slabs));
                if (found == parts && round == 0) return {};
                const double deeper = depth(found);
                if (found < parts) other = depth(found + 1);
                free = deeper;
                if (found == 0 && round == 0) break;
            }
            if (free != face) set.kind = LevelSet::Kind::bounded;
            left[axis] = from_low ? Interval(free, left[axis].hi) : Interval(left[axis].lo, free);
        }
    }
    set.is_box = set.kind == LevelSet::Kind::bounded;
    for (int axis = 0; axis < 3; ++axis) {
        const Interval& side = left[std::size_t(axis)];
        set.centre[axis] = 0.5 * (side.lo + side.hi);
        set.half[axis] = 0.5 * (side.hi - side.lo);
    }
    return set;
}

// A float that bounds the size of a term; for a key it is a lower bound.
float ElementTerms::size_of(const Interval& term) const {
    constexpr float infinite = std::numeric_limits<float>::infinity();
    constexpr double largest = 1e38;
    const double size = is_least() ? std::min(term.lo, largest) : magnitude(term);
    const float end = is_least() ? -infinite : infinite;
    return std::abs(size) <= largest ? std::nextafter(float(size), end) : end;
}

void ElementTerms::sizes(std::span<const LevelSet> sets, int first, int last,
                         std::span<float> found) const {
    Lanes lanes(*this);
    const int kinds = quadrics(), all = sums();
    const auto number = [&](int element, int sum, int shell) -> float& {
        return found[std::size_t(((element - first) * all + sum) * shells + shell)];
    };
    for (int begin = first; begin < last; begin += block) {
        const int count = std::min(block, last - begin);
        lanes.set_elements(begin, count);
        for (int shell = 0; shell < shells; ++shell) {
            // A place is known to be so far out by the sum's own quadric alone.
            for (int k = 0; k < kinds; ++k) {
                for (int l = 0; l < count; ++l) {
                    for (int j = 0; j < kinds; ++j) {
                        // The ranges of all hold for each.
                        const Quadric& q =
                            alike_ ? ranges_.hulls[std::size_t(j)] : quadric(begin + l, j);
                        const LevelSet& set = sets[std::size_t((begin + l - first) * kinds + j)];
                        lanes.set_quadric(j, l, j == k ? beyond(q, set, shell) : whole_range(q));
                    }
                }
                lanes.run(count);
                for (int sum = 0; sum < all; ++sum) {
                    if (kernels_.quadric_of[std::size_t(sum)] != k) continue;
                    for (int l = 0; l < count; ++l)
                        number(begin + l, sum, shell) = size_of(lanes.term(sum, l));
                }
            }
        }
        if (!alike_) continue;
        // The first one stands for all.
        for (int e = first + 1; e < last; ++e) {
            for (int k = 0; k < all * shells; ++k) number(e, 0, k) = number(first, 0, k);
        }
        return;
    }
}

Interval ElementTerms::bounds(int sum, double distance) const {
    if (count_ == 0) return 0.0;
    const int own = kernels_.quadric_of[std::size_t(sum)];
    if (!ranges_.hulls[std::size_t(own)].is_definite) return anywhere_[std::size_t(sum)];
    Lanes lanes(*this);
    for (int k = 0; k < quadrics(); ++k) {
        const Quadric& all = ranges_.hulls[std::size_t(k)];
        if (!all.is_definite) {
            lanes.set_quadric(k, 0, Interval::entire());
            continue;
        }
        const double least =
            k == own ? std::min(all.least + all.flattest * distance * distance, all.most)
                     : all.least;
        lanes.set_quadric(k, 0, oriented(all, least, all.most));
    }
    for (std::size_t f = 0; f < ranges_.fields.size(); ++f)
        lanes.set_field(f, 0, ranges_.fields[f]);
    lanes.run(1);
    return lanes.term(sum, 0);
}

// Bounds each element's terms in the whole region: the hull of all.
void ElementTerms::bound_anywhere() {
    anywhere_.assign(std::size_t(sums()), Interval::entire());
    Boxes boxes(*this);
    std::array<Interval, 3> region;
    for (int axis = 0; axis < 3; ++axis)
        region[std::size_t(axis)] = {region_.low[axis], region_.high[axis]};
    for (int e = 0; e < count_; ++e) {
        boxes.look(e, {&region, 1});
        for (int sum = 0; sum < sums(); ++sum) {
            Interval& all = anywhere_[std::size_t(sum)];
            const Interval term = boxes.term(sum, 0);
            all = e == 0 ? term : formula::hull(all, term);
        }
    }
}

} // namespace isomotion::elements
