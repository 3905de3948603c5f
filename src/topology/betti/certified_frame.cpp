#include "topology/betti/certified_frame.h"

#include <algorithm>
#include <cassert>
#include <vector>

#include "topology/betti/cell_frame.h"
#include "topology/betti/leaf_columns.h"
#include "topology/betti/planes.h"
#include "topology/betti/separable_frame.h"
#include "topology/betti/sign_grid.h"

namespace isomotion::topology {
namespace {

using formula::Interval;

constexpr int most_vertices = 1025; // of a grid along each axis
constexpr const char interrupted[] = "interrupted";
constexpr const char reaches_bounds[] = "the solid reaches the bounds";
// Boxes are evaluated with a rim of this part of their side, so that gradients beside a wall
// between two boxes are in the enclosures of both.
constexpr double rim = 0x1p-30;

// Elements are chosen for cells whose depth is a multiple of this one, and shared by those in them.
// Many boxes evaluated together cost less than each alone.
constexpr int choice_of_elements = 2;
// About so many columns of vertices are asked together.
constexpr std::size_t columns_together = 1024;

// One value of each enclosure. The topology is the same for all (docs/topology-frames.md), so the
// signs may be those of any.
formula::Bindings<Interval> one_of(formula::Bindings<Interval> bindings, std::size_t parameters) {
    for (Interval& value : std::span(bindings.parameters).first(parameters)) value = mid(value);
    for (auto& array : bindings.arrays) {
        for (auto& column : array.fields) {
            for (Interval& value : column) value = mid(value);
        }
    }
    return bindings;
}

formula::Bindings<Interval> one_of(formula::Bindings<Interval> bindings) {
    const std::size_t all = bindings.parameters.size();
    return one_of(std::move(bindings), all);
}

// Remainders of far elements hold those of each value.
Elements one_of(Elements elements) {
    const std::size_t parameters =
        elements.own_parameters.value_or(elements.bindings.parameters.size());
    elements.bindings = one_of(std::move(elements.bindings), parameters);
    return elements;
}

// A box of the octree: cell (x, y, z) of the 2^depth in each direction.
struct Cell {
    int depth = 0;
    std::array<int, 3> at{};

    int last() const { return (1 << depth) - 1; }
    bool touches_wall(std::size_t axis) const { return at[axis] == 0 || at[axis] == last(); }
};

// Where grids are. One function says where a vertex is for all depths, so that grids share theirs.
class Places {
public:
    explicit Places(const scene::BoundsAt& bounds)
        : bounds_(bounds) {}

    double vertex(std::size_t axis, int index, int depth) const {
        const int k = int(axis);
        const double part = double(index) / (1 << depth);
        return bounds_.min[k] + part * (bounds_.max[k] - bounds_.min[k]);
    }

    SpaceBox box(const Cell& cell) const {
        SpaceBox box;
        for (std::size_t i = 0; i < 3; ++i) {
            box[i] = {vertex(i, cell.at[i], cell.depth), vertex(i, cell.at[i] + 1, cell.depth)};
        }
        return box;
    }

    // Whether a box is outside of the bounds, if they are a sphere.
    bool is_outside(const SpaceBox& box) const {
        return is_sphere() && squared_distance(box).lo > squared_radius().hi;
    }
    bool is_inside(const SpaceBox& box) const {
        return !is_sphere() || squared_distance(box).hi <= squared_radius().lo;
    }

private:
    bool is_sphere() const { return bounds_.shape == scene::Bounds::Shape::sphere; }
    Interval squared_radius() const { return formula::square(bounds_.radius); }
    Interval squared_distance(const SpaceBox& box) const {
        Interval sum = 0;
        for (int i = 0; i < 3; ++i)
            sum = sum + formula::square(box[std::size_t(i)] - Interval(bounds_.centre[i]));
        return sum;
    }

    const scene::BoundsAt bounds_;
};

SpaceBox with_rim(const SpaceBox& box) {
    SpaceBox wide;
    for (std::size_t i = 0; i < 3; ++i) {
        const double more = rim * (box[i].hi - box[i].lo);
        // A step further at least: far from the origin a rim may be less than the rounding.
        wide[i] = {std::nextafter(box[i].lo - more, -formula::infinity),
                   std::nextafter(box[i].hi + more, formula::infinity)};
    }
    return wide;
}

// Whether <g, h> > 0 for all g and h of two boxes of gradients, also without the components across
// any of the walls that the cell touches.
bool agree(const Cell& cell, const std::array<Interval, 3>& g, const std::array<Interval, 3>& h) {
    Interval product = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const Interval term = g[i] * h[i];
        product = product + (cell.touches_wall(i) ? hull(term, 0.0) : term);
    }
    return product.lo > 0;
}

class Octree {
public:
    // `one` is the field for one member of the bindings.
    Octree(FrameField& field, FrameField& one, const Places& places, const FrameLimits& limits)
        : field_(field)
        , one_(one)
        , all_of_one_(one.everything())
        , places_(places)
        , limits_(limits) {}

    CertifiedFrame certify();

private:
    using Shared = std::shared_ptr<const Elements>;
    struct Near {
        Shared kept;  // those that change in a cell
        Shared close; // the others of these by Taylor's formula
    };
    struct Crossed { // a leaf with agreeing gradients
        Cell cell;
        std::array<Interval, 3> gradient;
        Shared close;
    };
    struct Failure {
        const char* why;
        Cell cell;
    };

    // Cells of one depth, all of them with the same elements.
    void divide(std::span<const Cell> cells, const Near& near);
    Near nearer(const Near& near, const SpaceBox& box) const {
        const auto kept = std::make_shared<const Elements>(field_.nearer(*near.kept, box));
        return {kept, std::make_shared<const Elements>(field_.expanded(*kept, box))};
    }
    // Settles the cell, or says that it must be divided.
    bool settle(const Cell& cell, const SpaceBox& box, const ValueAndGradient& g, const Near& near);
    bool is_interrupted(const Cell& cell);
    bool may_go_on(const Cell& cell);
    // Numbers of the first and the last of the grid's vertices in a cell.
    std::array<int, 2> vertices(const Cell& cell, std::size_t axis) const;
    double coordinate(std::size_t axis, int number) const {
        return places_.vertex(axis, planes_[axis].place_of(number), Planes::deepest);
    }
    // The least distance of vertices next to each other in a cell.
    double least_step(const Cell& cell, std::size_t axis) const;
    void fill(const Cell& cell, SignGrid& grid) const;
    LeafColumns columns_of(const Crossed& leaf) const;
    // The columns of the first leaves, as many as have elements in common.
    std::vector<LeafColumns> asked_together(std::span<const Crossed> leaves) const;
    // Until all columns are known.
    void ask(std::span<LeafColumns> leaves, const Elements& near);
    // Draws the signs of the grid's vertices in the first crossed leaves, and says in how many. It
    // fails where a sign is lost in rounding that matters.
    std::size_t draw(std::span<const Crossed> leaves, SignGrid& grid);

    FrameField& field_;
    FrameField& one_;
    const Elements all_of_one_;
    const Places places_;
    FrameLimits limits_;
    int boxes_ = 0;
    int depth_ = 0;
    std::array<Planes, 3> planes_;
    std::vector<Cell> solid_; // leaves inside the solid
    std::vector<Crossed> crossed_;
    std::optional<Failure> failure_;
};

CertifiedFrame Octree::certify() {
    const auto everything = std::make_shared<const Elements>(field_.everything());
    divide(std::array{Cell{}}, {everything, everything});
    CertifiedFrame frame;
    frame.depth = depth_;
    frame.boxes = boxes_;
    // The grid is as long as the longest of its sides: beyond the others there is no solid.
    int side = 0;
    for (Planes& planes : planes_) {
        planes.number();
        side = std::max(side, planes.count());
    }
    if (!failure_ && side > most_vertices) failure_ = Failure{too_many_boxes, Cell{}};
    if (!failure_) {
        SignGrid grid(side);
        for (const Cell& cell : solid_) fill(cell, grid);
        for (std::span<const Crossed> left = crossed_;
             !left.empty() && !is_interrupted(left[0].cell);)
            left = left.subspan(draw(left, grid));
        if (!failure_) frame.betti = betti(grid);
    }
    if (failure_) {
        frame.why = failure_->why;
        frame.where = places_.box(failure_->cell);
    }
    return frame;
}

bool Octree::is_interrupted(const Cell& cell) {
    if (!failure_ && limits_.stopped && limits_.stopped()) failure_ = Failure{interrupted, cell};
    return failure_.has_value();
}

bool Octree::may_go_on(const Cell& cell) {
    if (is_interrupted(cell)) return false;
    if (!failure_ && cell.depth >= limits_.depth) failure_ = Failure{not_settled, cell};
    if (!failure_ && boxes_ >= limits_.boxes) failure_ = Failure{too_many_boxes, cell};
    return !failure_;
}

void Octree::divide(std::span<const Cell> cells, const Near& near) {
    std::vector<Cell> parts;
    std::vector<SpaceBox> boxes, evaluated;
    for (const Cell& cell : cells) {
        if (!may_go_on(cell)) return;
        for (std::size_t i = 0; i < 3; ++i)
            planes_[i].add(Planes::place(2 * cell.at[i] + 1, cell.depth + 1));
        for (std::size_t k = 0; k < 8; ++k) {
            Cell& part = parts.emplace_back();
            part.depth = cell.depth + 1;
            for (std::size_t i = 0; i < 3; ++i) part.at[i] = 2 * cell.at[i] + int(k >> i & 1);
            boxes.push_back(places_.box(part));
            evaluated.push_back(with_rim(boxes.back()));
        }
        boxes_ += 8;
    }
    std::vector<ValueAndGradient> g(parts.size());
    field_.over(*near.close, evaluated, g);
    depth_ = std::max(depth_, parts[0].depth);
    std::size_t open = 0; // these are moved to the front
    const auto settle_first = [&](std::size_t count) {
        open = 0;
        for (std::size_t k = 0; k < count && !failure_; ++k) {
            if (settle(parts[k], boxes[k], g[k], near)) continue;
            parts[open] = parts[k];
            boxes[open] = boxes[k];
            evaluated[open] = evaluated[k];
            g[open++] = g[k];
        }
    };
    settle_first(parts.size());
    if (open == 0) return;
    field_.tighten(*near.close, std::span(evaluated).first(open), std::span(g).first(open));
    settle_first(open);
    const auto undecided = std::span<const Cell>(parts).first(open);
    if (failure_ || open == 0) return;
    if (parts[0].depth % choice_of_elements != 0) return divide(undecided, near);
    for (std::size_t k = 0; k < open && !failure_; ++k)
        divide(undecided.subspan(k, 1), nearer(near, evaluated[k]));
}

bool Octree::settle(const Cell& cell, const SpaceBox& box, const ValueAndGradient& g,
                    const Near& near) {
    if (g.value.lo > 0 || places_.is_outside(box)) return true;
    if (!places_.is_inside(box)) {
        if (g.value.hi < 0) failure_ = Failure{reaches_bounds, cell};
        return false;
    }
    if (g.value.hi < 0) {
        solid_.push_back(cell);
        return true;
    }
    if (!agree(cell, g.gradient, g.gradient)) return false;
    crossed_.push_back({cell, g.gradient, near.close});
    return true;
}

std::array<int, 2> Octree::vertices(const Cell& cell, std::size_t axis) const {
    const auto number = [&](int index) {
        return planes_[axis].number_of(Planes::place(index, cell.depth));
    };
    return {number(cell.at[axis]), number(cell.at[axis] + 1)};
}

double Octree::least_step(const Cell& cell, std::size_t axis) const {
    const auto [first, last] = vertices(cell, axis);
    double least = formula::infinity;
    for (int k = first; k < last; ++k)
        least = std::min(least, coordinate(axis, k + 1) - coordinate(axis, k));
    return least;
}

void Octree::fill(const Cell& cell, SignGrid& grid) const {
    const auto x = vertices(cell, 0), y = vertices(cell, 1), z = vertices(cell, 2);
    for (int k = z[0]; k <= z[1]; ++k) {
        for (int j = y[0]; j <= y[1]; ++j) grid.set_run(x[0], x[1], j, k);
    }
}

LeafColumns Octree::columns_of(const Crossed& leaf) const {
    // Some component of agreeing gradients keeps its sign.
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i) {
        if (mignitude(leaf.gradient[i]) > mignitude(leaf.gradient[axis])) axis = i;
    }
    assert(mignitude(leaf.gradient[axis]) > 0);
    return {{vertices(leaf.cell, 0), vertices(leaf.cell, 1), vertices(leaf.cell, 2)},
            axis,
            leaf.gradient[axis].lo > 0};
}

std::vector<LeafColumns> Octree::asked_together(std::span<const Crossed> leaves) const {
    std::vector<LeafColumns> columns;
    std::size_t count = 0;
    for (const Crossed& leaf : leaves) {
        if (leaf.close != leaves[0].close || count >= columns_together) break;
        count += columns.emplace_back(columns_of(leaf)).count();
    }
    return columns;
}

void Octree::ask(std::span<LeafColumns> leaves, const Elements& near) {
    struct Asked {
        LeafColumns* leaf;
        LeafColumns::At column;
    };
    std::vector<Asked> open;
    std::vector<SpaceBox> points;
    std::vector<std::size_t> blurred;
    std::vector<Interval> values, sharp;
    int stride = 1;
    for (const LeafColumns& leaf : leaves) stride = std::max(stride, leaf.coarsest());
    for (; stride > 0; stride /= 2) {
        for (LeafColumns& leaf : leaves) {
            if (stride > leaf.coarsest()) continue;
            leaf.begin(stride, [&](const LeafColumns::At& at) { open.push_back({&leaf, at}); });
        }
        while (!open.empty()) {
            points.clear();
            for (const Asked& one : open) {
                const LeafColumns::Vertex at = one.leaf->asked(one.column);
                SpaceBox& point = points.emplace_back();
                for (std::size_t k = 0; k < 3; ++k) point[k] = coordinate(k, at[k]);
            }
            values.resize(open.size());
            one_.values(near, points, values);
            // What is left out of sums blurs signs.
            blurred.clear();
            for (std::size_t k = 0; k < open.size(); ++k) {
                if (!contains(values[k], 0.0)) continue;
                points[blurred.size()] = points[k];
                blurred.push_back(k);
            }
            if (!blurred.empty()) {
                sharp.resize(blurred.size());
                one_.values(all_of_one_, std::span(points).first(blurred.size()), sharp);
            }
            for (std::size_t k = 0; k < blurred.size(); ++k) values[blurred[k]] = sharp[k];
            std::size_t left = 0;
            for (std::size_t k = 0; k < open.size(); ++k) {
                const Asked one = open[k];
                if (!one.leaf->learn(one.column, values[k])) open[left++] = one;
            }
            open.resize(left);
        }
    }
}

std::size_t Octree::draw(std::span<const Crossed> leaves, SignGrid& grid) {
    std::vector<LeafColumns> columns = asked_together(leaves);
    ask(columns, one_of(*leaves[0].close));
    for (std::size_t k = 0; k < columns.size(); ++k) {
        const Crossed& leaf = leaves[k];
        columns[k].draw(grid);
        const double lost = columns[k].lost();
        if (lost == 0) continue;
        std::array<Interval, 3> gradient = leaf.gradient;
        for (std::size_t i = 0; i < 3; ++i) {
            const Interval change = Interval(-lost, lost) / Interval(least_step(leaf.cell, i) / 2);
            gradient[i] = gradient[i] + change;
        }
        if (!agree(leaf.cell, leaf.gradient, gradient) && !failure_)
            failure_ = Failure{"a sign is lost in rounding", leaf.cell};
    }
    return columns.size();
}

// Whether the solid is known to hold some point of a sphere: one of a few on it.
bool reaches(const SpaceFormula& formula, const BallAsCube& ball) {
    constexpr int halvings = 3;
    const Places places(BallAsCube::cube());
    std::vector<SpaceBox> points;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const double wall : {-1.0, 1.0}) {
            for (int i = 0; i <= 1 << halvings; ++i) {
                for (int j = 0; j <= 1 << halvings; ++j) {
                    SpaceBox& point = points.emplace_back();
                    point[axis] = wall;
                    point[(axis + 1) % 3] = places.vertex((axis + 1) % 3, i, halvings);
                    point[(axis + 2) % 3] = places.vertex((axis + 2) % 3, j, halvings);
                }
            }
        }
    }
    FrameField field(formula, ball);
    std::vector<Interval> values(points.size());
    field.values(field.everything(), points, values);
    return std::ranges::any_of(values, [](const Interval& value) { return value.hi < 0; });
}

} // namespace

CertifiedFrame certify_frame(const SpaceFormula& formula, const scene::BoundsAt& bounds,
                             const FrameLimits& limits) {
    if (CertifiedFrame frame = certify_separable(formula, bounds); frame.betti) return frame;
    const SpaceFormula of_one{formula.graph, formula.root, one_of(formula.bindings), formula.solid};
    FrameLimits within = limits;
    within.depth = std::min(limits.depth, Planes::deepest);
    const auto in_box = [&](const scene::BoundsAt& box, std::optional<BallAsCube> ball) {
        FrameField one(of_one, ball), all(formula, ball);
        return Octree(all, one, Places(box), within).certify();
    };
    const auto in_ball = [&] {
        const BallAsCube ball(bounds);
        CertifiedFrame frame = in_box(BallAsCube::cube(), ball);
        if (!frame.betti) frame.where = ball.place(frame.where);
        return frame;
    };
    const bool is_ball = bounds.shape == scene::Bounds::Shape::sphere;
    bool reaches_sphere = is_ball && reaches(of_one, BallAsCube(bounds));
    CertifiedFrame frame = reaches_sphere ? in_ball() : in_box(bounds, std::nullopt);
    if (is_ball && frame.why == reaches_bounds) {
        reaches_sphere = true;
        frame = in_ball();
    }
    if (frame.betti || frame.why == interrupted) return frame;
    const CertifiedFrame by_cells = certify_by_cells(formula, bounds, limits);
    // What stops the first proof at a sphere may be the cube's edges.
    return by_cells.betti || reaches_sphere ? by_cells : frame;
}

} // namespace isomotion::topology
