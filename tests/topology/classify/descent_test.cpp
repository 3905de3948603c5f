// Ways down and the graph of passes, on a field whose minima and saddles are known:
//
//     G = sum over x, y of (u^2 - 1)^2 + z^2 - tilts,
//
// four minima near (+-1, +-1, 0), joined in a ring by saddles near (0, +-1, 0) and (+-1, 0, 0).
#include "topology/classify/descent.h"

#include <gtest/gtest.h>

#include "topology/classify/morse_graph.h"
#include "topology/classify/saddle_tracks.h"
#include "topology/scenes.h"
#include "unit/formula/testing.h"

namespace isomotion::topology {
namespace {

class FourWells : public testing::Test {
protected:
    FourWells()
        : scene_(still("(x^2 - 1)^2 + (y^2 - 1)^2 + z^2 - 0.1*x*y^2 - 0.02*y*x^2 - 1.5",
                       "{ sphere = 3 }"))
        , frame_(scene_, 0)
        , field_(frame_.formula(Side::negative)) {
        for (const auto& saddle : saddles_near(
                 field_, std::vector<SpacePoint>{{0, 1, 0}, {0, -1, 0}, {1, 0, 0}, {-1, 0, 0}}, 4,
                 0.5)) {
            EXPECT_TRUE(saddle);
            if (saddle) saddles_.push_back(*saddle);
        }
    }

    Domain domain(double reach = 3) const {
        Domain domain;
        domain.box.fill({-reach, reach});
        domain.is_inside = [=](const SpacePoint& p) { return length(p) < reach; };
        domain.is_outside = [=](const SpacePoint& p) { return length(p) > reach; };
        return domain;
    }

    scene::Scene scene_;
    StillScene frame_;
    PointField field_;
    std::vector<SpacePoint> saddles_;
};

TEST_F(FourWells, SaddlesFromSeedsAreThese) {
    std::vector<SpacePoint> found = saddles_from_seeds(field_, domain().box, 4000);
    EXPECT_EQ(found.size(), 4u);
    add_points(found, saddles_, 1e-6);
    EXPECT_EQ(found.size(), 4u);
}

TEST_F(FourWells, WaysFallToMinima) {
    formula::Random random(7);
    std::vector<Start> starts;
    for (int k = 0; k < 100; ++k)
        starts.push_back({{random.in(-1.2, 1.2), random.in(-1.2, 1.2), random.in(-0.6, 0.6)}, {}});
    for (const DescentPath& path : descent_paths(field_, domain(), starts)) {
        ASSERT_EQ(path.end, DescentPath::End::minimum);
        std::vector<PointJet> jets;
        field_.jets(path.points, jets);
        for (std::size_t k = 1; k < jets.size(); ++k)
            EXPECT_LE(jets[k].value, jets[k - 1].value + 1e-12);
        EXPECT_LT(length(jets.back().gradient), 1e-6);
        EXPECT_EQ(inertia(jets.back().hessian).positive, 3);
    }
}

TEST_F(FourWells, EachSaddleJoinsTwoNeighbours) {
    for (const SaddleConnection& connection : saddle_connections(field_, domain(), saddles_)) {
        EXPECT_LT(connection.height, 0);
        const SpacePoint a = connection.paths[0].points.back(),
                         b = connection.paths[1].points.back();
        EXPECT_NEAR(distance(a, b), 2, 0.2);
        EXPECT_EQ(connection.paths[0].points.front(), connection.paths[1].points.front());
    }
}

TEST_F(FourWells, RoutesTakeTheLowestPasses) {
    MorseGraph graph(1e-5);
    const std::vector<SaddleConnection> all = saddle_connections(field_, domain(), saddles_);
    graph.add(all);
    // From one side of each saddle to the other without it: three passes; and with it, over it or
    // round, where that is lower.
    for (std::size_t k = 0; k < all.size(); ++k) {
        const DescentPath &from = all[k].paths[0], &to = all[k].paths[1];
        double lowest_round = -10;
        for (std::size_t j = 0; j < all.size(); ++j) {
            if (j != k) lowest_round = std::max(lowest_round, all[j].height);
        }
        const auto count = [](const Route& route) {
            std::vector<std::size_t> over = route.over;
            std::erase(over, Route::none);
            const auto rest = std::ranges::unique(over);
            return std::ptrdiff_t(over.size()) - std::ptrdiff_t(rest.size());
        };
        const auto with = graph.route(from, to);
        ASSERT_TRUE(with);
        EXPECT_EQ(count(*with), all[k].height < lowest_round ? 1 : 3) << k;
        EXPECT_EQ(with->points.front(), from.points.front());
        EXPECT_EQ(with->points.back(), to.points.front());

        MorseGraph without(1e-5);
        without.add(all);
        without.close(k);
        const auto round = without.route(from, to);
        ASSERT_TRUE(round);
        EXPECT_EQ(count(*round), 3);
        without.close((k + 1) % 4);
        EXPECT_FALSE(without.route(from, to));
        EXPECT_FALSE(without.gaps(from, to, domain()).empty());
    }
}

TEST_F(FourWells, WaysEndAtTheBounds) {
    // -G falls outwards without end.
    field_.bind(frame_.intervals, true);
    Domain outwards = domain();
    outwards.is_solid = false;
    const std::vector<Start> starts{{{1.6, 0.1, 0.2}, {}}, {{0.1, -1.7, -0.4}, {}}};
    for (const DescentPath& path : descent_paths(field_, outwards, starts)) {
        EXPECT_EQ(path.end, DescentPath::End::outside);
        EXPECT_GT(length(path.points.back()), 3);
    }
    // A solid that is cut off has its minima at the wall.
    field_.bind(frame_.intervals, false);
    Domain box;
    box.box.fill({-0.5, 0.5});
    box.is_inside = [](const SpacePoint& p) {
        return std::ranges::all_of(p, [](double x) { return std::abs(x) < 0.5; });
    };
    const DescentPath path =
        descent_paths(field_, box, std::vector<Start>{{{0.1, 0.2, 0.1}, {}}})[0];
    EXPECT_EQ(path.end, DescentPath::End::minimum);
    EXPECT_LT(distance(path.points.back(), {0.5, 0.5, 0}), 1e-3);
    for (const SpacePoint& p : path.points) EXPECT_TRUE(box.is_inside(p));
}

} // namespace
} // namespace isomotion::topology
