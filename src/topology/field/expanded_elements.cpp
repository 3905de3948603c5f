#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "topology/field/box_field.h"

namespace isomotion::topology {
using formula::Interval;

namespace {

// Adds up the widths of one element's terms. They only decide which elements are left out.
void add_widths(std::span<const Interval> of_elements, double factor, std::vector<double>& widths) {
    for (std::size_t i = 0; i < widths.size(); ++i)
        widths[i] += factor * (of_elements[i].hi - of_elements[i].lo);
}

// What decides: how much one element's remainder blurs some sum, as a part of `all`.
void raise(std::vector<double>& shares, const std::vector<double>& blurs, double all) {
    for (std::size_t i = 0; i < shares.size(); ++i) {
        if (blurs[i] > 0) shares[i] = std::max(shares[i], blurs[i] / all);
    }
}

// Without poles: beside them anything would seem narrow.
double total_width(std::span<const Interval> of_elements) {
    double all = 0;
    for (const Interval& term : of_elements) {
        if (std::isfinite(width(term))) all += width(term);
    }
    return all;
}

// The sum of some terms, all bounded. Adding up n numbers one by one errs by less than n 2^-53
// parts of the sum of their sizes, and that sum by as little; twice as much is taken.
Interval sum_of(std::span<const Interval> terms, std::span<const std::size_t> which) {
    double lo = 0, hi = 0, size = 0;
    for (const std::size_t i : which) {
        lo += terms[i].lo;
        hi += terms[i].hi;
        size += magnitude(terms[i]);
    }
    if (!std::isfinite(size)) return Interval::entire();
    const double error = double(which.size()) * 0x1p-52 * size;
    return Interval(lo, hi) + Interval(-error, error);
}

} // namespace

Elements BoxEvaluator::expanded(const Box& box, const Elements& from, double part) {
    assert(!from.are_expanded());
    Elements kept = from;
    if (field_.remainders_.empty()) return kept;
    const std::size_t n = field_.inputs_.unknowns;
    Box middle = box;
    std::array<double, most_variables> reach{};
    for (std::size_t k = 0; k < n; ++k) {
        middle[k] = mid(box[k]);
        reach[k] = magnitude(box[k] - middle[k]);
    }
    std::vector<Interval>& parameters = kept.bindings.parameters;
    parameters.resize(field_.middle_);
    parameters.insert(parameters.end(), middle.begin(), middle.begin() + std::ptrdiff_t(n));
    for (std::size_t sum = 0; sum < field_.sums_; ++sum) {
        parameters.push_back(kept.rest[sum]);
        parameters.resize(parameters.size() + field_.remainders_[sum].parameters() - 1);
    }
    kept.own_parameters = field_.middle_;
    for (std::size_t which = 0; which < expansions_.size(); ++which) {
        const BoxField::Culling& culling = field_.cullings_[which];
        formula::ArrayColumns<Interval>& columns = kept.bindings.arrays[std::size_t(culling.array)];
        const auto count = std::size_t(columns.count), sums = culling.is_first_order.size();
        if (!culling.can_expand || count <= 1) continue;
        const std::size_t outputs = culling.expansion.outputs.size();
        run_terms(expansions_[which], culling, {&box, 1}, from, outputs);
        const auto of_elements = [&](std::size_t output) {
            return std::span<const Interval>(outputs_[output]).first(count);
        };

        // Where each output goes to.
        struct Share {
            std::size_t output, parameter;
            bool is_half;
        };
        std::vector<Share> over_box, in_middle;
        std::vector<double> shares(count, 0.0), blurs(count);
        std::size_t next = sums + culling.keys;
        for (std::size_t j = 0; j < sums; ++j) {
            const BoxField::Remainder& remainder = field_.remainders_[culling.first_sum + j];
            std::size_t parameter = remainder.first_parameter;
            std::ranges::fill(blurs, 0.0);
            const auto add = [&](bool is_in_middle, std::size_t output) {
                if (is_in_middle) {
                    in_middle.push_back({in_middle.size(), parameter++, false});
                } else {
                    over_box.push_back({output, parameter++, false});
                }
            };
            add(remainder.slopes > 0, j);
            for (std::size_t k = 0; k < remainder.slopes; ++k, ++next) {
                const bool is_in_middle = remainder.second > 0 && k < field_.rows_;
                add(is_in_middle, next);
                if (!is_in_middle) add_widths(of_elements(next), reach[k], blurs);
            }
            for (std::size_t i = 0, left = remainder.second; left > 0; ++i) {
                for (std::size_t k = 0; k <= i; ++k, ++next, --left) {
                    over_box.push_back({next, parameter++, k == i});
                    add_widths(of_elements(next), reach[i] * reach[k] * (k == i ? 0.5 : 1), blurs);
                }
            }
            raise(shares, blurs, total_width(of_elements(j)));
        }
        // Taylor's formula doesn't hold for terms with slopes that may be unbounded.
        std::vector<double> largest(count, 0.0);
        for (std::size_t k = 0; k < outputs; ++k) {
            const std::span<const Interval> terms = of_elements(k);
            for (std::size_t i = 0; i < count; ++i)
                largest[i] = formula::larger(largest[i], magnitude(terms[i]));
        }
        for (std::size_t i = 0; i < count; ++i) {
            const bool is_smooth = of_elements(outputs - 1)[i] == Interval(0.0);
            if (!is_smooth || !std::isfinite(largest[i])) shares[i] = formula::infinity;
        }
        for (std::size_t j = sums; j < sums + culling.keys; ++j) {
            double least = formula::infinity; // is no greater
            for (const Interval& key : of_elements(j)) least = std::min(least, key.hi);
            for (std::size_t i = 0; i < count; ++i) {
                if (of_elements(j)[i].lo <= least) shares[i] = formula::infinity;
            }
        }

        std::vector<std::size_t> left_out(count);
        std::iota(left_out.begin(), left_out.end(), 0);
        std::ranges::stable_sort(left_out, {}, [&](std::size_t i) { return shares[i]; });
        double blurred = 0;
        const auto enough = std::ranges::find_if(left_out, [&](std::size_t i) {
            blurred += shares[i];
            return !(blurred <= part);
        });
        left_out.erase(enough, left_out.end());
        if (left_out.empty()) continue;
        const auto put = [&](const Share& share) {
            const Interval sum = sum_of(of_elements(share.output), left_out);
            Interval& all = parameters[share.parameter];
            all = all + (share.is_half ? Interval(0.5) * sum : sum);
        };
        std::ranges::for_each(over_box, put);
        run_terms(middles_[which], culling, {&middle, 1}, from, in_middle.size());
        std::ranges::for_each(in_middle, put);
        std::vector<char> is_left_out(count, 0);
        for (const std::size_t i : left_out) is_left_out[i] = 1;
        std::size_t kept_elements = 0;
        for (std::size_t i = 0; i < count; ++i) {
            if (is_left_out[i]) continue;
            for (auto& field : columns.fields) {
                if (!field.empty()) field[kept_elements] = field[i];
            }
            ++kept_elements;
        }
        columns.count = int(kept_elements);
        for (auto& field : columns.fields) {
            if (!field.empty()) field.resize(kept_elements);
        }
    }
    return kept;
}

} // namespace isomotion::topology
