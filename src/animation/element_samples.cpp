#include "animation/element_samples.h"

#include <algorithm>
#include <cassert>
#include <unordered_map>

namespace isomotion::animation {

ElementSamples::ElementSamples(Rows rows, Interpolation interpolation)
    : rows_(std::move(rows))
    , interpolation_(interpolation)
    , successor_(rows_.begin.back(), none) {
    assert(!rows_.times.empty() && rows_.begin.size() == rows_.times.size() + 1);
    std::unordered_map<std::int64_t, std::size_t> row_of;
    for (std::size_t k = 0; k + 1 < rows_.times.size(); ++k) {
        const std::size_t here = rows_.begin[k], there = rows_.begin[k + 1];
        const std::size_t end = rows_.begin[k + 2];
        if (rows_.ids.empty()) {
            const std::size_t both = std::min(there - here, end - there);
            for (std::size_t i = 0; i < both; ++i) successor_[here + i] = there + i;
            continue;
        }
        row_of.clear();
        for (std::size_t row = there; row < end; ++row) row_of[rows_.ids[row]] = row;
        for (std::size_t row = here; row < there; ++row) {
            const auto it = row_of.find(rows_.ids[row]);
            if (it != row_of.end()) successor_[row] = it->second;
        }
    }
}

formula::ArrayColumns<double> ElementSamples::at(double time) const {
    const auto after = std::upper_bound(rows_.times.begin(), rows_.times.end(), time);
    const auto next = std::size_t(after - rows_.times.begin());
    const std::size_t sample = next > 0 ? next - 1 : 0;
    const std::size_t begin = rows_.begin[sample], end = rows_.begin[sample + 1];
    double weight = 0; // of the next sample
    if (interpolation_ == Interpolation::linear && next > 0 && next < rows_.times.size()) {
        const double from = rows_.times[sample], to = rows_.times[next];
        weight = (time - from) / (to - from);
    }
    formula::ArrayColumns<double> columns;
    columns.count = int(end - begin);
    for (const std::vector<double>& values : rows_.values) {
        std::vector<double>& column = columns.fields.emplace_back();
        column.reserve(end - begin);
        for (std::size_t row = begin; row < end; ++row) {
            const double here = values[row];
            const std::size_t same = successor_[row];
            const bool moves = weight > 0 && same != none;
            column.push_back(moves ? here + weight * (values[same] - here) : here);
        }
    }
    return columns;
}

ElementSamples::Span ElementSamples::span(double time) const {
    const auto after = std::upper_bound(rows_.times.begin(), rows_.times.end(), time);
    const auto next = std::size_t(after - rows_.times.begin());
    const std::size_t sample = next > 0 ? next - 1 : 0;
    Span span;
    span.begin = span.end = at(time < rows_.times[sample] ? time : rows_.times[sample]);
    span.begin_time = rows_.times[sample];
    span.end_time = next < rows_.times.size() ? rows_.times[next] : span.begin_time;
    if (interpolation_ != Interpolation::linear || next == 0 || next == rows_.times.size()) {
        return span;
    }
    const std::size_t begin = rows_.begin[sample];
    for (std::size_t column = 0; column < rows_.values.size(); ++column) {
        for (std::size_t i = 0; i < std::size_t(span.end.count); ++i) {
            const std::size_t same = successor_[begin + i];
            if (same != none) span.end.fields[column][i] = rows_.values[column][same];
        }
    }
    return span;
}

bool ElementSamples::jumps(std::size_t k) const {
    if (k == 0) return false; // before the first sample it is there already
    const std::size_t begin = rows_.begin[k - 1], end = rows_.begin[k];
    if (recounts(k)) return true;
    for (std::size_t row = begin; row < end; ++row) {
        if (successor_[row] == none) return true;
        if (interpolation_ == Interpolation::linear) continue;
        for (const std::vector<double>& values : rows_.values) {
            if (values[row] != values[successor_[row]]) return true;
        }
    }
    return false;
}

bool ElementSamples::recounts(std::size_t k) const {
    if (k == 0) return false;
    return rows_.begin[k + 1] - rows_.begin[k] != rows_.begin[k] - rows_.begin[k - 1];
}

bool ElementSamples::reorders(std::size_t k) const {
    if (k == 0) return false;
    const std::size_t begin = rows_.begin[k - 1], end = rows_.begin[k];
    for (std::size_t row = begin; row < end; ++row) {
        if (successor_[row] != none && successor_[row] - end != row - begin) return true;
    }
    return false;
}

int ElementSamples::most() const {
    std::size_t most = 0;
    for (std::size_t k = 0; k < rows_.times.size(); ++k) {
        most = std::max(most, rows_.begin[k + 1] - rows_.begin[k]);
    }
    return int(most);
}

} // namespace isomotion::animation
