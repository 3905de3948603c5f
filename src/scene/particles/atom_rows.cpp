#include "scene/particles/atom_rows.h"

#include <algorithm>

#include <fmt/format.h>

#include "scene/limits.h"
#include "scene/particles/attribute_names.h"
#include "scene/particles/chemical_elements.h"

namespace isomotion::scene {
namespace {

bool has(const std::vector<std::string>& names, std::string_view name) {
    return std::ranges::find(names, name) != names.end();
}

} // namespace

RowLayout layout_without_names(std::size_t width, std::size_t first) {
    RowLayout layout{width, names_without_names(width - first), {}};
    for (std::size_t cell = first; cell < width; ++cell) layout.cells.push_back(cell);
    return layout;
}

void AtomRows::begin(RowLayout layout, std::size_t count) {
    layout_ = std::move(layout);
    names_ = layout_.names;
    given_ = names_.size();
    for (std::size_t k = 0; layout_.element && k < element_columns.size(); ++k) {
        if (has(layout_.names, element_columns[k])) continue; // what the file says goes before
        of_elements_.push_back(k);
        names_.emplace_back(element_columns[k]);
    }
    if (layout_.has_frames) names_.emplace_back("frame");
    wanted_ = wanted_of(request_, table_.format, names_, count);
    values_.resize(names_.size());
}

// `number(k)`: of the k-th column of numbers.
template<class Number> void AtomRows::add_row(int frame, const Number& number) {
    table_.lines.push_back(words_.line());
    for (std::size_t k = 0; k < given_; ++k)
        if (wanted_.columns[k]) values_[k].push_back(number(k));
    if (layout_.has_frames && wanted_.columns.back()) values_.back().push_back(frame);
}

void AtomRows::add(const std::vector<std::string_view>& cells, int frame) {
    if (cells.size() != layout_.width) {
        words_.fail(
            fmt::format("has {} words; the rows before have {}", cells.size(), layout_.width));
    }
    add_row(frame,
            [&](std::size_t k) { return words_.number(cells[layout_.cells[k]], names_[k]); });
    if (!layout_.element) return;
    const auto of_element = element_numbers(atomic_number(cells[*layout_.element]));
    for (std::size_t k = 0; k < of_elements_.size(); ++k)
        if (wanted_.columns[given_ + k]) values_[given_ + k].push_back(of_element[of_elements_[k]]);
}

void AtomRows::add_none(int frame) {
    table_.bare.push_back(table_.lines.size());
    add_row(frame, [](std::size_t) { return 0.0; });
    for (std::size_t k = 0; k < of_elements_.size(); ++k)
        if (wanted_.columns[given_ + k]) values_[given_ + k].push_back(0);
}

void AtomRows::end() {
    table_.count = table_.lines.size();
    for (std::size_t k = 0; k < names_.size(); ++k)
        table_.columns.push_back({names_[k], std::move(values_[k])});
}

std::vector<std::string_view> cells_of(std::string_view line) {
    std::vector<std::string_view> cells;
    for (std::size_t at = 0; cells.size() <= std::size_t(limits::fields);) {
        at = line.find_first_not_of(" \t\r", at);
        if (at == line.npos) break;
        const std::size_t end = std::min(line.find_first_of(" \t\r", at), line.size());
        cells.push_back(line.substr(at, end - at));
        at = end;
    }
    return cells;
}

} // namespace isomotion::scene
