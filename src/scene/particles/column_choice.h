// Which columns of a file become fields of an array.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scene/particles/particle_table.h"

namespace isomotion::scene {

struct ColumnChoice {
    enum class Time { none, frame, seconds };

    std::vector<std::string> fields;
    std::vector<std::size_t> from; // the file's column of each field
    Time time = Time::none;
    std::optional<std::size_t> time_column{}, id_column{};
};

// `columns` maps fields to the file's names of columns. Columns that it leaves out keep their names
// if formulas can use these; others are skipped. A column tells the time only if the file may hold
// many times. Throws NamedColumn.
ColumnChoice choose_columns(const std::vector<std::string>& names,
                            const std::map<std::string, std::string>& columns, bool many_times);

// The column with the velocity of another (vx for x), if there is one.
std::optional<std::size_t> velocity_column(const std::vector<std::string>& names,
                                           std::size_t column);

std::optional<std::size_t> find_column(const std::vector<std::string>& names,
                                       std::string_view name);

} // namespace isomotion::scene
