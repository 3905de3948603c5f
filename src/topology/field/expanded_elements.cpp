#include <algorithm>
#include <cassert>
#include <numeric>

#include "topology/field/box_field.h"

namespace isomotion::topology {
using formula::Interval;

namespace {

// Adds up the widths of one element's terms.
void add_widths(std::span<const Interval> of_elements, double factor, std::vector<double>& widths) {
    for (std::size_t i = 0; i < widths.size(); ++i) widths[i] += factor * width(of_elements[i]);
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

// Taylor's formula doesn't hold for terms with slopes that may be unbounded.
void forbid_unbounded(std::span<const Interval> of_elements, std::vector<double>& shares) {
    for (std::size_t i = 0; i < shares.size(); ++i) {
        if (!std::isfinite(magnitude(of_elements[i]))) shares[i] = formula::infinity;
    }
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
        run_terms(expansions_[which], culling, std::array{box, middle}, from, outputs);
        const auto over_box = [&](std::size_t output) {
            return std::span<const Interval>(outputs_[output]).first(count);
        };
        const auto at_middle = [&](std::size_t output) {
            return std::span<const Interval>(outputs_[output]).subspan(count, count);
        };

        // Where each output goes to.
        struct Share {
            std::size_t output, parameter;
            bool is_in_middle;
            bool is_half;
        };
        std::vector<Share> into;
        std::vector<double> shares(count, 0.0);
        std::size_t next = sums + culling.keys;
        for (std::size_t j = 0; j < sums; ++j) {
            const BoxField::Remainder& remainder = field_.remainders_[culling.first_sum + j];
            std::size_t parameter = remainder.first_parameter;
            std::vector<double> blurs(count, 0.0);
            into.push_back({j, parameter++, remainder.slopes > 0, false});
            for (std::size_t k = 0; k < remainder.slopes; ++k, ++next) {
                const bool is_in_middle = remainder.second > 0 && k < field_.rows_;
                into.push_back({next, parameter++, is_in_middle, false});
                if (!is_in_middle) add_widths(over_box(next), reach[k], blurs);
            }
            for (std::size_t i = 0, left = remainder.second; left > 0; ++i) {
                for (std::size_t k = 0; k <= i; ++k, ++next, --left) {
                    into.push_back({next, parameter++, false, k == i});
                    add_widths(over_box(next), reach[i] * reach[k] * (k == i ? 0.5 : 1), blurs);
                }
            }
            raise(shares, blurs, total_width(over_box(j)));
        }
        for (std::size_t k = 0; k < outputs; ++k) forbid_unbounded(over_box(k), shares);
        for (std::size_t i = 0; i < count; ++i) {
            if (over_box(outputs - 1)[i] != Interval(0.0)) shares[i] = formula::infinity;
        }
        for (std::size_t j = sums; j < sums + culling.keys; ++j) {
            double least = formula::infinity; // is no greater
            for (const Interval& key : over_box(j)) least = std::min(least, key.hi);
            for (std::size_t i = 0; i < count; ++i) {
                if (over_box(j)[i].lo <= least) shares[i] = formula::infinity;
            }
        }

        std::vector<std::size_t> order(count);
        std::iota(order.begin(), order.end(), 0);
        std::ranges::stable_sort(order, {}, [&](std::size_t i) { return shares[i]; });
        std::vector<char> is_left_out(count, 0);
        double left_out = 0;
        for (const std::size_t i : order) {
            left_out += shares[i];
            if (!(left_out <= part)) break;
            is_left_out[i] = 1;
            for (const Share& share : into) {
                const Interval term =
                    share.is_in_middle ? at_middle(share.output)[i] : over_box(share.output)[i];
                Interval& all = parameters[share.parameter];
                all = all + (share.is_half ? Interval(0.5) * term : term);
            }
        }
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
