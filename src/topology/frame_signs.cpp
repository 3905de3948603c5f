#include "topology/frame_signs.h"

#include <algorithm>
#include <thread>

#include "topology/workers.h"

namespace isomotion::topology {
namespace {

double coordinate(const scene::BoundsAt& bounds, int axis, int index, int side) {
    const double part = double(index) / (side - 1);
    return bounds.min[axis] + part * (bounds.max[axis] - bounds.min[axis]);
}

// One thread's work: rows along x.
class RowSigns {
public:
    RowSigns(const formula::Field& field, const formula::Bindings<double>& bindings,
             const scene::BoundsAt& bounds, Side solid, SignGrid& grid)
        : evaluator_(field.value)
        , bindings_(bindings)
        , bounds_(bounds)
        , solid_(solid)
        , grid_(grid)
        , x_(static_cast<std::size_t>(grid.side()))
        , y_(x_.size())
        , z_(x_.size())
        , f_(x_.size()) {
        for (int i = 0; i < grid.side(); ++i)
            x_[std::size_t(i)] = coordinate(bounds, 0, i, grid.side());
    }

    void make(int y, int z) {
        std::ranges::fill(y_, coordinate(bounds_, 1, y, grid_.side()));
        std::ranges::fill(z_, coordinate(bounds_, 2, z, grid_.side()));
        const std::array<std::span<const double>, 3> inputs{x_, y_, z_};
        const std::array<std::span<double>, 1> outputs{f_};
        evaluator_.points(bindings_, inputs, outputs);
        for (int x = 0; x < grid_.side(); ++x) {
            const auto i = std::size_t(x);
            const bool is_solid = solid_ == Side::negative ? f_[i] < 0 : f_[i] > 0;
            if (is_solid && is_inside({x_[i], y_[i], z_[i]})) grid_.set(x, y, z);
        }
    }

private:
    bool is_inside(const glm::dvec3& p) const {
        return bounds_.shape == scene::Bounds::Shape::box ||
               glm::distance(p, bounds_.centre) <= bounds_.radius;
    }

    formula::Evaluator<double> evaluator_;
    const formula::Bindings<double>& bindings_;
    const scene::BoundsAt& bounds_;
    Side solid_;
    SignGrid& grid_;
    std::vector<double> x_, y_, z_, f_;
};

} // namespace

SignGrid frame_signs(const formula::Field& field, const formula::Bindings<double>& bindings,
                     const scene::BoundsAt& bounds, Side solid, int side, int threads) {
    SignGrid grid(side);
    const auto slabs = [&] {
        return
            [side, rows = RowSigns(field, bindings, bounds, solid, grid)](std::size_t z) mutable {
                for (int y = 0; y < side; ++y) rows.make(y, int(z));
            };
    };
    const int wanted = threads > 0 ? threads : int(std::thread::hardware_concurrency());
    share({.count = std::size_t(side), .threads = wanted}, slabs);
    return grid;
}

} // namespace isomotion::topology
