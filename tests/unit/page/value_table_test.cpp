// Packed tables, taken apart again as web/data.js does it.
#include "page/value_table.h"

#include <cmath>

#include <gmock/gmock.h>

namespace isomotion::page {
namespace {

using testing::ElementsAre;

std::vector<std::uint32_t> unpacked(std::span<const std::byte> packed, std::size_t width,
                                    std::size_t rows) {
    std::vector<std::uint32_t> words(width * rows);
    const auto byte = [&](std::size_t at) { return std::uint32_t(packed[at]); };
    std::vector<std::size_t> moving;
    for (std::size_t column = 0; column < width; ++column) {
        for (std::size_t place = 0; place < 4; ++place)
            words[column] |= byte(width + 4 * column + place) << (8 * place);
        if (byte(column) == 1) moving.push_back(column);
    }
    const std::size_t begin = 5 * width, count = moving.size() * (rows - 1);
    EXPECT_EQ(packed.size(), begin + 4 * count);
    for (std::size_t column = 0; column < width; ++column) {
        for (std::size_t row = 1; row < rows; ++row) words[row * width + column] = words[column];
    }
    std::size_t k = 0;
    for (const std::size_t column : moving) {
        for (std::size_t row = 1; row < rows; ++row, ++k) {
            std::uint32_t difference = 0;
            for (std::size_t plane = 0; plane < 4; ++plane)
                difference |= byte(begin + plane * count + k) << (8 * (3 - plane));
            words[row * width + column] = words[(row - 1) * width + column] + difference;
        }
    }
    return words;
}

TEST(ValueTable, GivesEveryWordBack) {
    ValueTable table("t");
    std::vector<std::uint32_t> all;
    for (int row = 0; row < 5; ++row) {
        const std::vector<double> numbers{3.5, std::sin(row), row % 2 ? -HUGE_VAL : 1e-300};
        const auto words = words_of(std::span<const double>(numbers));
        table.add(words);
        all.insert(all.end(), words.begin(), words.end());
    }
    EXPECT_EQ(table.width(), 6u);
    EXPECT_EQ(table.rows(), 5u);
    std::vector<std::byte> packed;
    table.pack(packed);
    EXPECT_EQ(unpacked(packed, 6, 5), all);
}

TEST(ValueTable, KeepsWhatStandsOnce) {
    ValueTable table("t");
    const std::vector<float> row(100, 0.25f);
    for (int k = 0; k < 1000; ++k) table.add(words_of(std::span<const float>(row)));
    std::vector<std::byte> packed;
    table.pack(packed);
    EXPECT_EQ(packed.size(), 500u);
    EXPECT_EQ(table.moving(), 0u);
}

TEST(ValueTable, CountsColumnsFromTheRowInWhichTheyMove) {
    ValueTable table("t");
    std::vector<std::uint32_t> row{1, 2, 3}, all;
    for (std::uint32_t k = 0; k < 6; ++k) {
        if (k == 2) row[1] = 7;
        if (k > 3) row[2] = k;
        table.add(row);
        all.insert(all.end(), row.begin(), row.end());
        EXPECT_EQ(table.moving(), k < 2 ? 0u : k < 4 ? 1u : 2u);
    }
    std::vector<std::byte> packed;
    table.pack(packed);
    EXPECT_EQ(unpacked(packed, 3, 6), all);
}

TEST(ValueTable, MayBeEmpty) {
    ValueTable table("t");
    table.add({});
    table.add({});
    std::vector<std::byte> packed;
    table.pack(packed);
    EXPECT_TRUE(packed.empty());
    EXPECT_THROW(table.add(std::vector<std::uint32_t>{1}), std::logic_error);
}

TEST(Words, AreBitsFromTheLowest) {
    const std::vector<double> numbers{1.0};
    EXPECT_THAT(words_of(std::span<const double>(numbers)), ElementsAre(0u, 0x3ff00000u));
    const std::vector<float> floats{1.0f};
    EXPECT_THAT(words_of(std::span<const float>(floats)), ElementsAre(0x3f800000u));
}

} // namespace
} // namespace isomotion::page
