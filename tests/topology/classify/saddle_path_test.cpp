// Proofs of paths: what they may never say, and what they must.
#include "topology/classify/saddle_path.h"

#include <gtest/gtest.h>

#include "topology/classify/event_sides.h"
#include "topology/classify/field_snapshot.h"
#include "topology/field/timed_formula.h"
#include "topology/scenes.h"
#include "unit/formula/testing.h"

namespace isomotion::topology {
namespace {

// A surface at rest.
class Still {
public:
    explicit Still(const std::string& formula, const std::string& bounds = "{ sphere = 2 }")
        : scene_(still(formula, bounds))
        , frame_(scene_, 0)
        , field_(std::make_shared<FrameField>(frame_.formula(Side::negative)))
        , snapshot_(field_snapshot(field_, enclosed(frame_.bounds))) {}

    SublevelSet solid() const { return {snapshot_, true}; }
    SublevelSet rest() const { return {snapshot_, false}; }
    double value(const SpacePoint& p) const {
        const SpaceBox box = point_box(p);
        formula::Interval value;
        field_->values(field_->everything(), {&box, 1}, {&value, 1});
        return mid(value);
    }

private:
    scene::Scene scene_;
    StillScene frame_;
    std::shared_ptr<FrameField> field_;
    FieldSnapshot snapshot_;
};

using Corners = std::vector<SpacePoint>;

// A tube of radius 1e-4 along (1, 2, 3), whole or with a cut through it.
std::string tube(double cut, double wide) {
    const double n = std::sqrt(14.0);
    const std::string s = fmt::format("({:.17g}*x + {:.17g}*y + {:.17g}*z)", 1 / n, 2 / n, 3 / n);
    return fmt::format("x^2 + y^2 + z^2 - {0}^2 - 1e-8 + {1}*exp(-({0}/{2})^2)", s, cut, wide);
}

TEST(SaddlePath, AThinSlantedTube) {
    const double n = std::sqrt(14.0);
    const Corners corners{{1 / n, 2 / n, 3 / n}, {-1 / n, -2 / n, -3 / n}};
    const Still whole(tube(0, 1));
    EXPECT_TRUE(is_path(whole.solid(), corners));
    EXPECT_FALSE(is_path(whole.rest(), corners));
    // Narrowed to a hundredth of itself, and cut by as little.
    for (const double wide : {0.3, 1e-3, 1e-6}) {
        EXPECT_TRUE(is_path(Still(tube(0.9999e-8, wide)).solid(), corners)) << wide;
        EXPECT_FALSE(is_path(Still(tube(1.0001e-8, wide)).solid(), corners)) << wide;
    }
}

// The plane between both sides belongs to neither, however near to it they come.
TEST(SaddlePath, NotAcrossASheetWithoutThickness) {
    const Still sheet("-(x + 2*y - z)^2");
    EXPECT_FALSE(is_path(sheet.solid(), Corners{{1, 0, 0}, {-1, 0, 0}}));
    EXPECT_FALSE(is_path(sheet.solid(), Corners{{1e-7, 0, 0}, {-1e-7, 0, 0}}));
    EXPECT_TRUE(is_path(sheet.solid(), Corners{{1e-3, 0, 0}, {1, 0, 0}}));
    EXPECT_FALSE(is_path(sheet.solid(), Corners{{1, 0, 0}, {0, 0, 0}}));
    // Nor of what is not solid, from near to it to farther away.
    const Still inverse("(x + 2*y - z)^2");
    EXPECT_FALSE(is_path(inverse.rest(), Corners{{1, 0, 0}, {-0.3, 0, 0}}));
    EXPECT_FALSE(is_path(inverse.rest(), Corners{{0.3, 0, 0}, {-1, 0, 0}}));
    EXPECT_TRUE(is_path(inverse.rest(), Corners{{0.3, 0, 0}, {1, 0, 0}}));
}

TEST(SaddlePath, ManyCorners) {
    // Round a ring, and across its hole.
    const Still ring("(sqrt(x^2 + y^2 + 1e-9) - 1)^2 + z^2 - 0.01");
    Corners around, across;
    for (int k = 0; k <= 60; ++k) {
        const double angle = 0.05 * k;
        around.push_back({std::cos(angle), std::sin(angle), 0});
        across.push_back({1 - k / 30.0, 0, 0});
    }
    EXPECT_TRUE(is_path(ring.solid(), around));
    std::size_t failed = 0;
    EXPECT_FALSE(is_path(ring.solid(), across, &failed));
    EXPECT_GT(failed, 0u);
    EXPECT_LT(failed, 60u);
    EXPECT_TRUE(is_path(ring.rest(), Corners(across.begin() + 10, across.end() - 10)));
}

TEST(SaddlePath, OutsideOfTheBounds) {
    const Still ball("x^2 + y^2 + z^2 - 1", "{ sphere = 1.5 }");
    // Around, through the outside; what isn't solid leaves the bounds and comes back.
    EXPECT_TRUE(
        is_path(ball.rest(), Corners{{1.2, 0, 0}, {1.7, 0, 0}, {-1.7, 0, 0}, {-1.2, 0, 0}}));
    EXPECT_FALSE(is_path(ball.rest(), Corners{{1.2, 0, 0}, {-1.2, 0, 0}}));
    // The solid ends where the bounds do.
    const Still all("-1 + 1e-9*x", "{ box = [[-1, -1, -1], [1, 1, 1]] }");
    EXPECT_TRUE(is_path(all.solid(), Corners{{0.9, 0, 0}, {-0.9, 0.9, 0}}));
    EXPECT_FALSE(is_path(all.solid(), Corners{{0.9, 0, 0}, {1.1, 0, 0}}));
}

// Segments through random fields: what is proved has no sample against it, and what is clear is
// proved.
TEST(SaddlePath, RandomSegments) {
    int proved = 0, refused = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        SCOPED_TRACE(seed);
        formula::Random random(seed);
        std::string formula = "0.3";
        for (int k = 0; k < 6; ++k) {
            formula += fmt::format(" - {}*exp(-6*((x - {})^2 + (y - {})^2 + (z - {})^2))",
                                   random.in(-0.5, 1), random.in(-1, 1), random.in(-1, 1),
                                   random.in(-1, 1));
        }
        const Still field(formula);
        for (int k = 0; k < 20; ++k) {
            const auto point = [&] {
                return SpacePoint{random.in(-1, 1), random.in(-1, 1), random.in(-1, 1)};
            };
            const Corners corners{point(), point()};
            double most = -1, least = 1;
            for (int sample = 0; sample <= 500; ++sample) {
                const SpacePoint across = difference(corners[1], corners[0]);
                const double value = field.value(along(corners[0], sample / 500.0, across));
                most = std::max(most, value);
                least = std::min(least, value);
            }
            const bool in_solid = is_path(field.solid(), corners);
            const bool in_rest = is_path(field.rest(), corners);
            if (most >= 0) {
                EXPECT_FALSE(in_solid);
            }
            if (least <= 0) {
                EXPECT_FALSE(in_rest);
            }
            if (most < -1e-4) {
                EXPECT_TRUE(in_solid);
            }
            if (least > 1e-4) {
                EXPECT_TRUE(in_rest);
            }
            proved += in_solid || in_rest;
            refused += !in_solid && !in_rest;
        }
    }
    EXPECT_GT(proved, 100);
    EXPECT_GT(refused, 50);
}

// Where bounds move, only what lies inside, or outside, at all times of a span is said to.
TEST(SaddlePath, BoundsOfAWholeSpan) {
    for (const std::string bounds : {"{ sphere = 'r' }", "{ box = [[-1, -1, -1], ['r', 1, 1]] }"}) {
        SCOPED_TRACE(bounds);
        const scene::Scene scene =
            scene_of("[time]\nfps = 10\nframes = 11\n[parameters]\nr = '1 + t'\n[surface]\n"
                     "formula = 'x^2 + y^2 + z^2 - 0.5'\nbounds = " +
                     bounds + "\n");
        const TimedFormula formula(
            motions(scene, Side::negative, {0, 1}, Clock::time).pieces.at(0));
        const formula::Interval span{0.25, 0.75};
        const auto field = std::make_shared<FrameField>(formula.formula());
        const FieldSnapshot snapshot = field_snapshot(field, formula.bounds(span));
        const auto is_outside = [&](double x) { return snapshot.is_outside(SpaceBox{x, 0, 0}); };
        EXPECT_TRUE(snapshot.is_inside({1.2499, 0, 0}));
        EXPECT_FALSE(snapshot.is_inside({1.2501, 0, 0}));
        EXPECT_FALSE(is_outside(1.7499));
        EXPECT_TRUE(is_outside(1.7501));
        EXPECT_TRUE(contains(snapshot.box[0], 1.75));
        // Beyond the sphere at the span's beginning, though not beyond its walls.
        EXPECT_EQ(snapshot.is_inside({0.9, 0.9, 0}),
                  scene.surfaces[0].bounds.shape == scene::Bounds::Shape::box);
    }
}

// A saddle on the floor, so near to an edge that it might be on the wall behind it as well.
TEST(SaddlePath, OnWhichWallIsNotGuessed) {
    for (const double above : {1e-3, 1e-8}) {
        SCOPED_TRACE(above);
        const Still surface(fmt::format("2*(y + 1 - {0:.17g})^2 - x^2 + z + 1", above),
                            "{ box = [[-1, -1, -1], [1, 1, 1]] }");
        const double off = 2e-8, y = above - 1;
        Event event;
        event.where = {formula::Interval(-1e-9, 1e-9), {y - off, y + off}, -1.0};
        event.stratum = 2;
        event.index = 1;
        EXPECT_EQ(both_sides(surface.solid(), event).has_value(), above > off);
    }
}

} // namespace
} // namespace isomotion::topology
