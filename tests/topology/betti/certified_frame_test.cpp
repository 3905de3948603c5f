// Proved Betti numbers of frames: closed forms, the bounds, rounding, and what must not be proved.
#include "topology/betti/certified_frame.h"

#include <gtest/gtest.h>

#include "cut_solids.h"
#include "thorough.h"
#include "topology/betti/cell_frame.h"
#include "topology/betti/frame_signs.h"
#include "topology/scenes.h"
#include "topology/solids.h"
#include "unit/formula/testing.h"

namespace isomotion::topology {
namespace {

const std::string box = "{ box = [[-1, -1, -1], [1, 1, 1]] }";

CertifiedFrame certified(const scene::Scene& scene, double time = 0,
                         const FrameLimits& limits = {}) {
    const StillScene frame(scene, time);
    return certify_frame(frame.formula(solid_side(scene)), frame.bounds, limits);
}

std::string describe(const CertifiedFrame& frame) {
    return fmt::format("{} at ({}, {}, {}), depth {}", frame.why, frame.where[0].lo,
                       frame.where[1].lo, frame.where[2].lo, frame.depth);
}

struct Known {
    std::string formula, bounds;
    Betti betti;
};

void PrintTo(const Known& known, std::ostream* out) { *out << known.formula; }

class ClosedForms : public testing::TestWithParam<Known> {};

TEST_P(ClosedForms, AreProved) {
    const scene::Scene scene = still(GetParam().formula, GetParam().bounds);
    const CertifiedFrame frame = certified(scene);
    ASSERT_TRUE(frame.betti) << describe(frame);
    EXPECT_EQ(*frame.betti, GetParam().betti);
}

// Cassini's ovals turned about their axis: a neck of 8e-4 of the box, or a gap as narrow. A grid as
// fine everywhere would take 2^36 vertices.
TEST(CertifiedFrame, IsFineOnlyWhereItMustBe) {
    for (const double more : {1e-5, -1e-5}) {
        const std::string formula =
            fmt::format("((x-0.07)^2 + (y-0.03)^2 + (z+0.05)^2 + 0.25)^2 - (x-0.07)^2 - {}",
                        0.0625 * (1 + more) * (1 + more));
        const CertifiedFrame frame = certified(still(formula, box));
        ASSERT_TRUE(frame.betti) << describe(frame);
        EXPECT_EQ(*frame.betti, (Betti{more > 0 ? 1 : 2, 0, 0}));
        EXPECT_GT(frame.depth, 10);
        EXPECT_LT(frame.boxes, 20'000);
        EXPECT_FALSE(frame.is_by_cells);
        // Where ten halvings are all there are, cells prove it.
        const CertifiedFrame by_cells = certified(still(formula, box), 0, {.depth = 10});
        ASSERT_TRUE(by_cells.betti) << describe(by_cells);
        EXPECT_EQ(*by_cells.betti, *frame.betti);
        EXPECT_TRUE(by_cells.is_by_cells);
    }
}

// Where F jumps, second derivatives tell nothing of values on the other side.
TEST(CertifiedFrame, IsNotWrongOfFormulasThatJump) {
    for (const char* formula :
         {"sign((x-0.3)^2 + y^2 + z^2 - 0.01)", "floor(1 + 4*((x-0.3)^2 + y^2 + z^2 - 0.01)) - 0.5",
          "x^2 + y^2 + z^2 - 0.5 + 0.3*sign((x-0.3)^2 + (y-0.2)^2 + z^2 - 0.01)"}) {
        const CertifiedFrame frame = certified(still(formula, box));
        if (frame.betti) {
            EXPECT_EQ(*frame.betti, (Betti{1, 0, 0})) << formula;
        }
    }
}

const Known known[] = {
    {"x^2 + y^2 + z^2 - 1", "{ sphere = 1.5 }", {1, 0, 0}},
    // Vertices lie on the surface.
    {"x^2 + y^2 + z^2 - 1", "{ box = [[-2, -2, -2], [2, 2, 2]] }", {1, 0, 0}},
    {"1 - x^2 - y^2 - z^2", "{ sphere = 1.5 }", {1, 0, 0}},
    {"x^2 + y^2 + z^2 + 1", "{ sphere = 1.5 }", {0, 0, 0}},
    {"(0.7 - sqrt(x^2 + y^2))^2 + z^2 - 0.04", box, {1, 1, 0}},
    {"(x^2 + y^2 + z^2 + 0.45)^2 - 1.96*(x^2 + y^2)", "{ sphere = 1.2 }", {1, 1, 0}},
    {"(x^2 + y^2 + z^2 - 0.2)*(x^2 + y^2 + z^2 - 0.7)", box, {1, 0, 1}},
    {"x^4 - 5*x^2 + y^4 - 5*y^2 + z^4 - 5*z^2 + 11.8", "{ sphere = 4.4 }", {1, 5, 0}},
    {"x^4 - 5*x^2 + y^4 - 5*y^2 + z^4 - 5*z^2 + 15", "{ sphere = 4.4 }", {8, 0, 0}},
    // Closer than a cube of the coarsest grids that a sample would try.
    {"((x - 0.5)^2 + y^2 + z^2 - 0.25)*((x + 0.51)^2 + y^2 + z^2 - 0.25)",
     "{ box = [[-1.3, -0.7, -0.7], [1.3, 0.7, 0.7]] }",
     {2, 0, 0}},
    // With creases.
    {"x^2 + y^2 + z^2 + 0.4*abs(x + 0.3*y) - 0.5", box, {1, 0, 0}},
    {"max(x^2 + y^2 + z^2 - 0.6, z - 0.1*x - 0.6)", box, {1, 0, 0}},
    {"min((x - 0.5)^2, (x + 0.5)^2) + y^2 + z^2 - 0.1", box, {2, 0, 0}},
};

INSTANTIATE_TEST_SUITE_P(CertifiedFrame, ClosedForms, testing::ValuesIn(known));

// Surfaces across the walls: the solid is what the box holds.
const Known reaching[] = {
    {"x + 0.3*y - 0.21", box, {1, 0, 0}},
    {"z - 0.2", box, {1, 0, 0}},
    {"x^2 - 0.3", box, {1, 0, 0}},
    {"0.3 - x^2", box, {2, 0, 0}},
    {"x^2 + y^2 - 0.3", box, {1, 0, 0}},
    {"0.3 - x^2 - y^2", box, {1, 1, 0}},
    // Half of a ball, an eighth of one, and a box that lacks an eighth of a ball.
    {"(x - 1)^2 + y^2 + z^2 - 0.5", box, {1, 0, 0}},
    {"(x - 1)^2 + (y - 1)^2 + (z - 1)^2 - 0.5", box, {1, 0, 0}},
    {"sin(4*x)*cos(4*y) + sin(4*y)*cos(4*z) + sin(4*z)*cos(4*x) - 0.3", box, {}},
};
class Reaching : public testing::TestWithParam<Known> {};

TEST_P(Reaching, TheWalls) {
    const scene::Scene scene = still(GetParam().formula, GetParam().bounds);
    const StillScene frame(scene, 0);
    const CertifiedFrame proved = certify_frame(frame.formula(Side::negative), frame.bounds);
    ASSERT_TRUE(proved.betti) << describe(proved);
    const SignGrid grid =
        frame_signs(*scene.surfaces[0].field, frame.numbers, frame.bounds, Side::negative, 128);
    EXPECT_EQ(*proved.betti, betti(grid));
    if (GetParam().betti != Betti{}) {
        EXPECT_EQ(*proved.betti, GetParam().betti);
    }
}

INSTANTIATE_TEST_SUITE_P(CertifiedFrame, Reaching, testing::ValuesIn(reaching));

// Degenerate frames have no proof, at any depth.
TEST(CertifiedFrame, SingularFramesAreNotProved) {
    for (const char* formula : {
             "x^2 + y^2 - z^2",                        // a cone
             "x^2 + y^2 + z^2",                        // a point
             "x*y*z",                                  // planes that cross
             "(x^2 + y^2 + z^2 - 0.25)^2",             // a double sphere: no sign changes
             "(0.5 - sqrt(x^2 + y^2))^2 + z^2 - 0.25", // a torus whose hole has just closed
             "x^2 + y^2 + (z - 0.5)^2 - 2.25",         // inside of the wall z = -1 it touches
         }) {
        const CertifiedFrame frame = certified(still(formula, box), 0, {.depth = 7});
        EXPECT_FALSE(frame.betti) << formula;
        EXPECT_FALSE(frame.why.empty()) << formula;
    }
}

TEST(CertifiedFrame, BesideACriticalValue) {
    // The two sheets join at c = 0.
    for (double c : {1e-3, -1e-3}) {
        const CertifiedFrame frame = certified(
            still(fmt::format("x^2 + y^2 - z^2 + {}", c), "{ box = [[-2, -2, -1], [2, 2, 1]] }"));
        ASSERT_TRUE(frame.betti) << c << ": " << describe(frame);
        EXPECT_EQ(frame.betti->components, c > 0 ? 2 : 1);
    }
}

// What a sphere of bounds cuts off is proved, and not where the solid only touches it or ends on
// it.
TEST(CertifiedFrame, ASphereThatIsReached) {
    const auto proved = [](const char* formula) {
        const StillScene frame(still(formula, "{ sphere = 1 }"), 0);
        return certify_frame(frame.formula(Side::negative), frame.bounds, {.depth = 6}).betti;
    };
    EXPECT_EQ(proved("x - 0.1"), (Betti{1, 0, 0}));
    EXPECT_EQ(proved("x^2 + y^2 + z^2 - 4"), (Betti{1, 0, 0}));
    EXPECT_EQ(proved("0.01 - x^2"), (Betti{2, 0, 0})) << "a slab less";
    EXPECT_EQ(proved("0.04 - x^2 - y^2"), (Betti{1, 1, 0})) << "a hole drilled";
    EXPECT_EQ(proved("x - 1"), (Betti{1, 0, 0}))
        << "touched from within: all slopes point outwards";
    EXPECT_FALSE(proved("1 - x")) << "touched from outside";
    EXPECT_FALSE(proved("1 - x^2 - y^2 - z^2"));
}

// A ball is a cube in other coordinates. Surfaces that touch the cube's edges are for cells.
TEST(CertifiedFrame, ABallThatCuts) {
    std::vector<CutSolid> known(std::begin(cut_solids), std::end(cut_solids));
    known.insert(known.end(), {
                                  {"(x+0.3*z)^2 - 0.1", {1, 0, 0}},
                                  {"0.1 - (x+0.3*z)^2", {2, 0, 0}},
                                  {"x^2 - 9", {1, 0, 0}},
                              });
    for (const auto& [formula, betti] : known) {
        SCOPED_TRACE(formula);
        const StillScene frame(still(formula, "{ sphere = 1.2, centre = [0.1, 0, -0.1] }"), 0);
        const CertifiedFrame proved = certify_frame(frame.formula(Side::negative), frame.bounds);
        ASSERT_TRUE(proved.betti) << describe(proved);
        EXPECT_EQ(*proved.betti, betti);
        EXPECT_FALSE(proved.is_by_cells);
    }
    const StillScene edge(still("x - y", "{ sphere = 1.2 }"), 0);
    const CertifiedFrame by_cells = certify_frame(edge.formula(Side::negative), edge.bounds);
    EXPECT_EQ(by_cells.betti, (Betti{1, 0, 0}));
    EXPECT_TRUE(by_cells.is_by_cells);
}

// What a ball cuts off of bells, by two proofs that have little in common.
TEST(CertifiedFrame, ABallThatCutsAsCellsDo) {
    int compared = 0;
    for (int seed = 1; seed <= trials(6, 60); ++seed) {
        SCOPED_TRACE(fmt::format("seed {}", seed));
        const StillScene frame(
            scene_of(fmt::format(
                "[time]\nseed = {}\n[surface]\n"
                "formula = '1.1 - sum(bells, w/(1 + 5*((x-cx)^2 + (y-cy)^2 + (z-cz)^2))^2)'\n"
                "bounds = {{ sphere = 0.9, centre = [0.1, 0.2, 0] }}\n[arrays.bells]\ncount = 8\n"
                "w = '1.6*random(i, 3) - 0.2'\ncx = '2*random(i, 0) - 1'\n"
                "cy = '2*random(i, 1) - 1'\ncz = '2*random(i, 2) - 1'\n",
                seed)),
            0);
        const auto solid = frame.formula(seed % 2 == 0 ? Side::negative : Side::positive);
        const CertifiedFrame proved = certify_frame(solid, frame.bounds);
        ASSERT_TRUE(proved.betti) << describe(proved);
        if (proved.is_by_cells) continue;
        const CertifiedFrame by_cells = certify_by_cells(solid, frame.bounds, {});
        if (!by_cells.betti) continue; // a cell touches the curve that the sphere cuts
        EXPECT_EQ(*proved.betti, *by_cells.betti);
        ++compared;
    }
    EXPECT_GE(compared, trials(5, 50));
}

// Doubles next to 10^8 are further apart than the values of the flat ball at vertices near it. Its
// middle and the bounds' walls are free, and its gradients agree, so that nothing else refuses it.
// It is no sum of functions of one coordinate each, which keep their signs.
TEST(CertifiedFrame, SignsLostInRoundingAreNotProved) {
    const auto ball = [](double slope) {
        const std::string formula =
            fmt::format("(1e8 + {}*(x^2 + y^2 + z^2 + 0.1*x*y - 0.3)) - 1e8", slope);
        return certified(still(formula, box));
    };
    const CertifiedFrame steep = ball(1e-4), flat = ball(2e-7);
    ASSERT_TRUE(steep.betti) << describe(steep);
    EXPECT_EQ(*steep.betti, (Betti{1, 0, 0}));
    EXPECT_FALSE(flat.betti);
    EXPECT_EQ(flat.why, "a sign is lost in rounding");
}

// An enclosure of the parameters proves all frames in it.
TEST(CertifiedFrame, ASpanOfParameters) {
    const scene::Scene scene =
        scene_of("[surface]\nformula = 'x^2 + y^2 + z^2 - r^2'\nbounds = { sphere = 1.5 }\n"
                 "[parameters]\nr = 1\n");
    StillScene frame(scene, 0);
    frame.intervals.parameters[0] = {0.95, 1.05};
    const auto proved = certify_frame(frame.formula(Side::negative), frame.bounds);
    ASSERT_TRUE(proved.betti) << describe(proved);
    EXPECT_EQ(*proved.betti, (Betti{1, 0, 0}));
    frame.intervals.parameters[0] = {0, 1}; // the sphere vanishes
    EXPECT_FALSE(certify_frame(frame.formula(Side::negative), frame.bounds, {.depth = 6}).betti);
}

TEST(CertifiedFrame, OfTheCatalogue) {
    struct Named {
        const char* name;
        Betti betti;
    };
    for (const Named& named : {Named{"torus", {1, 1, 0}}, Named{"tangle", {1, 5, 0}},
                               Named{"torus_quartic", {1, 1, 0}}}) {
        const scene::Scene scene = scene_of(fmt::format("[surface]\nuse = '{}'\n", named.name));
        const CertifiedFrame frame = certified(scene);
        ASSERT_TRUE(frame.betti) << named.name << ": " << describe(frame);
        EXPECT_EQ(*frame.betti, named.betti) << named.name;
    }
}

TEST(CertifiedFrame, Superquadrics) {
    for (double m : {2.0, 3.5, 6.0}) {
        const CertifiedFrame frame = certified(
            scene_of(fmt::format("[surface]\nuse = 'superquadric'\n[parameters]\nm = {}\n", m)));
        ASSERT_TRUE(frame.betti) << m << ": " << describe(frame);
        EXPECT_EQ(*frame.betti, (Betti{1, 0, 0})) << m;
    }
}

TEST(CertifiedFrame, BlobbyFallsTogether) {
    const scene::Scene scene = animated("blobby75");
    for (const auto& [time, expected] :
         {std::pair{0.0, Betti{75, 0, 0}}, std::pair{2.0, Betti{1, 0, 0}}}) {
        const CertifiedFrame frame = certified(scene, time);
        ASSERT_TRUE(frame.betti) << time << ": " << describe(frame);
        EXPECT_EQ(*frame.betti, expected) << time;
    }
}

// Frames of blobs that move, against fine grids. What isn't proved at this depth is beside an
// event.
TEST(CertifiedFrame, FramesAgreeWithGrids) {
    int proved = 0;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        const scene::Scene scene = scene_of(
            fmt::format("[time]\nseed = {}\n[surface]\n"
                        "formula = 'sum(blobs, exp(-12*((x-cx)^2 + (y-cy)^2 + (z-cz)^2))) - 0.4'\n"
                        "bounds = {{ sphere = 2.6 }}\n[arrays.blobs]\ncount = 8\n"
                        "cx = '2.2*random(i, 0) - 1.1'\ncy = '2.2*random(i, 1) - 1.1'\n"
                        "cz = '2.2*random(i, 2) - 1.1'\n",
                        seed));
        const CertifiedFrame frame = certified(scene, 0, {.depth = 8});
        if (!frame.betti) continue;
        ++proved;
        const StillScene numbers(scene, 0);
        const SignGrid grid = frame_signs(*scene.surfaces[0].field, numbers.numbers, numbers.bounds,
                                          Side::positive, 160);
        EXPECT_EQ(*frame.betti, betti(grid)) << "seed " << seed;
    }
    EXPECT_GE(proved, 3);
}

SpaceBox eighth_of(SpaceBox box, formula::Random& random) {
    for (auto& side : box) {
        const double middle = mid(side);
        side = random.below(2) ? formula::Interval(side.lo, middle)
                               : formula::Interval(middle, side.hi);
    }
    return box;
}

// Boxes hold what the field has at their points, with elements left out or not.
TEST(FrameField, EnclosesValuesAndSlopes) {
    const scene::Scene scene = animated("blobby75");
    const StillScene frame(scene, 1.1);
    formula::FieldEvaluator<double> field(*scene.surfaces[0].field);
    FrameField boxes(frame.formula(Side::positive));
    formula::Random random(3);
    int expanded = 0;
    for (int trial = 0; trial < 200; ++trial) {
        Elements near = boxes.everything();
        SpaceBox at{{{-1.5, 1.5}, {-1.5, 1.5}, {-1.5, 1.5}}};
        // From some box on, or never, far elements go by Taylor's formula.
        const int expanded_from = int(random.below(12));
        for (int halvings = 0; halvings < 9; ++halvings) {
            at = eighth_of(at, random);
            ValueAndGradient g;
            boxes.over(near, {&at, 1}, {&g, 1});
            boxes.tighten(near, {&at, 1}, {&g, 1});
            if (!near.are_expanded()) near = boxes.nearer(near, at);
            if (halvings == expanded_from) near = boxes.expanded(near, at);
            std::array<double, 3> p{};
            const bool is_corner = random.below(2) == 0; // where most is added to the middle
            for (std::size_t i = 0; i < 3; ++i) {
                p[i] = is_corner ? (random.below(2) == 0 ? at[i].lo : at[i].hi)
                                 : random.in(at[i].lo, at[i].hi);
            }
            const double slack = 1e-9; // the reference is rounded
            const double f = -field.value(frame.numbers, p);
            EXPECT_TRUE(g.value.lo - slack <= f && f <= g.value.hi + slack);
            const auto gradient = field.gradient(frame.numbers, p);
            for (std::size_t i = 0; i < 3; ++i) {
                EXPECT_TRUE(g.gradient[i].lo - slack <= -gradient[i] &&
                            -gradient[i] <= g.gradient[i].hi + slack);
            }
        }
        expanded += near.are_expanded();
        EXPECT_LT(near.bindings.arrays[0].count, 75);
    }
    EXPECT_GT(expanded, 50);
}

// In a cube's coordinates, too, between any two points of a box.
TEST(FrameField, EnclosesSlopesInABall) {
    const scene::Scene scene = animated("blobby75");
    const StillScene frame(scene, 1.1);
    scene::BoundsAt bounds;
    bounds.centre = {0.1, -0.2, 0.05};
    bounds.radius = 0.8;
    const BallAsCube ball(bounds);
    FrameField boxes(frame.formula(Side::positive), ball);
    formula::Random random(5);
    for (int trial = 0; trial < 200; ++trial) {
        Elements near = boxes.everything();
        SpaceBox at{{{-1, 1}, {-1, 1}, {-1, 1}}};
        const int expanded_from = int(random.below(12));
        for (int halvings = 0; halvings < 9; ++halvings) {
            at = eighth_of(at, random);
            ValueAndGradient g;
            boxes.over(near, {&at, 1}, {&g, 1});
            if (random.below(2) == 0) boxes.tighten(near, {&at, 1}, {&g, 1});
            if (!near.are_expanded()) near = boxes.nearer(near, at);
            if (halvings == expanded_from) near = boxes.expanded(near, at);
            SpaceBox from, to;
            for (std::size_t i = 0; i < 3; ++i)
                from[i] = random.below(2) ? at[i].lo : random.in(at[i].lo, at[i].hi);
            const auto axis = std::size_t(random.below(3));
            to = from;
            to[axis] = random.below(2) ? at[axis].hi : random.in(at[axis].lo, at[axis].hi);
            std::array<SpaceBox, 2> ends{from, to};
            std::array<formula::Interval, 2> values;
            boxes.values(boxes.everything(), ends, values);
            for (const auto& value : values)
                EXPECT_TRUE(g.value.lo <= value.hi && value.lo <= g.value.hi);
            if (from[axis] == to[axis]) continue;
            const auto quotient = (values[1] - values[0]) / (to[axis] - from[axis]);
            EXPECT_TRUE(g.gradient[axis].lo <= quotient.hi && quotient.lo <= g.gradient[axis].hi);
        }
    }
}

// Asked in between, after little work each time.
TEST(CertifiedFrame, StopsWhenAsked) {
    const scene::Scene tangle =
        still("x^4 - 5*x^2 + y^4 - 5*y^2 + z^4 - 5*z^2 + 11.8", "{ sphere = 4.4 }");
    int asked = 0;
    const CertifiedFrame whole = certified(tangle, 0, {.stopped = [&] { return ++asked < 0; }});
    EXPECT_TRUE(whole.betti);
    EXPECT_GE(asked, whole.boxes / 8 - 1);
    const int times = asked;
    for (const int after : {1, times / 4, times - 1}) {
        asked = 0;
        const CertifiedFrame some =
            certified(tangle, 0, {.stopped = [&] { return ++asked > after; }});
        EXPECT_FALSE(some.betti) << after;
        EXPECT_EQ(some.why, "interrupted") << after;
        EXPECT_EQ(asked, after + 1);
    }
}

} // namespace
} // namespace isomotion::topology
