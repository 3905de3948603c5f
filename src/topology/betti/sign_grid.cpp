#include "topology/betti/sign_grid.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <utility>

#include "formula/evaluate/clones.h"

namespace isomotion::topology {
namespace {

using Word = SignGrid::Word;

// Simplices are counted at their least vertex v. Those that have v for a face are the cone from v
// over a complex on the seven vertices v + {0, 1}^3: over a hexagon of six (the order of inclusion
// of its coordinates), itself coned from v + (1, 1, 1). So v adds 1 - chi of what the solid has of
// that: 0 where (1, 1, 1) is there, else 1 - vertices + edges of the hexagon.
ISOMOTION_CLONES("popcnt") std::int64_t euler(const SignGrid& solid) {
    const int side = solid.side();
    const std::vector<Word> none(solid.row(0, 0).size());
    const auto row = [&](int y, int z) -> std::span<const Word> {
        return y < side && z < side ? solid.row(y, z) : none;
    };
    std::int64_t chi = 0;
    for (int z = 0; z < side; ++z) {
        for (int y = 0; y < side; ++y) {
            const auto o = row(y, z), oy = row(y + 1, z), oz = row(y, z + 1),
                       oyz = row(y + 1, z + 1);
            for (std::size_t w = 0; w < o.size(); ++w) {
                const auto ahead = [&](std::span<const Word> r) { // of the vertices at x + 1
                    return r[w] >> 1 | (w + 1 < r.size() ? r[w + 1] << 63 : 0);
                };
                const Word v = o[w] & ~ahead(oyz);
                if (v == 0) continue;
                const Word hexagon[] = {v & ahead(o), v & ahead(oy), v & oy[w],
                                        v & oyz[w],   v & oz[w],     v & ahead(oz)};
                chi += std::popcount(v);
                for (int k = 0; k < 6; ++k) {
                    chi -= std::popcount(hexagon[k]);
                    chi += std::popcount(hexagon[k] & hexagon[(k + 1) % 6]);
                }
            }
        }
    }
    return chi;
}

class DisjointSets {
public:
    int add() {
        parent_.push_back(int(parent_.size()));
        ++sets_;
        return parent_.back();
    }
    // The set that both are then in.
    int unite(int a, int b) {
        a = root(a);
        b = root(b);
        if (a == b) return a;
        if (b < a) std::swap(a, b);
        parent_[std::size_t(b)] = a;
        --sets_;
        return a;
    }
    int sets() const { return sets_; }

private:
    int root(int a) {
        while (parent_[std::size_t(a)] != a) {
            int& up = parent_[std::size_t(a)];
            up = parent_[std::size_t(up)];
            a = up;
        }
        return a;
    }

    std::vector<int> parent_;
    int sets_ = 0;
};

// Vertices of one row and side without a gap.
struct Run {
    int first, last;
    int set;
};

enum class Part { solid, complement };

template<class Emit> void each_run(std::span<const Word> row, int side, Part part, Emit&& emit) {
    int first = -1;
    Word before = 0;
    for (std::size_t w = 0; w < row.size(); ++w) {
        const int begin = int(w) * 64;
        const auto left = unsigned(side - begin); // columns from there on
        const Word all = left >= 64 ? ~Word(0) : (Word(1) << left) - 1;
        const Word bits = (part == Part::solid ? row[w] : ~row[w]) & all;
        for (Word ends = bits ^ (bits << 1 | before); ends != 0; ends &= ends - 1) {
            const int at = begin + std::countr_zero(ends);
            if (first < 0) {
                first = at;
            } else {
                emit(first, at - 1);
                first = -1;
            }
        }
        before = bits >> 63;
    }
    if (first >= 0) emit(first, side - 1);
}

// Unites two rows, the upper one before the lower in y, in z or in both: a vertex has two
// neighbours there, at its own x and the one after.
void unite_rows(std::span<const Run> lower, std::span<Run> upper, DisjointSets& sets) {
    for (std::size_t i = 0, j = 0; i < lower.size() && j < upper.size();) {
        const Run& a = lower[i];
        Run& b = upper[j];
        if (b.first <= a.last + 1 && b.last >= a.first && a.set != b.set)
            b.set = sets.unite(a.set, b.set);
        a.last < b.last ? ++i : ++j;
    }
}

// Components, of the complement with all that is outside of the grid.
int components(const SignGrid& grid, Part part) {
    const int side = grid.side();
    DisjointSets sets;
    const int outside = part == Part::complement ? sets.add() : -1;
    // The runs by y, of this z and of the one before.
    std::vector<std::vector<Run>> rows(static_cast<std::size_t>(side)), below = rows;
    for (int z = 0; z < side; ++z) {
        std::swap(rows, below);
        for (int y = 0; y < side; ++y) {
            auto& runs = rows[std::size_t(y)];
            runs.clear();
            const bool on_bounds = y == 0 || y == side - 1 || z == 0 || z == side - 1;
            each_run(grid.row(y, z), side, part, [&](int first, int last) {
                runs.push_back({first, last, sets.add()});
                if (outside >= 0 && (on_bounds || first == 0 || last == side - 1))
                    sets.unite(outside, runs.back().set);
            });
            if (y > 0) unite_rows(rows[std::size_t(y) - 1], runs, sets);
            if (z > 0) unite_rows(below[std::size_t(y)], runs, sets);
            if (y > 0 && z > 0) unite_rows(below[std::size_t(y) - 1], runs, sets);
        }
    }
    return sets.sets();
}

} // namespace

SignGrid::SignGrid(int side)
    : side_(side)
    , words_((std::size_t(side) + 63) / 64)
    , bits_(words_ * std::size_t(side) * std::size_t(side)) {
    assert(side > 0);
}

void SignGrid::set_run(int first, int last, int y, int z) {
    const auto words = row(y, z);
    for (int x = first; x <= last;) {
        const int in_word = x % 64, count = std::min(64 - in_word, last - x + 1);
        const Word ones = count == 64 ? ~Word(0) : (Word(1) << count) - 1;
        words[std::size_t(x) / 64] |= ones << in_word;
        x += count;
    }
}

Betti betti(const SignGrid& solid) {
    Betti b;
    b.components = components(solid, Part::solid);
    b.voids = components(solid, Part::complement) - 1; // Alexander duality
    b.tunnels = b.components + b.voids - int(euler(solid));
    return b;
}

} // namespace isomotion::topology
