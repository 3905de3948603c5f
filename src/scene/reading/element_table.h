// Elements of an array from a file of any format that scene/particles reads, or from a file for
// each frame.
//
// In CSV and NPY a column `frame` (whole numbers, evenly spaced), `t` or `time` (seconds) makes
// elements move. Its rows come in the order of time; in CSV a row with nothing but the time says
// that there are no elements then. A column `id` (whole numbers) tells which elements of
// neighbouring times are the same.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "animation/timeline.h"
#include "base/confines.h"

namespace isomotion::scene {

struct ElementTable {
    std::shared_ptr<const animation::ElementSamples> samples;
    std::vector<std::string> fields; // the first columns of the samples
    std::string first, last;         // where the first elements and the last are, for messages
};

// What all tables of a scene together may still hold.
struct TableBudget {
    std::size_t bytes = 0;
    double values = 0;
};

// How a scene reads a file.
struct TableOptions {
    std::filesystem::path file;
    base::Confines within{};                    // where files must lie when they are opened
    std::map<std::string, std::string> columns; // field to the column it is called in the file
    // Without a value: by velocities where the file has some, else straight.
    std::optional<animation::ElementSamples::Interpolation> interpolation{};
    int most = 0; // elements at one time

    // A file for each frame: frames of the scene, ascending, and the file of each.
    std::vector<std::pair<std::int64_t, std::filesystem::path>> frames{};
    bool counts_files = false; // `most` is a limit only: files are asked how many there are

    bool operator==(const TableOptions&) const = default;
};

// What several arrays make of one file, or of the same files of frames, each in its own way: one
// table for each of `options`. Columns that `columns` leaves out keep their names where formulas
// can say them; others are skipped. `timeline` turns frames into times. Takes off the budget the
// bytes of the file once, and every number that is kept, times and ids too. Throws SceneError
// ("drops.csv:12: mass: ..."), and for what exceeds the budget before it is read.
std::vector<ElementTable> read_element_tables(std::span<const TableOptions> options,
                                              const animation::Timeline& timeline,
                                              TableBudget& budget);

} // namespace isomotion::scene
