// Rows of numbers of a text file as columns, of one time or of several, with what chemical elements
// add to them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/particles/particle_table.h"
#include "scene/particles/words.h"

namespace isomotion::scene {

// What the cells of a row are.
struct RowLayout {
    std::size_t width = 0;                // cells
    std::vector<std::string> names;       // of the columns of numbers
    std::vector<std::size_t> cells;       // of each of these columns
    std::optional<std::size_t> element{}; // the cell that names an element
    bool has_frames = false;              // rows are of several times: a column `frame` tells them
};

// Columns x, y, z, ... from the cell `first` on.
RowLayout layout_without_names(std::size_t width, std::size_t first);

class AtomRows {
public:
    AtomRows(const ParticleRequest& request, const Words& words, ParticleTable& table)
        : request_(request)
        , words_(words)
        , table_(table) {}

    // `count`: at most so many rows follow. Asks which columns are wanted.
    void begin(RowLayout layout, std::size_t count);
    bool has_begun() const { return layout_.width > 0; }

    // Adds the row on the line that was read last. Rows without cells say that there is nothing at
    // that time.
    void add(const std::vector<std::string_view>& cells, int frame = 1);
    void add_none(int frame);

    void end();

private:
    template<class Number> void add_row(int frame, const Number& number);

    const ParticleRequest& request_;
    const Words& words_;
    ParticleTable& table_;
    RowLayout layout_;
    std::vector<std::string> names_; // of all columns: numbers, then an element's, then the time
    std::size_t given_ = 0;          // columns of numbers
    std::vector<std::size_t> of_elements_; // those of element_columns that are added
    Wanted wanted_;
    std::vector<std::vector<double>> values_;
};

// The cells of a line, between blanks; at most one more than a table may have columns.
std::vector<std::string_view> cells_of(std::string_view line);

} // namespace isomotion::scene
