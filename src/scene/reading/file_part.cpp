#include "scene/reading/file_part.h"

#include <algorithm>

namespace isomotion::scene {

SampledColumns sampled_columns(const ColumnChoice& choice, const std::vector<std::string>& names,
                               std::optional<Interpolation> interpolation) {
    SampledColumns columns{choice.from, {}};
    columns.velocities.resize(choice.from.size());
    const bool curved = !interpolation || *interpolation == Interpolation::hermite;
    for (std::size_t c = 0; curved && c < choice.from.size(); ++c) {
        const auto velocity = velocity_column(names, columns.from[c]);
        if (!velocity) continue;
        const auto known = std::ranges::find(columns.from, *velocity);
        columns.velocities[c] = std::size_t(known - columns.from.begin());
        if (known == columns.from.end()) columns.from.push_back(*velocity);
    }
    columns.velocities.resize(columns.from.size());
    return columns;
}

Interpolation rule_of(std::optional<Interpolation> asked, const SampledColumns& columns) {
    const bool has_velocities = std::ranges::any_of(
        columns.velocities, [](const auto& velocity) { return velocity.has_value(); });
    if (asked == Interpolation::hermite && !has_velocities) {
        throw NamedColumn{"vx", "there is no column vx, vy or vz beside x, y or z; interpolation = "
                                "\"hermite\" reads them"};
    }
    return asked.value_or(has_velocities ? Interpolation::hermite : Interpolation::linear);
}

Part::Part(const TableOptions& asked, const std::vector<std::string>& names, bool many_times)
    : options(&asked)
    , choice(choose_columns(names, asked.columns, many_times))
    , columns(sampled_columns(choice, names, asked.interpolation))
    , rule(rule_of(asked.interpolation, columns)) {}

SharedTable::SharedTable(ParticleTable table, const std::filesystem::path& file,
                         const std::vector<Part>& parts)
    : table_(std::move(table))
    , file_(file)
    , uses_(table_.columns.size()) {
    for (const Part& part : parts) part.for_each_use([&](std::size_t column) { ++uses_[column]; });
}

// Those of a text are moved out of the table, so all but the last use get a copy.
template<class Number>
std::vector<Number> SharedTable::taken(std::size_t column,
                                       std::vector<Number> (*take)(ParticleTable&,
                                                                   const std::filesystem::path&,
                                                                   std::size_t)) {
    auto* text = std::get_if<std::vector<double>>(&table_.columns[column].values);
    std::vector<double> kept;
    if (--uses_[column] > 0 && text) kept = *text;
    std::vector<Number> numbers = take(table_, file_, column);
    if (text) *text = std::move(kept);
    return numbers;
}

std::vector<double> SharedTable::numbers(std::size_t column) { return taken(column, take_numbers); }

std::vector<std::int64_t> SharedTable::whole_numbers(std::size_t column) {
    return taken(column, take_whole_numbers);
}

} // namespace isomotion::scene
