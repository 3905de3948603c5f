// Enclosures of F, its gradient, its second derivatives and its derivative by time, over boxes,
// hold what Arb says in 128 bits at points of the boxes: the programs that events and frames are
// proved by, on random formulas that move and on animations of the repository.
#include <cstdlib>

#include "arb/ball_program.h"
#include "formula/graph/derivative.h"
#include "topology/field/motion.h"
#include "topology/field/moving_field.h"
#include "topology/field/timed_formula.h"
#include "topology/moving.h"
#include "unit/formula/random_formula.h"

namespace isomotion::topology {
namespace {

using ball::Ball;
using formula::Interval;
using formula::NodeId;
using formula::Slopes;

constexpr std::uint64_t seed = 20'261'122;
constexpr long precision = 128;
constexpr int random_scenes = 120;
// Containments, over all scenes.
constexpr std::int64_t wanted = 1'000'000;

// Derivatives at a point: x, y, z and time are inputs 0 to 3.
class Truth {
public:
    explicit Truth(const Motion& motion)
        : bindings_(motion.bindings) {
        formula::Graph g = motion.graph;
        const auto slope = [&](NodeId of, std::size_t by, Slopes slopes) {
            std::vector<NodeId> direction(4, g.constant(0));
            direction[by] = g.constant(1);
            return formula::differentiate_inputs(g, of, direction, slopes);
        };
        std::vector<NodeId> outputs{motion.field};
        for (std::size_t k = 0; k < 4; ++k)
            outputs.push_back(slope(motion.field, k, Slopes::pointwise));
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 4; ++j)
                outputs.push_back(slope(outputs[1 + i], j, Slopes::pointwise_again));
        }
        program_ = formula::schedule(g, outputs);
    }

    Jet<Ball> at(const Point& p) const {
        const std::array<Ball, 4> inputs{Ball(p[0]), Ball(p[1]), Ball(p[2]), Ball(p[3])};
        std::array<Ball, 17> outputs;
        ball::BallProgram(program_).evaluate(bindings_, inputs, outputs, precision);
        Jet<Ball> jet;
        jet.value = outputs[0];
        for (std::size_t k = 0; k < 4; ++k) jet.gradient[k] = outputs[1 + k];
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 4; ++j) jet.hessian[i][j] = outputs[5 + 4 * i + j];
        }
        return jet;
    }

private:
    formula::Bindings<double> bindings_;
    formula::Program program_;
};

struct Counts {
    std::int64_t contained = 0, bounded = 0; // bounded: the enclosure says something
    std::int64_t open = 0, apart = 0;        // open: the ball has no bounds, or is about an end
    std::int64_t beyond_half = 0; // not in the enclosure's lower half: half as wide would be wrong

    Counts& operator+=(const Counts& other) {
        contained += other.contained;
        bounded += other.bounded;
        open += other.open;
        apart += other.apart;
        beyond_half += other.beyond_half;
        return *this;
    }

    void hold(const Interval& enclosure, const Ball& truth) {
        if (!truth.is_finite()) {
            ++open;
        } else if (truth.is_in(enclosure.lo, enclosure.hi)) {
            ++contained;
            bounded += !std::isinf(magnitude(enclosure));
            beyond_half += truth.is_apart_from(enclosure.lo, mid(enclosure));
        } else if (truth.is_apart_from(enclosure.lo, enclosure.hi)) {
            ++apart;
        } else {
            ++open;
        }
    }
};

class Boxes {
public:
    Boxes(const Motion& motion, formula::Random& random)
        : random_(random)
        , truth_(motion)
        , moving_(motion, {})
        , enclosures_(moving_)
        , timed_(motion)
        , frame_(timed_.formula()) {}

    // Checks `count` boxes, each with a point.
    void check(int count, Counts& counts) {
        while (count > 0) {
            const int of_family = std::min(count, 37);
            family(of_family, counts);
            count -= of_family;
        }
    }

private:
    void family(int count, Counts& counts) {
        const double size = std::pow(2, random_.in(-30, 0));
        Box around{};
        for (std::size_t i = 0; i < 4; ++i) {
            const Interval whole = moving_.domain()[i];
            const double length = (whole.hi - whole.lo) * size;
            const double low = random_.in(whole.lo, whole.hi - length);
            around[i] = {low, low + length};
        }
        std::vector<Box> boxes;
        std::vector<SpaceBox> places;
        std::vector<Point> points;
        for (int b = 0; b < count; ++b) {
            Box box{};
            Point point{};
            for (std::size_t i = 0; i < 4; ++i) {
                const double p = random_.in(around[i].lo, around[i].hi);
                const double q = random_.below(8) == 0 ? p : random_.in(around[i].lo, around[i].hi);
                box[i] = {std::min(p, q), std::max(p, q)};
                const double part = random_.below(5) / 4.0; // ends, often
                point[i] =
                    std::clamp(box[i].lo + (box[i].hi - box[i].lo) * part, box[i].lo, box[i].hi);
            }
            boxes.push_back(box);
            places.push_back({box[0], box[1], box[2]});
            points.push_back(point);
        }
        const Elements near = enclosures_.near(around, enclosures_.all(), random_.in(0, 1e-3));
        enclosures_.values(near, boxes, values_);
        enclosures_.gradients(near, boxes, slopes_);
        enclosures_.jets(near, boxes, jets_);

        frame_.bind(timed_.bindings(around[3]));
        const SpaceBox place{around[0], around[1], around[2]};
        const Elements all = frame_.everything();
        std::vector<ValueAndGradient> whole(1);
        frame_.over(all, {&place, 1}, whole);
        frame_.tighten(all, {&place, 1}, whole);
        const Elements nearer = frame_.nearer(all, place);
        std::vector<ValueAndGradient> over(boxes.size());
        std::vector<Interval> values(boxes.size());
        frame_.values(nearer, places, values);
        frame_.over(nearer, places, over);
        std::vector<ValueAndGradient> tight = over;
        frame_.tighten(nearer, places, tight);

        for (std::size_t b = 0; b < boxes.size(); ++b) {
            const Jet<Ball> truth = truth_.at(points[b]);
            for (const Interval& value : {values_[b], slopes_[b].value, jets_[b].value, values[b],
                                          over[b].value, tight[b].value}) {
                counts.hold(value, truth.value);
            }
            const SpaceHessian hessian = frame_.hessian(nearer, places[b]);
            for (std::size_t i = 0; i < 4; ++i) {
                counts.hold(slopes_[b].gradient[i], truth.gradient[i]);
                counts.hold(jets_[b].gradient[i], truth.gradient[i]);
                for (std::size_t j = 0; j < 3; ++j)
                    counts.hold(jets_[b].hessian[j][i], truth.hessian[j][i]);
            }
            for (std::size_t i = 0; i < 3; ++i) {
                counts.hold(over[b].gradient[i], truth.gradient[i]);
                counts.hold(tight[b].gradient[i], truth.gradient[i]);
                for (std::size_t j = i; j < 3; ++j) counts.hold(hessian[i][j], truth.hessian[i][j]);
            }
        }
    }

    formula::Random& random_;
    Truth truth_;
    MovingField moving_;
    Enclosures enclosures_;
    TimedFormula timed_;
    FrameField frame_;
    std::vector<Interval> values_;
    std::vector<Jet<Interval>> slopes_, jets_;
};

Moving random_scene(std::uint64_t number) {
    formula::Random random(number);
    const auto move = [&](std::vector<std::string> ways) {
        return ways[std::size_t(random.below(int(ways.size())))];
    };
    const auto parameter = [&] {
        return move({"'0.7 + t'", "'sin(3*t) + 0.2'", "'1.5*exp(-t)'", "'tanh(2*t) - 0.6'",
                     "{ keys = [[0, -1], [0.4, 0.5], [1, 2]], ease = 'cubic' }",
                     "{ keys = [[0, 1], [0.6, -0.3], [1, 1]], ease = 'smooth' }"});
    };
    const auto field = [&] {
        return move({"'cos(2*i + t)'", "'random(i, 1)*t - 0.3'", "'(2*random(i, 0) - 1)*(1.2 - t)'",
                     "'0.3*i - 0.5'", "'tanh(i*t)'"});
    };
    const bool is_ball = random.below(2) == 0;
    // What is added takes all names that there are, as a scene must.
    return {fmt::format("{} + 0.1*a*cos(b*z) + 0.1*sum(blobs, cx*sin(cy*x)) + "
                        "0.1*sum(links, exp(px*y) + py)",
                        formula::FormulaGenerator(number).make(4).text),
            is_ball ? "{ sphere = 1.5 }" : "{ box = [[-1, -1, -1.5], [1, 1.5, 1]] }",
            fmt::format("a = {}\nb = {}", parameter(), parameter()),
            fmt::format("[arrays.blobs]\ncount = 4\ncx = {}\ncy = {}\n"
                        "[arrays.links]\ncount = 2\npx = {}\npy = {}",
                        field(), field(), field(), field())};
}

// Checks so many boxes of each piece that no more than its share of the containments is missing.
Counts check(const std::vector<Motion>& pieces, std::int64_t containments,
             formula::Random& random) {
    constexpr int a_box = 38;
    Counts counts;
    const auto each = int(containments / a_box / std::int64_t(pieces.size())) + 1;
    for (const Motion& piece : pieces) Boxes(piece, random).check(each, counts);
    return counts;
}

void expect_no_violation(const Counts& counts, std::int64_t containments) {
    EXPECT_EQ(counts.apart, 0);
    EXPECT_LE(counts.open, containments / 100);
    EXPECT_GT(counts.beyond_half, containments / 4);
    EXPECT_GE(counts.contained + counts.open, containments);
    fmt::print("{} contained, {} of them in bounds, {} not in the lower half; {} open\n",
               counts.contained, counts.bounded, counts.beyond_half, counts.open);
}

TEST(Balls, RandomFormulasAreEnclosed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    formula::Random random(seed);
    Counts all;
    int moving = 0;
    for (int k = 0; k < random_scenes; ++k) {
        const Moving scene = random_scene(seed + std::uint64_t(k));
        SCOPED_TRACE(scene.formula);
        const Motions parts = motions(scene.scene(), Side::negative, {0.1, 0.9}, Clock::time);
        moving += parts.pieces[0].moves;
        const Counts counts = check(parts.pieces, wanted / 2 / random_scenes, random);
        EXPECT_EQ(counts.apart, 0);
        all += counts;
    }
    expect_no_violation(all, wanted / 2);
    EXPECT_GT(moving, random_scenes / 2);
    EXPECT_GT(all.bounded, wanted / 4); // and most enclosures have bounds
}

TEST(Balls, AnimationsAreEnclosed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    setenv("ISOMOTION_DATA", ISOMOTION_SOURCE_DIR, /*overwrite=*/1);
    formula::Random random(seed);
    const std::vector<std::string> names{"blobby75",
                                         "tangle",
                                         "torus",
                                         "ding_dong",
                                         "goursat",
                                         "cassini",
                                         "chmutov_12",
                                         "dervish",
                                         "twisting_superquadric",
                                         "wyvill_soft_objects",
                                         "heart",
                                         "klein_bottle"};
    Counts all;
    for (const std::string& name : names) {
        SCOPED_TRACE(name);
        const scene::Scene scene =
            scene::load(fmt::format("{}/animations/{}.toml", ISOMOTION_SOURCE_DIR, name));
        const Interval range{scene.timeline.time(1), scene.timeline.time(scene.timeline.frames)};
        const Motions parts = motions(scene, solid_side(scene), range, Clock::time);
        const auto share = wanted / 2 / std::int64_t(names.size());
        const Counts counts = check(parts.pieces, share, random);
        EXPECT_EQ(counts.apart, 0);
        all += counts;
    }
    expect_no_violation(all, wanted / 2);
    EXPECT_GT(all.bounded, wanted / 4);
}

} // namespace
} // namespace isomotion::topology
