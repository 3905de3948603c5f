// Critical points of sums of functions of one coordinate each: those that the search in space
// finds.
#include "topology/search/separable_search.h"

#include <random>

#include "topology/analyse.h"
#include "topology/moving.h"

namespace isomotion::topology {
namespace {

using formula::Interval;

bool meet(const Box& a, const Box& b, std::size_t n) {
    for (std::size_t k = 0; k < n; ++k) {
        if (is_empty(intersect(a[k], b[k]))) return false;
    }
    return true;
}

// Both find the same points in each stratum, and enclose them. How many.
std::size_t compare(const Moving& moving) {
    std::size_t count = 0;
    const Motions all = motions(moving.scene(), Side::negative, {0, 1});
    for (const Motion& motion : all.pieces) {
        for (const Stratum& stratum : strata_of_box()) {
            const auto fast = search_separable(motion, stratum, {});
            EXPECT_TRUE(fast);
            if (!fast) continue;
            const MovingField field(motion, stratum);
            SearchResult slow = search(field, {});
            EXPECT_TRUE(slow.unresolved.empty());
            // Points outside of the bounds may be found, or not.
            Enclosures enclosures(field);
            const auto is_beyond = [&](const CriticalPoint& point) {
                return enclosures.place(point.where) == Enclosures::Place::outside ||
                       !meet(point.where, field.domain(), std::size_t(field.variables()));
            };
            std::vector<CriticalPoint> points = fast->found.points;
            std::erase_if(points, is_beyond);
            std::erase_if(slow.points, is_beyond);
            EXPECT_EQ(points.size(), slow.points.size());
            for (const CriticalPoint& point : points) {
                const auto is_it = [&](const CriticalPoint& other) {
                    return meet(other.where, point.where, std::size_t(field.variables()));
                };
                EXPECT_EQ(std::ranges::count_if(slow.points, is_it), 1);
                EXPECT_TRUE(contains(point.jet.value, 0.0));
            }
            count += points.size();
        }
    }
    return count;
}

TEST(SeparableSearch, FindsWhatTheSearchInSpaceFinds) {
    std::size_t count = 0;
    for (unsigned seed = 1; seed <= 4; ++seed) {
        SCOPED_TRACE(fmt::format("seed {}", seed));
        std::mt19937_64 random(seed);
        const auto number = [&](double low, double high) {
            return std::uniform_real_distribution<double>(low, high)(random);
        };
        const auto term = [&](const char* x) {
            switch (random() % 4) {
            case 0:
                return fmt::format("{0}^4 - {1:.3f}*{0}^2", x, number(0.5, 3));
            case 1:
                return fmt::format("sin({:.3f}*{} + {:.3f})", number(1, 5), x, number(-1, 1));
            case 2:
                return fmt::format("{:.3f}*chebyshev(5, {}*0.7)", number(0.3, 1), x);
            default:
                return fmt::format("exp(-({} - {:.3f})^2)", x, number(-0.7, 0.7));
            }
        };
        const Moving moving{
            fmt::format("{} + {} - 0.5*({} - c)", term("x"), term("y"), term("z")),
            "{ box = [[-1.31, -1.27, -1.4], [\"1.1 + 0.2*c\", 1.21, 1.3]] }",
            fmt::format("c = \"{:.3f} + {:.3f}*sin(3*t)\"", number(-2, 2), number(1, 4))};
        SCOPED_TRACE(moving.formula);
        count += compare(moving);
    }
    EXPECT_GT(count, 20U);
}

// Both terms of the wall and of the clock move: what is found is on the wall where that is.
TEST(SeparableSearch, FollowsWallsThatMove) {
    const Moving moving{"x^2 + y^2 + z^2 - R", "{ box = [[-3, -3, -3], [\"0.5 + t\", 3, 3]] }",
                        "R = \"2 - 1.5*t\""};
    // The ball and the wall meet where (0.5 + t)^2 = 2 - 1.5 t.
    const double at = (-2.5 + std::sqrt(2.5 * 2.5 + 4 * 1.75)) / 2;
    const Timeline found = events_of(moving, 0, 1);
    EXPECT_TRUE(found.is_proved);
    const auto on_wall = std::ranges::count_if(found.events, [&](const Event& event) {
        return event.stratum == 2 && std::abs(mid(event.time) - at) < 1e-12;
    });
    EXPECT_EQ(on_wall, 1) << described(found);
}

// A clock that rests where the sum has a critical value leaves the point to the search in space.
TEST(SeparableSearch, IsNoneWhereThePointIsDegenerate) {
    const std::string box = "{ box = [[-2, -2, -2], [2, 2, 2]] }";
    for (const auto& [formula, clock] : {std::pair{"x^2 + y^2 + z^2 - 1 + c", "1 + (t - 0.5)^3"},
                                         {"x^4 + y^2 + z^2 + c", "t - 0.5"},
                                         {"abs(x) + y^2 + z^2 + c", "t - 0.5"},
                                         {"x*y + z^2 + c", "t - 0.5"}}) {
        const Moving moving{formula, box, fmt::format("c = \"{}\"", clock)};
        const Motions all = motions(moving.scene(), Side::negative, {0, 1}, Clock::time);
        EXPECT_FALSE(search_separable(all.pieces.front(), Stratum{}, {})) << formula;
    }
}

// Too many events at a moment for paths: a frame tells of all of them.
TEST(SeparableSearch, OfChmutovsSurfaceIsAWholeTimeline) {
    const scene::Scene scene = animated("chmutov_14");
    AnalyseOptions how;
    how.first = 30;
    how.last = 45;
    const Timeline timeline = analyse(scene, how);
    EXPECT_TRUE(timeline.is_complete());
    EXPECT_EQ(timeline.start, (Betti{1, 540, 0}));
    EXPECT_EQ(timeline.end, (Betti{343, 0, 0}));
    EXPECT_EQ(std::ranges::count(timeline.events, Kind::split, &Event::kind), 342);
    EXPECT_EQ(std::ranges::count(timeline.events, Kind::tunnel_breaks, &Event::kind), 540);
    EXPECT_EQ(timeline.events.size(), 882U);
}

} // namespace
} // namespace isomotion::topology
