// Reads the elements of an array from a file of any format that scene/particles reads, or from one
// file per frame.
//
// In CSV and NPY, elements move if there is a column `frame` (whole numbers, evenly spaced), or `t`
// or `time` (seconds). Rows come in order of time; in CSV a row with only the time states that
// there are no elements then. A column `id` (whole numbers) identifies elements across neighbouring
// times.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "animation/element_samples.h"
#include "animation/timeline.h"
#include "base/confines.h"

namespace isomotion::scene {

struct ElementTable {
    std::shared_ptr<const animation::ElementSamples> samples;
    std::vector<std::string> fields;     // the first columns of the samples
    std::set<std::string> of_elements{}; // fields that chemical elements may have given
    std::string first, last; // the places of the first and the last elements, for messages
};

// What all tables of a scene together may still use.
struct TableBudget {
    std::size_t bytes = 0;
    double values = 0;
};

// How a scene reads a file.
struct TableOptions {
    std::filesystem::path file;
    base::Confines within{};                    // where files must lie when they are opened
    std::map<std::string, std::string> columns; // field -> the file's name of its column
    // Unset: by velocities if the file has some, otherwise linear.
    std::optional<animation::ElementSamples::Interpolation> interpolation{};
    int most = 0; // limit on elements at one time

    // One file per frame: the scene's frames, ascending, with their files.
    std::vector<std::pair<std::int64_t, std::filesystem::path>> frames{};
    bool counts_files = false; // `most` is only a limit: count the particles in the files

    bool operator==(const TableOptions&) const = default;
};

// Reads one file, or one sequence of files, for several arrays, each in its own way: one table for
// each of `options`. Columns that `columns` leaves out keep their names if formulas can use these;
// others are skipped. `timeline` turns frames into times. Subtracts from the budget the bytes of
// the file once, and every number that is kept, times and ids included. Throws SceneError
// ("drops.csv:12: mass: ..."), also for data beyond the budget, before it is read.
std::vector<ElementTable> read_element_tables(std::span<const TableOptions> options,
                                              const animation::Timeline& timeline,
                                              TableBudget& budget);

} // namespace isomotion::scene
