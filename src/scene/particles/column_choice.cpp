#include "scene/particles/column_choice.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/nearest_name.h"
#include "formula/graph/vocabulary.h"

namespace isomotion::scene {

std::optional<std::size_t> find_column(const std::vector<std::string>& names,
                                       std::string_view name) {
    const auto it = std::ranges::find(names, name);
    if (it == names.end()) return std::nullopt;
    return std::size_t(it - names.begin());
}

std::optional<std::size_t> velocity_column(const std::vector<std::string>& names,
                                           std::size_t column) {
    const std::string& name = names[column];
    if (name != "x" && name != "y" && name != "z") return std::nullopt;
    return find_column(names, "v" + name);
}

ColumnChoice choose_columns(const std::vector<std::string>& names,
                            const std::map<std::string, std::string>& columns, bool many_times) {
    ColumnChoice choice;
    if (many_times) {
        const auto frame = find_column(names, "frame"), t = find_column(names, "t");
        if (frame && t) {
            throw NamedColumn{
                "t", "the file has a column `frame` already; one of the two tells the time"};
        }
        const auto seconds = t || frame ? t : find_column(names, "time");
        choice.time = frame     ? ColumnChoice::Time::frame
                      : seconds ? ColumnChoice::Time::seconds
                                : ColumnChoice::Time::none;
        choice.time_column = frame ? frame : seconds;
    }
    choice.id_column = find_column(names, "id");
    std::vector<bool> taken(names.size(), false);
    for (const auto& [field, name] : columns) {
        const auto from = find_column(names, name);
        if (!from) {
            const std::string near = base::nearest_name(name, names);
            throw NamedColumn{
                name, near.empty()
                          ? fmt::format("there is no such column; the file has {}",
                                        fmt::join(names, ", "))
                          : fmt::format("there is no such column; did you mean '{}'?", near)};
        }
        taken[*from] = true;
        choice.fields.push_back(field);
        choice.from.push_back(*from);
    }
    for (std::size_t k = 0; k < names.size(); ++k) {
        const std::string& name = names[k];
        const bool spoken = formula::is_identifier(name) && !formula::is_reserved(name) &&
                            name != "t" && name != "i" && name != "n" && name != "frame" &&
                            name != "id" && k != choice.time_column;
        if (taken[k] || !spoken || columns.count(name)) continue;
        choice.fields.push_back(name);
        choice.from.push_back(k);
    }
    return choice;
}

} // namespace isomotion::scene
