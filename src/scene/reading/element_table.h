// Elements of an array from a file of comma-separated values: a header of names, then one element a
// line.
//
// A column `frame` (whole numbers, evenly spaced) or `t` (seconds) makes elements move. Its rows
// come in the order of time; a row with nothing but the time says that there are no elements then.
// A column `id` (whole numbers) tells which elements of neighbouring times are the same. Blank
// lines and lines that begin with # are skipped.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "animation/timeline.h"

namespace isomotion::scene {

struct ElementTable {
    std::shared_ptr<const animation::ElementSamples> samples; // one column for each of `fields`
    std::vector<std::string> fields;
    int first_line = 0, last_line = 0; // of elements, for messages
};

// What all tables of a scene together may still hold.
struct TableBudget {
    std::size_t bytes = 0;
    double values = 0;
};

// How a scene reads a file.
struct TableOptions {
    std::filesystem::path file;
    std::map<std::string, std::string> columns; // field to the column it is called in the file
    animation::ElementSamples::Interpolation interpolation =
        animation::ElementSamples::Interpolation::linear;
    int most = 0; // elements at one time

    bool operator==(const TableOptions&) const = default;
};

// Columns that `columns` leaves out keep their names where formulas can say them; others are
// skipped. `timeline` turns frames into times. Takes what it holds off the budget. Throws
// SceneError
// ("drops.csv:12: mass: ..."), and for what exceeds the budget before it is read.
ElementTable read_element_table(const TableOptions& options, const animation::Timeline& timeline,
                                TableBudget& budget);

} // namespace isomotion::scene
