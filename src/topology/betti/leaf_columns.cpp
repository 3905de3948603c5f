#include "topology/betti/leaf_columns.h"

#include <algorithm>
#include <bit>

namespace isomotion::topology {

LeafColumns::LeafColumns(const std::array<std::array<int, 2>, 3>& range, std::size_t axis,
                         bool rises)
    : range_(range)
    , axis_(axis)
    , u_((axis + 1) % 3)
    , v_((axis + 2) % 3)
    , rises_(rises)
    , last_(steps(axis_))
    , wide_(steps(u_))
    , high_(steps(v_))
    , coarsest_(int(std::bit_ceil(unsigned(std::max(wide_, high_)) + 1)))
    , columns_(std::size_t(wide_ + 1) * std::size_t(high_ + 1)) {}

void LeafColumns::guess(const At& at, int stride) {
    const auto [i, j] = at;
    Column& made = column(at);
    made.not_solid = last_ + 1;
    made.guess = last_ / 2;
    if (stride == coarsest_) return;
    const int di = i / stride % 2 ? stride : 0, dj = j / stride % 2 ? stride : 0;
    const int before = column({i - di, j - dj}).solid;
    const bool has_after = i + di <= wide_ && j + dj <= high_;
    made.guess = has_after ? (before + column({i + di, j + dj}).solid) / 2 : before;
}

double LeafColumns::lost() const {
    double lost = 0;
    for (const Column& done : columns_) {
        if (done.not_solid <= last_) lost = std::max(lost, -done.beyond.lo);
    }
    return lost;
}

void LeafColumns::draw(SignGrid& grid) const {
    for (int j = 0; j <= high_; ++j) {
        for (int i = 0; i <= wide_; ++i) {
            const Column& done = column({i, j});
            if (done.solid == 0) continue;
            const Vertex first = vertex({i, j}, 0), last = vertex({i, j}, done.solid - 1);
            if (axis_ == 0) {
                grid.set_run(std::min(first[0], last[0]), std::max(first[0], last[0]), first[1],
                             first[2]);
                continue;
            }
            for (int number = 0; number < done.solid; ++number) {
                const Vertex at = vertex({i, j}, number);
                grid.set(at[0], at[1], at[2]);
            }
        }
    }
}

} // namespace isomotion::topology
