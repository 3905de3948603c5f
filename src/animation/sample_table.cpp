#include "animation/sample_table.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <numeric>

namespace isomotion::animation {
namespace {

struct Known {
    std::uint64_t key; // in the order of ids, negative ones first
    std::uint32_t row;
};

// The rows from `begin` on in the order of their ids. Sorted byte by byte: a million ids in the
// order of chance take a third of what comparing them takes.
std::vector<Known> by_id(std::span<const std::int64_t> ids, std::size_t begin = 0) {
    std::vector<Known> known;
    known.reserve(ids.size() - begin);
    std::array<std::array<std::uint32_t, 256>, 8> counts{};
    for (std::size_t row = begin; row < ids.size(); ++row) {
        const std::uint64_t key = std::uint64_t(ids[row]) ^ (std::uint64_t(1) << 63);
        known.push_back({key, std::uint32_t(row)});
        for (std::size_t byte = 0; byte < 8; ++byte) ++counts[byte][key >> (8 * byte) & 255];
    }
    if (std::ranges::is_sorted(known, {}, &Known::key)) return known;
    std::vector<Known> sorted(known.size());
    for (std::size_t byte = 0; byte < 8; ++byte) {
        auto& places = counts[byte];
        if (std::ranges::find(places, known.size()) != places.end()) continue; // all have it alike
        std::exclusive_scan(places.begin(), places.end(), places.begin(), std::uint32_t(0));
        for (const Known& one : known) sorted[places[one.key >> (8 * byte) & 255]++] = one;
        known.swap(sorted);
    }
    return known;
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
    const std::vector<Known> left = by_id(here, same), right = by_id(there, same);
    auto found = right.begin();
    for (const Known& one : left) {
        found = std::find_if(found, right.end(), [&](const Known& k) { return k.key >= one.key; });
        if (found == right.end()) break;
        if (found->key == one.key) successors[one.row] = found->row;
    }
    return successors;
}

std::optional<Twins> find_twins(std::span<const std::int64_t> ids) {
    if (std::ranges::adjacent_find(ids, std::greater_equal<>()) == ids.end()) return std::nullopt;
    const std::vector<Known> known = by_id(ids);
    std::optional<Twins> first;
    for (std::size_t k = 1; k < known.size(); ++k) {
        if (known[k - 1].key != known[k].key) continue;
        if (!first || known[k].row < first->second) first = {known[k - 1].row, known[k].row};
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
