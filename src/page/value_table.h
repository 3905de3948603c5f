// Numbers of every frame as a page stores them: rows of 32-bit words, packed so that they deflate
// well.
//
// Most columns never change, and the others change little from one frame to the next. A packed
// table is:
//
//   one byte per column: 1 if it changes;
//   the first row, four bytes per word, little-endian;
//   for the changing columns the differences of each row from the one before, column by column: the
//   most significant byte of all differences, then the next of all, down to the least.
//
// src/page/web/data.js unpacks it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace isomotion::page {

class ValueTable {
public:
    explicit ValueTable(std::string name)
        : name_(std::move(name)) {}

    // Adds a row. All rows are as long as the first; throws std::logic_error for others.
    void add(std::span<const std::uint32_t> row);

    const std::string& name() const { return name_; }
    std::size_t width() const { return first_.size(); } // words per row
    std::size_t rows() const { return rows_; }
    std::size_t moving() const { return moving_; } // columns
    bool moves(std::size_t column) const { return !columns_[column].empty(); }
    std::uint32_t word(std::size_t row, std::size_t column) const {
        return moves(column) ? columns_[column][row] : first_[column];
    }
    // Makes a column 0 in all rows.
    void clear(std::size_t column);

    void pack(std::vector<std::byte>& into) const;

private:
    std::string name_;
    std::size_t rows_ = 0, moving_ = 0;
    std::vector<std::uint32_t> first_;                // row
    std::vector<std::vector<std::uint32_t>> columns_; // all rows of those that move, others empty
};

// A row of floats or of doubles; a double is two words, the lower one first.
std::vector<std::uint32_t> words_of(std::span<const float> numbers);
std::vector<std::uint32_t> words_of(std::span<const double> numbers);

} // namespace isomotion::page
