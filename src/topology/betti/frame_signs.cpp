#include "topology/betti/frame_signs.h"

#include <algorithm>
#include <memory>
#include <thread>

#include "base/workers.h"
#include "topology/field/frame_field.h"

namespace isomotion::topology {
namespace {

constexpr int whole = 8, part = 4; // vertices along the edge of a block, and of its eight parts

// Vertices `first` to `last` of each axis.
struct Block {
    std::array<int, 3> first, last;
};

// One thread's work: a layer of blocks, `whole` vertices high. Of most blocks an enclosure tells
// the sign at all of their vertices; in the others these are evaluated.
class BlockSigns {
public:
    BlockSigns(const formula::Field& field, const formula::Bindings<double>& bindings,
               const scene::BoundsAt& bounds, Side solid, SignGrid& grid)
        : evaluator_(field.value)
        , enclosures_(space_formula(field, formula::convert<formula::Interval>(bindings), solid))
        , everything_(enclosures_.everything())
        , bindings_(bindings)
        , bounds_(bounds)
        , solid_(solid)
        , grid_(grid) {
        for (std::size_t i = 0; i < 3; ++i) {
            const double low = bounds.min[int(i)], high = bounds.max[int(i)];
            for (int k = 0; k < grid.side(); ++k)
                at_[i].push_back(low + double(k) / (grid.side() - 1) * (high - low));
        }
    }

    void make(int layer) {
        std::vector<Block> blocks;
        for (int y = 0; y < grid_.side(); y += whole) {
            for (int x = 0; x < grid_.side(); x += whole)
                blocks.push_back(block({x, y, layer * whole}, whole));
        }
        std::vector<Block> parts;
        for (const Block& one : undecided(blocks)) {
            for (int k = 0; k < 8; ++k) {
                std::array<int, 3> first = one.first;
                for (int i = 0; i < 3; ++i) first[std::size_t(i)] += (k >> i & 1) * part;
                const Block eighth = block(first, part);
                if (std::ranges::equal(eighth.first, eighth.last, std::less_equal{}))
                    parts.push_back(eighth);
            }
        }
        std::vector<std::array<int, 3>> vertices;
        for (const Block& one : undecided(parts)) {
            each_inside(one, [&](const std::array<int, 3>& v) { vertices.push_back(v); });
        }
        evaluate(vertices);
    }

private:
    Block block(const std::array<int, 3>& first, int side) const {
        Block block{first, first};
        for (int& last : block.last) last = std::min(last + side, grid_.side()) - 1;
        return block;
    }

    template<class Do> void each_inside(const Block& block, const Do& act) const {
        for (int z = block.first[2]; z <= block.last[2]; ++z) {
            for (int y = block.first[1]; y <= block.last[1]; ++y) {
                for (int x = block.first[0]; x <= block.last[0]; ++x) {
                    if (is_inside(x, y, z)) act(std::array{x, y, z});
                }
            }
        }
    }

    bool is_inside(int x, int y, int z) const {
        const glm::dvec3 p{at_[0][std::size_t(x)], at_[1][std::size_t(y)], at_[2][std::size_t(z)]};
        return bounds_.shape == scene::Bounds::Shape::box ||
               glm::distance(p, bounds_.centre) <= bounds_.radius;
    }

    // Those with vertices on both sides, as far as is known.
    std::vector<Block> undecided(std::span<const Block> blocks) {
        std::vector<SpaceBox> boxes;
        for (const Block& one : blocks) {
            SpaceBox& box = boxes.emplace_back();
            for (std::size_t i = 0; i < 3; ++i)
                box[i] = {at_[i][std::size_t(one.first[i])], at_[i][std::size_t(one.last[i])]};
        }
        std::vector<formula::Interval> g(boxes.size());
        enclosures_.values(everything_, boxes, g);
        std::vector<Block> open;
        for (std::size_t k = 0; k < blocks.size(); ++k) {
            if (g[k].lo > 0) continue;
            if (g[k].hi < 0) {
                each_inside(blocks[k], [&](const auto& v) { grid_.set(v[0], v[1], v[2]); });
            } else {
                open.push_back(blocks[k]);
            }
        }
        return open;
    }

    void evaluate(std::span<const std::array<int, 3>> vertices) {
        std::array<std::vector<double>, 3> points;
        for (const auto& v : vertices) {
            for (std::size_t i = 0; i < 3; ++i) points[i].push_back(at_[i][std::size_t(v[i])]);
        }
        std::vector<double> f(vertices.size());
        const std::array<std::span<const double>, 3> inputs{points[0], points[1], points[2]};
        const std::array<std::span<double>, 1> outputs{f};
        evaluator_.points(bindings_, inputs, outputs);
        for (std::size_t k = 0; k < vertices.size(); ++k) {
            const bool is_solid = solid_ == Side::negative ? f[k] < 0 : f[k] > 0;
            if (is_solid) grid_.set(vertices[k][0], vertices[k][1], vertices[k][2]);
        }
    }

    formula::Evaluator<double> evaluator_;
    FrameField enclosures_;
    Elements everything_;
    const formula::Bindings<double>& bindings_;
    const scene::BoundsAt& bounds_;
    Side solid_;
    SignGrid& grid_;
    std::array<std::vector<double>, 3> at_; // coordinates of vertices
};

} // namespace

SignGrid frame_signs(const formula::Field& field, const formula::Bindings<double>& bindings,
                     const scene::BoundsAt& bounds, Side solid, int side, int threads) {
    SignGrid grid(side);
    const auto layers = [&] {
        return [blocks = std::make_unique<BlockSigns>(field, bindings, bounds, solid, grid)](
                   std::size_t layer) { blocks->make(int(layer)); };
    };
    const int wanted = threads > 0 ? threads : int(std::thread::hardware_concurrency());
    base::share({.count = std::size_t((side + whole - 1) / whole), .threads = wanted}, layers);
    return grid;
}

} // namespace isomotion::topology
