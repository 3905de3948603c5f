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

// `columns` are fields and what the file calls them. Columns that it leaves out keep their names
// where formulas can say them; others are skipped. Only where a file may hold many times does a
// column tell the time. Throws NamedColumn.
ColumnChoice choose_columns(const std::vector<std::string>& names,
                            const std::map<std::string, std::string>& columns, bool many_times);

// The column with the velocity of another, vx of x, if there is one.
std::optional<std::size_t> velocity_column(const std::vector<std::string>& names,
                                           std::size_t column);

std::optional<std::size_t> find_column(const std::vector<std::string>& names,
                                       std::string_view name);

} // namespace isomotion::scene
