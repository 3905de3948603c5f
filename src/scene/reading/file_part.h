// The parts of one file that arrays read: each its own columns, of a table that is read once.
#pragma once

#include "animation/element_samples.h"
#include "scene/particles/column_choice.h"
#include "scene/reading/element_table.h"

namespace isomotion::scene {

using Interpolation = animation::ElementSamples::Interpolation;

// The columns of the samples: those of the fields, then velocities that are not fields.
struct SampledColumns {
    std::vector<std::size_t> from; // the file's column of each
    std::vector<std::optional<std::size_t>> velocities;
};

SampledColumns sampled_columns(const ColumnChoice& choice, const std::vector<std::string>& names,
                               std::optional<Interpolation> interpolation);
// The rule asked for; without one, by velocities if there are some. Throws NamedColumn.
Interpolation rule_of(std::optional<Interpolation> asked, const SampledColumns& columns);

// The part of a file that one array reads.
struct Part {
    const TableOptions* options = nullptr;
    ColumnChoice choice;
    SampledColumns columns;
    Interpolation rule = Interpolation::linear;

    // Throws as choose_columns() does. The caller owns the options.
    Part(const TableOptions& asked, const std::vector<std::string>& names, bool many_times);

    bool moves() const { return choice.time != ColumnChoice::Time::none; }
    // Calls use(column) as often as a column's numbers are kept.
    template<class Use> void for_each_use(Use&& use) const {
        for (const std::size_t column : columns.from) use(column);
        if (choice.id_column) use(*choice.id_column);
        if (choice.time_column) use(*choice.time_column);
    }
};

// The columns of a file that was read once; each can be taken as often as the parts use it.
class SharedTable {
public:
    SharedTable(ParticleTable table, const std::filesystem::path& file,
                const std::vector<Part>& parts);

    const ParticleTable& table() const { return table_; }
    std::string place_of(std::size_t row, std::size_t column) const {
        return place(table_, file_, column, row);
    }
    std::vector<double> numbers(std::size_t column);
    std::vector<std::int64_t> whole_numbers(std::size_t column);

private:
    template<class Number>
    std::vector<Number>
    taken(std::size_t column,
          std::vector<Number> (*take)(ParticleTable&, const std::filesystem::path&, std::size_t));

    ParticleTable table_;
    std::filesystem::path file_;
    std::vector<std::size_t> uses_;
};

} // namespace isomotion::scene
