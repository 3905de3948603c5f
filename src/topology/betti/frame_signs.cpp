#include "topology/betti/frame_signs.h"

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <thread>

#include "base/workers.h"
#include "formula/enclosure.h"
#include "formula/evaluate/evaluate.h"
#include "scene/near_elements.h"
#include "topology/field/ball_as_cube.h"
#include "topology/field/space_point.h"

namespace isomotion::topology {

struct SignEvaluators {
    formula::Evaluator<double> numbers;
    formula::Evaluator<formula::Interval> enclosure;
};

namespace {

constexpr int whole = 8, part = 4; // vertices along the edge of a block, and of its eight parts

// How many times as dear an element is that is looked up as one in its place; and a block's lists
// as one list.
constexpr int looked_up = 4, lists_of_box = 16;

// What one evaluation takes, in operations on numbers.
struct Price {
    double of_point, of_box;
};

Price price(const formula::Field& field, std::span<const int> counts) {
    // Times as dear as a sum or product of numbers. The registers of long programs fit no cache.
    constexpr double function = 20, turn = 3, interval = 3, long_one = 3;
    constexpr std::size_t is_long = 1000;
    const formula::Cost cost = formula::cost(field.value, counts);
    double point = 1 + cost.operations + function * cost.functions + turn * cost.iterations;
    if (field.value.instructions.size() > is_long) point *= long_one;
    return {point, interval * point};
}

// What all threads share.
struct FrameValues {
    const formula::Field& field;
    const formula::Bindings<double>& numbers;
    const formula::Bindings<formula::Interval> intervals;
    const elements::FieldByPlace::Frame* by_place; // null where all elements are near
    Price all;                                     // of all elements
    Price near;                                    // of those that are found by place

    FrameValues(const formula::Field& of, const formula::Bindings<double>& bindings,
                const elements::FieldByPlace::Frame* place)
        : field(of)
        , numbers(bindings)
        , intervals(formula::convert<formula::Interval>(bindings))
        , by_place(place)
        , all(price(of, bindings.counts()))
        , near(all) {
        if (!by_place) return;
        std::vector<int> counts = bindings.counts();
        counts[std::size_t(by_place->grid().array)] = by_place->grid().usual_count();
        near = price(field, counts);
        near.of_point = looked_up * near.of_box;
        near.of_box *= lists_of_box;
    }
};

int threads_of(int asked) {
    return asked > 0 ? asked : std::max(1, int(std::thread::hardware_concurrency()));
}

// Vertices `first` to `last` of each axis.
struct Block {
    std::array<int, 3> first, last;
};

// Where the grid's vertices are along each axis.
std::array<std::vector<double>, 3> places_of(const scene::BoundsAt& bounds, int side) {
    std::array<std::vector<double>, 3> at;
    for (std::size_t i = 0; i < 3; ++i) {
        const double low = bounds.min[int(i)], high = bounds.max[int(i)];
        for (int k = 0; k < side; ++k) at[i].push_back(low + double(k) / (side - 1) * (high - low));
    }
    return at;
}

// The grid fills the bounds. A ball is taken for a cube, since the steps of a grid along a sphere
// would be tunnels and components of a solid that reaches it.
class Vertices {
public:
    Vertices(const scene::BoundsAt& bounds, int side)
        : at_(places_of(bounds, side)) {
        if (bounds.shape != scene::Bounds::Shape::sphere) return;
        ball_.emplace(bounds);
        at_ = places_of(BallAsCube::cube(), side);
    }

    // Holds the part of space between two vertices.
    SpaceBox box(const std::array<int, 3>& first, const std::array<int, 3>& last) const {
        SpaceBox box;
        for (std::size_t i = 0; i < 3; ++i)
            box[i] = {at_[i][std::size_t(first[i])], at_[i][std::size_t(last[i])]};
        return ball_ ? ball_->place(box) : box;
    }
    // Holds a vertex; in a ball its place is rounded.
    SpaceBox box(const std::array<int, 3>& vertex) const { return box(vertex, vertex); }

private:
    std::array<std::vector<double>, 3> at_;
    std::optional<BallAsCube> ball_;
};

// One thread's work: a layer of blocks, `whole` vertices high. For most blocks an enclosure tells
// the sign at all of their vertices; in the others these are evaluated.
class BlockSigns {
public:
    BlockSigns(SignEvaluators& evaluators, const FrameValues& frame, const scene::BoundsAt& bounds,
               Side solid, SignGrid& grid, Work& work)
        : evaluators_(evaluators)
        , frame_(frame)
        , solid_(solid)
        , grid_(grid)
        , work_(work)
        , vertices_(bounds, grid.side()) {
        if (frame.by_place) boxes_.emplace(frame.by_place->programs().value, *frame.by_place);
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
        if (boxes_) vertices = undecided_near(vertices);
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
                    act(std::array{x, y, z});
                }
            }
        }
    }

    // The blocks with vertices on both sides, as far as is known.
    std::vector<Block> undecided(std::span<const Block> blocks) {
        work_.add(double(blocks.size()) * frame_.near.of_box);
        if (work_.is_over()) return {};
        std::vector<SpaceBox> boxes;
        for (const Block& one : blocks) boxes.push_back(vertices_.box(one.first, one.last));
        const std::vector<formula::Interval> f = enclosures(boxes);
        std::vector<Block> open;
        for (std::size_t k = 0; k < blocks.size(); ++k) {
            if (!(f[k].lo > 0 || f[k].hi < 0)) {
                open.push_back(blocks[k]);
            } else if (is_solid(f[k].lo)) {
                each_inside(blocks[k], [&](const auto& v) { grid_.set(v[0], v[1], v[2]); });
            }
        }
        return open;
    }

    // The vertices whose sign the elements near them do not tell.
    std::vector<std::array<int, 3>> undecided_near(std::span<const std::array<int, 3>> vertices) {
        work_.add(double(vertices.size()) * frame_.near.of_point);
        if (work_.is_over()) return {};
        std::vector<SpaceBox> places;
        for (const auto& v : vertices) places.push_back(vertices_.box(v));
        const std::vector<formula::Interval> f = enclosures(places);
        std::vector<std::array<int, 3>> open;
        for (std::size_t k = 0; k < vertices.size(); ++k) {
            const auto& v = vertices[k];
            if (!(f[k].lo > 0 || f[k].hi < 0)) {
                open.push_back(v);
            } else if (is_solid(f[k].lo)) {
                grid_.set(v[0], v[1], v[2]);
            }
        }
        return open;
    }

    std::vector<formula::Interval> enclosures(std::span<const SpaceBox> boxes) {
        std::array<std::vector<formula::Interval>, 3> sides;
        for (const SpaceBox& box : boxes) {
            for (std::size_t i = 0; i < 3; ++i) sides[i].push_back(box[i]);
        }
        std::vector<formula::Interval> f(boxes.size());
        const std::array<std::span<const formula::Interval>, 3> inputs{sides[0], sides[1],
                                                                       sides[2]};
        const std::array<std::span<formula::Interval>, 1> outputs{f};
        if (boxes_)
            boxes_->points(inputs, outputs);
        else
            evaluators_.enclosure.points(frame_.intervals, inputs, outputs);
        return f;
    }

    bool is_solid(double f) const { return solid_ == Side::negative ? f < 0 : f > 0; }

    void evaluate(std::span<const std::array<int, 3>> vertices) {
        std::array<std::vector<double>, 3> points;
        for (const auto& v : vertices) {
            const SpacePoint p = middle(vertices_.box(v));
            for (std::size_t i = 0; i < 3; ++i) points[i].push_back(p[i]);
        }
        work_.add(double(vertices.size()) * frame_.all.of_point);
        if (work_.is_over()) return;
        std::vector<double> f(vertices.size());
        const std::array<std::span<const double>, 3> inputs{points[0], points[1], points[2]};
        const std::array<std::span<double>, 1> outputs{f};
        evaluators_.numbers.points(frame_.numbers, inputs, outputs);
        for (std::size_t k = 0; k < vertices.size(); ++k) {
            if (is_solid(f[k])) grid_.set(vertices[k][0], vertices[k][1], vertices[k][2]);
        }
    }

    SignEvaluators& evaluators_;
    const FrameValues& frame_;
    Side solid_;
    SignGrid& grid_;
    Work& work_;
    const Vertices vertices_;
    std::optional<elements::BoxesByPlace> boxes_;
};

} // namespace

FrameSigns::FrameSigns(const formula::Field& field, std::span<const int> elements_of_arrays)
    : field_(field)
    , enclosure_(formula::value_enclosure(field))
    , by_place_(elements::FieldByPlace::of(field, elements_of_arrays)) {}

FrameSigns::~FrameSigns() = default;

void FrameSigns::GiveBack::operator()(SignEvaluators* evaluators) const {
    std::unique_ptr<SignEvaluators> own(evaluators);
    const std::lock_guard lock(to->mutex_);
    to->idle_.push_back(std::move(own));
}

std::unique_ptr<SignEvaluators, FrameSigns::GiveBack> FrameSigns::borrow() const {
    {
        const std::lock_guard lock(mutex_);
        if (!idle_.empty()) {
            SignEvaluators* last = idle_.back().release();
            idle_.pop_back();
            return {last, GiveBack{this}};
        }
    }
    return {new SignEvaluators{formula::Evaluator<double>(field_.value),
                               formula::Evaluator<formula::Interval>(enclosure_)},
            GiveBack{this}};
}

std::optional<SignGrid> FrameSigns::at(const formula::Bindings<double>& bindings,
                                       const scene::BoundsAt& bounds, Side solid, int side,
                                       int threads, Work& work) const {
    return make(bindings, nullptr, bounds, solid, side, threads, work);
}

std::optional<SignGrid> FrameSigns::at(const scene::SurfaceAt& now, Side solid, int side,
                                       int threads, Work& work) const {
    const auto all = formula::convert<double>(now.bindings);
    if (!by_place_) return at(all, now.bounds, solid, side, threads, work);
    constexpr double of_element = 2000; // to find where it is
    const auto array = std::size_t(by_place_->array());
    work.add(of_element * now.bindings.arrays[array].count);
    const elements::FieldByPlace::Frame frame =
        by_place_->at(now.bindings, scene::region_of_elements(now.bounds), threads_of(threads));
    constexpr int list_to_pay = 16; // times a list are all elements
    const bool pays = list_to_pay * frame.grid().usual_count() <= frame.elements();
    return make(all, pays ? &frame : nullptr, now.bounds, solid, side, threads, work);
}

std::optional<SignGrid> FrameSigns::make(const formula::Bindings<double>& bindings,
                                         const elements::FieldByPlace::Frame* by_place,
                                         const scene::BoundsAt& bounds, Side solid, int side,
                                         int threads, Work& work) const {
    // Every frame goes over all registers, which are of many points at once.
    constexpr double of_register = 500;
    work.add(of_register *
             double(field_.value.instructions.size() + 2 * enclosure_.instructions.size()));
    SignGrid grid(side);
    const FrameValues frame(field_, bindings, by_place);
    const auto layers = [&] {
        auto evaluators = borrow();
        auto blocks = std::make_unique<BlockSigns>(*evaluators, frame, bounds, solid, grid, work);
        return [evaluators = std::move(evaluators), blocks = std::move(blocks)](std::size_t layer) {
            blocks->make(int(layer));
        };
    };
    base::SharedLoop loop{.count = std::size_t((side + whole - 1) / whole)};
    loop.threads = threads_of(threads);
    loop.stopped = [&] { return work.is_over(); };
    base::share(loop, layers);
    if (work.is_over()) return std::nullopt;
    return grid;
}

SignGrid frame_signs(const formula::Field& field, const formula::Bindings<double>& bindings,
                     const scene::BoundsAt& bounds, Side solid, int side, int threads) {
    Work unlimited;
    auto signs = FrameSigns(field).at(bindings, bounds, solid, side, threads, unlimited);
    if (!signs) throw std::logic_error("work without a limit is over");
    return *std::move(signs);
}

SignGrid frame_signs(const SpaceFormula& formula, const scene::BoundsAt& bounds, int side) {
    FrameField field(formula);
    const Vertices vertices(bounds, side);
    SignGrid grid(side);
    std::vector<SpaceBox> row(std::size_t(side), SpaceBox{});
    std::vector<formula::Interval> values(row.size());
    for (int z = 0; z < side; ++z) {
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) row[std::size_t(x)] = vertices.box({x, y, z});
            field.values(field.everything(), row, values);
            for (int x = 0; x < side; ++x) {
                if (values[std::size_t(x)].hi < 0) grid.set(x, y, z);
            }
        }
    }
    return grid;
}

} // namespace isomotion::topology
