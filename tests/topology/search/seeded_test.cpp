// Critical points from seeds: those that the search finds, and never others.
#include "topology/analyse.h"
#include "topology/field/motion.h"
#include "topology/moving.h"
#include "topology/search/seeded.h"

namespace isomotion::topology {
namespace {

constexpr int many = 1 << 14;

const Moving tangle{"x^4 - 5*x^2 + y^4 - 5*y^2 + z^4 - 5*z^2 + c",
                    "{ box = [[-2.5, -2.5, -2.5], [2.5, 2.5, 2.5]] }", "c = \"20 - 2*t\""};

Timeline seeded_events_of(const Moving& moving, double from, double to, int seeds = many,
                          int threads = 1) {
    EventSearchOptions how;
    how.seeds = seeds;
    how.threads = threads;
    return events_of(moving, from, to, Side::negative, how);
}

// Each is one of the search's, which has all: the same point, with what is proved of it.
void expect_among(const Timeline& seeded, const Timeline& all) {
    std::vector<bool> taken(all.events.size(), false);
    for (const Event& event : seeded.events) {
        std::size_t k = 0;
        const auto is_same = [&](const Event& other) {
            bool same = !is_empty(intersect(event.time, other.time));
            for (std::size_t i = 0; i < 3; ++i) {
                same &= !is_empty(intersect(event.where[i], other.where[i]));
            }
            return same;
        };
        while (k < all.events.size() && (taken[k] || !is_same(all.events[k]))) ++k;
        ASSERT_LT(k, all.events.size()) << testing::PrintToString(event);
        taken[k] = true;
        EXPECT_TRUE(event.is_proved);
        EXPECT_EQ(event.index, all.events[k].index);
        EXPECT_EQ(event.grows, all.events[k].grows);
        EXPECT_EQ(event.stratum, all.events[k].stratum);
        EXPECT_EQ(event.kind, all.events[k].kind);
    }
}

TEST(Seeded, FindsSimultaneousEventsAndThoseOnFaces) {
    const Moving octic{"chebyshev(8, x) + chebyshev(8, y) + chebyshev(8, z) + c",
                       "{ box = [[-1.04593, -1.04593, -1.04593], [1.04593, 1.04593, 1.04593]] }",
                       "c = \"t - 3.5\""};
    const Moving gyroid{"sin(x)*cos(y) + sin(y)*cos(z) + sin(z)*cos(x) - c",
                        "{ box = [[-3.6, -3.6, -3.6], [3.6, 3.6, 3.6]] }", "c = \"t - 2\""};
    for (const auto& [moving, from, to] :
         {std::tuple(tangle, 0.0, 11.0), std::tuple(octic, 0.0, 7.0),
          std::tuple(gyroid, 0.0, 4.0)}) {
        SCOPED_TRACE(moving.formula);
        const Timeline all = events_of(moving, from, to);
        const Timeline seeded = seeded_events_of(moving, from, to);
        expect_among(seeded, all);
        EXPECT_EQ(seeded.events.size(), all.events.size());
    }
}

TEST(Seeded, NeverSaysThatNoneIsMissing) {
    for (const int seeds : {1, many}) {
        const Timeline timeline = seeded_events_of(tangle, 0, 11, seeds);
        EXPECT_FALSE(timeline.is_proved);
        EXPECT_FALSE(timeline.is_complete());
        ASSERT_FALSE(timeline.doubts.empty());
        EXPECT_EQ(timeline.doubts[0], "found from seeds: events may be missing");
    }
}

TEST(Seeded, DoesNotDependOnTheNumberOfThreads) {
    const Timeline one = seeded_events_of(tangle, 0, 11, 2048, 1);
    EXPECT_FALSE(one.events.empty());
    EXPECT_EQ(one, seeded_events_of(tangle, 0, 11, 2048, 3));
}

TEST(Seeded, ADegeneratePointIsNoEvent) {
    const Moving monkey{"x^3 - 3*x*y^2 + z^2 - c", "{ box = [[-1, -1, -1], [1, 1, 1]] }",
                        "c = \"t - 0.5\""};
    // The faces have theirs.
    const Timeline timeline = seeded_events_of(monkey, 0.3, 1.7);
    EXPECT_FALSE(timeline.events.empty());
    for (const Event& event : timeline.events) EXPECT_LT(event.stratum, 3);
}

TEST(Seeded, LimitsOutsideOfTheDomainAreNone) {
    // Its one critical point is at z = 1, at clock 0.
    const Moving outside{"x^2 + y^2 + (z - 1)^2 - c", "{ box = [[-1, -1, -1], [1, 1, 0.9]] }",
                         "c = \"t\""};
    const Motions parts = motions(outside.scene(), Side::negative, {-1, 1});
    const MovingField field(parts.pieces.at(0), {});
    const SearchResult found = from_seeds(field, {.seeds = 1000});
    EXPECT_TRUE(found.points.empty());
    EXPECT_TRUE(found.unresolved.empty());
}

TEST(Seeded, StopsWhenAsked) {
    EventSearchOptions how;
    how.seeds = many;
    how.stopped = [] { return true; };
    const Timeline timeline = events_of(tangle, 0, 11, Side::negative, how);
    EXPECT_TRUE(timeline.events.empty());
    EXPECT_FALSE(timeline.is_proved);
}

bool says_that_events_were_missed(const Timeline& timeline) {
    return std::ranges::any_of(timeline.doubts, [](const std::string& doubt) {
        return doubt.starts_with("events were missed");
    });
}

TEST(AnalyseFast, HasEventsKindsOfTheirIndexAndBothEnds) {
    Moving born = tangle;
    born.rest = "[time]\nfps = 10\nframes = 111\n";
    AnalyseOptions how;
    how.certify = Certify::fast;
    how.threads = 1;
    const Timeline timeline = analyse(born.scene(), how);
    // Eight balls are born, join, and fill.
    EXPECT_EQ(timeline.start, (Betti{0, 0, 0}));
    EXPECT_EQ(timeline.end, (Betti{1, 0, 0}));
    EXPECT_FALSE(timeline.start_is_proved);
    EXPECT_FALSE(timeline.end_is_proved);
    EXPECT_FALSE(timeline.is_proved);
    int births = 0, fills = 0;
    for (const Event& event : timeline.events) {
        births += event.kind == Kind::birth;
        fills += event.kind == Kind::void_fills;
        EXPECT_NE(event.kind_proof, "path");
        EXPECT_NE(event.kind_proof, "counting");
    }
    EXPECT_EQ(births, 8);
    EXPECT_EQ(fills, 1);
    EXPECT_FALSE(says_that_events_were_missed(timeline));
}

// No gradient leads to where a cube is born: the ends tell that something was.
TEST(AnalyseFast, SaysThatEventsWereMissedWhereTheEulerNumberTells) {
    AnalyseOptions how;
    how.certify = Certify::fast;
    how.threads = 1;
    const Moving cube{"max(abs(x), max(abs(y), abs(z))) - c", "{ box = [[-1, -1, -1], [1, 1, 1]] }",
                      "c = \"t - 0.5\"", "[time]\nfps = 10\nframes = 11\n"};
    const Timeline missed = analyse(cube.scene(), how);
    EXPECT_EQ(missed.start, (Betti{0, 0, 0}));
    EXPECT_EQ(missed.end, (Betti{1, 0, 0}));
    EXPECT_TRUE(missed.events.empty()) << described(missed);
    EXPECT_TRUE(says_that_events_were_missed(missed)) << described(missed);
}

} // namespace
} // namespace isomotion::topology
