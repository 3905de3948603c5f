// Packed grids, taken apart again as web/grid.js does it.
#include "page/packed_grid.h"

#include <random>

#include <gmock/gmock.h>

namespace isomotion::page {
namespace {

using elements::Cell, elements::ElementGrid;

// Each cell is free or not, and elements matter in cells as they come.
ElementGrid random_grid(std::mt19937& random, int elements) {
    ElementGrid grid;
    for (int k = 0; k < 3; ++k) grid.across[k] = int(1 + random() % 9);
    grid.cells.resize(std::size_t(grid.across.x * grid.across.y * grid.across.z));
    for (Cell& cell : grid.cells) {
        cell.first = std::uint32_t(grid.listed.size());
        for (int element = 0; element < elements; ++element) {
            if (random() % 7 == 0) grid.listed.push_back(std::uint32_t(element));
        }
        const auto count = std::uint32_t(grid.listed.size()) - cell.first;
        cell.packed = count | (std::uint32_t(random() % 3) << Cell::count_bits);
    }
    return grid;
}

class Reader {
public:
    explicit Reader(const std::vector<std::byte>& bytes)
        : bytes_(bytes) {}
    int byte() { return int(bytes_.at(at_++)); }
    std::vector<bool> bits(int count) {
        std::vector<bool> bits;
        for (int k = 0; k < count; ++k) {
            if (k % 8 == 0) last_ = byte();
            bits.push_back((last_ >> (k % 8) & 1) != 0);
        }
        return bits;
    }
    bool has_ended() const { return at_ == bytes_.size(); }

private:
    const std::vector<std::byte>& bytes_;
    std::size_t at_ = 0;
    int last_ = 0;
};

TEST(PackedGrid, GivesListsAndFreeCellsBack) {
    for (unsigned seed = 1; seed <= 50; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        const int elements = int(random() % 12);
        const ElementGrid grid = random_grid(random, elements);
        std::vector<std::byte> packed;
        pack(grid, elements, packed);
        Reader reader(packed);
        const std::vector<bool> free = reader.bits(int(grid.cells.size()));
        std::vector<std::vector<std::uint32_t>> lists(grid.cells.size());
        for (int element = 0; element < elements; ++element) {
            glm::ivec3 first, last;
            for (int k = 0; k < 3; ++k) first[k] = reader.byte();
            for (int k = 0; k < 3; ++k) last[k] = reader.byte();
            const glm::ivec3 n = glm::max(last - first + 1, glm::ivec3(0));
            const std::vector<bool> matters = reader.bits(n.x * n.y * n.z);
            for (int k = 0; k < int(matters.size()); ++k) {
                if (!matters[std::size_t(k)]) continue;
                const glm::ivec3 place = first + glm::ivec3(k % n.x, k / n.x % n.y, k / n.x / n.y);
                const int cell = (place.z * grid.across.y + place.y) * grid.across.x + place.x;
                lists[std::size_t(cell)].push_back(std::uint32_t(element));
            }
        }
        EXPECT_TRUE(reader.has_ended());
        for (std::size_t k = 0; k < grid.cells.size(); ++k) {
            EXPECT_EQ(free[k], grid.cells[k].free() > 0);
            EXPECT_THAT(lists[k], testing::ElementsAreArray(grid.list(grid.cells[k])));
        }
    }
}

} // namespace
} // namespace isomotion::page
