#include "page/packed_grid.h"

#include <cstdint>

namespace isomotion::page {
namespace {

class Bits {
public:
    explicit Bits(std::vector<std::byte>& into)
        : into_(into) {}

    void add(bool bit) {
        if (count_ % 8 == 0) into_.push_back(std::byte(0));
        if (bit) into_.back() |= std::byte(1u << (count_ % 8));
        ++count_;
    }

private:
    std::vector<std::byte>& into_;
    std::size_t count_ = 0;
};

// The cells that an element matters in, and a block around them.
struct Places {
    glm::ivec3 first{1}, last{0};
    std::vector<glm::ivec3> all; // ascending, x fastest

    void add(const glm::ivec3& place) {
        first = all.empty() ? place : glm::min(first, place);
        last = all.empty() ? place : glm::max(last, place);
        all.push_back(place);
    }
};

// Calls at(place) for the cells from first to last, x fastest.
template<class At> void for_each_cell(const glm::ivec3& first, const glm::ivec3& last, At&& at) {
    for (int z = first.z; z <= last.z; ++z)
        for (int y = first.y; y <= last.y; ++y)
            for (int x = first.x; x <= last.x; ++x) at(glm::ivec3(x, y, z));
}

void pack(const Places& places, std::vector<std::byte>& into) {
    for (const glm::ivec3& corner : {places.first, places.last}) {
        for (int k = 0; k < 3; ++k) into.push_back(std::byte(corner[k]));
    }
    Bits bits(into);
    auto next = places.all.begin();
    for_each_cell(places.first, places.last, [&](const glm::ivec3& place) {
        const bool matters = next != places.all.end() && *next == place;
        if (matters) ++next;
        bits.add(matters);
    });
}

} // namespace

void pack(const elements::ElementGrid& grid, int elements, std::vector<std::byte>& into) {
    std::vector<Places> places{std::size_t(elements)};
    Bits free(into);
    for_each_cell(glm::ivec3(0), grid.across - 1, [&](const glm::ivec3& place) {
        const elements::Cell& cell = grid.at(place);
        free.add(cell.free() > 0);
        for (const std::uint32_t element : grid.list(cell)) places[element].add(place);
    });
    for (const Places& of : places) pack(of, into);
}

} // namespace isomotion::page
