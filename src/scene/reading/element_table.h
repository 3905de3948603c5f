// Elements of an array from a file of comma-separated values: a header of names, then one element a
// line.
//
// A column `frame` (whole numbers, evenly spaced) or `t` (seconds) makes elements move; its rows
// come in the order of time, and a row that has nothing but the time says that there are none then.
// A column `id` (whole numbers) tells which elements of neighbouring times are the same. Blank
// lines and those that begin with # are passed over.
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

// How a scene takes a file.
struct TableReading {
    std::filesystem::path file;
    std::map<std::string, std::string> columns; // field to the column it is called in the file
    animation::ElementSamples::Interpolation interpolation =
        animation::ElementSamples::Interpolation::linear;
    int most = 0; // elements at one time
};

// Columns that `columns` leaves out keep their names where formulas could say them; others are left
// where they are. Frames become times by `timeline`. Throws SceneError ("drops.csv:12: mass: ...").
ElementTable read_element_table(const TableReading& reading, const animation::Timeline& timeline);

} // namespace isomotion::scene
