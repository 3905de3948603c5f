#include "animation/sample_table.h"

#include <algorithm>
#include <cassert>

namespace isomotion::animation {
namespace {

// The rows in the order of their ids.
std::vector<std::uint32_t> rows_by_id(std::span<const std::int64_t> ids) {
    std::vector<std::uint32_t> rows(ids.size());
    for (std::size_t row = 0; row < rows.size(); ++row) rows[row] = std::uint32_t(row);
    if (!std::ranges::is_sorted(ids)) {
        std::ranges::sort(rows, [&](std::uint32_t a, std::uint32_t b) {
            return ids[a] != ids[b] ? ids[a] < ids[b] : a < b;
        });
    }
    return rows;
}

} // namespace

std::vector<std::uint32_t> match(std::span<const std::int64_t> here,
                                 std::span<const std::int64_t> there) {
    // Simulations write most elements in the order in which they wrote them before.
    std::vector<std::uint32_t> successors(here.size(), SampleSource::Successors::none);
    std::size_t same = 0;
    for (; same < std::min(here.size(), there.size()) && here[same] == there[same]; ++same)
        successors[same] = std::uint32_t(same);
    if (same == here.size()) return successors;
    const std::vector<std::uint32_t> rows = rows_by_id(there);
    for (std::size_t row = same; row < here.size(); ++row) {
        const auto found = std::ranges::lower_bound(
            rows, here[row], {}, [&](std::uint32_t other) { return there[other]; });
        if (found != rows.end() && there[*found] == here[row]) successors[row] = *found;
    }
    return successors;
}

std::optional<Twins> find_twins(std::span<const std::int64_t> ids) {
    if (std::ranges::adjacent_find(ids, std::greater_equal<>()) == ids.end()) return std::nullopt;
    const std::vector<std::uint32_t> rows = rows_by_id(ids);
    std::optional<Twins> first;
    for (std::size_t k = 1; k < rows.size(); ++k) {
        if (ids[rows[k - 1]] != ids[rows[k]]) continue;
        if (!first || rows[k] < first->second) first = {rows[k - 1], rows[k]};
    }
    return first;
}

SampleTable::SampleTable(SampleRows rows)
    : rows_(std::move(rows)) {
    assert(!rows_.times.empty() && rows_.begin.size() == rows_.times.size() + 1);
    rows_.velocities.resize(rows_.values.size());
    if (rows_.ids.empty()) return;
    const std::span<const std::int64_t> ids(rows_.ids);
    successors_.reserve(ids.size());
    for (std::size_t k = 0; k + 1 < rows_.times.size(); ++k) {
        const auto rows_of = match(ids.subspan(rows_.begin[k], count(k)),
                                   ids.subspan(rows_.begin[k + 1], count(k + 1)));
        successors_.insert(successors_.end(), rows_of.begin(), rows_of.end());
    }
}

SampleSource::Sample SampleTable::sample(std::size_t k, const std::vector<bool>& columns) const {
    Sample sample{count(k), {}};
    sample.columns.resize(rows_.values.size());
    for (std::size_t c = 0; c < rows_.values.size(); ++c) {
        if (columns[c])
            sample.columns[c] = std::span(rows_.values[c]).subspan(rows_.begin[k], sample.count);
    }
    return sample;
}

SampleSource::Successors SampleTable::successors(std::size_t k) const {
    if (successors_.empty()) return Successors(std::min(count(k), count(k + 1)));
    return Successors(std::span(successors_).subspan(rows_.begin[k], count(k)), nullptr);
}

int SampleTable::most() const {
    std::size_t most = 0;
    for (std::size_t k = 0; k < rows_.times.size(); ++k) most = std::max(most, count(k));
    return int(most);
}

std::optional<std::size_t> SampleTable::velocity_of(std::size_t column) const {
    return rows_.velocities[column];
}

void SampleTable::add_column(base::Fingerprint& print, std::size_t column) const {
    print.add_values(std::span(rows_.values[column]));
}

void SampleTable::add_rows(base::Fingerprint& print) const {
    print.add_values(std::span(rows_.times)).add_values(std::span(rows_.begin));
    print.add_values(std::span(rows_.ids));
}

} // namespace isomotion::animation
