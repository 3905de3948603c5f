#include "page/value_table.h"

#include <bit>
#include <stdexcept>

namespace isomotion::page {
namespace {

std::byte byte_of(std::uint32_t word, int place) { return std::byte(word >> (8 * place) & 0xff); }

} // namespace

void ValueTable::add(std::span<const std::uint32_t> row) {
    if (rows_ == 0) {
        first_.assign(row.begin(), row.end());
        columns_.resize(row.size());
    }
    if (row.size() != width()) throw std::logic_error("rows of a table have one length");
    for (std::size_t k = 0; k < row.size(); ++k) {
        std::vector<std::uint32_t>& column = columns_[k];
        if (column.empty() && row[k] == first_[k]) continue;
        if (column.empty()) {
            column.assign(rows_, first_[k]);
            ++moving_;
        }
        column.push_back(row[k]);
    }
    ++rows_;
}

void ValueTable::clear(std::size_t column) {
    moving_ -= std::size_t(moves(column));
    columns_[column].clear();
    first_[column] = 0;
}

void ValueTable::pack(std::vector<std::byte>& into) const {
    std::vector<std::uint32_t> differences; // of the columns that move
    for (const std::vector<std::uint32_t>& column : columns_) {
        into.push_back(std::byte(!column.empty()));
        for (std::size_t row = 1; row < column.size(); ++row)
            differences.push_back(column[row] - column[row - 1]);
    }
    for (const std::uint32_t word : first_) {
        for (int place = 0; place < 4; ++place) into.push_back(byte_of(word, place));
    }
    for (int place = 3; place >= 0; --place) {
        for (const std::uint32_t difference : differences)
            into.push_back(byte_of(difference, place));
    }
}

std::vector<std::uint32_t> words_of(std::span<const float> numbers) {
    std::vector<std::uint32_t> words;
    words.reserve(numbers.size());
    for (const float number : numbers) words.push_back(std::bit_cast<std::uint32_t>(number));
    return words;
}

std::vector<std::uint32_t> words_of(std::span<const double> numbers) {
    std::vector<std::uint32_t> words;
    words.reserve(2 * numbers.size());
    for (const double number : numbers) {
        const auto bits = std::bit_cast<std::uint64_t>(number);
        words.push_back(std::uint32_t(bits));
        words.push_back(std::uint32_t(bits >> 32));
    }
    return words;
}

} // namespace isomotion::page
