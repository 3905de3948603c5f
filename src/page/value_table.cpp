#include "page/value_table.h"

#include <bit>
#include <stdexcept>

namespace isomotion::page {
namespace {

std::byte byte_of(std::uint32_t word, int place) { return std::byte(word >> (8 * place) & 0xff); }

} // namespace

void ValueTable::add(std::span<const std::uint32_t> row) {
    if (rows_ == 0) width_ = row.size();
    if (row.size() != width_) throw std::logic_error("rows of a table have one length");
    words_.insert(words_.end(), row.begin(), row.end());
    ++rows_;
}

void ValueTable::pack(std::vector<std::byte>& into) const {
    const auto word = [&](std::size_t row, std::size_t column) {
        return words_[row * width_ + column];
    };
    std::vector<std::uint32_t> differences; // of the columns that move
    for (std::size_t column = 0; column < width_; ++column) {
        bool moves = false;
        for (std::size_t row = 1; row < rows_; ++row) moves |= word(row, column) != word(0, column);
        into.push_back(std::byte(moves));
        if (!moves) continue;
        for (std::size_t row = 1; row < rows_; ++row)
            differences.push_back(word(row, column) - word(row - 1, column));
    }
    for (std::size_t column = 0; column < width_; ++column) {
        for (int place = 0; place < 4; ++place) into.push_back(byte_of(word(0, column), place));
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
