// Events of formulas with kinks: closed forms, and the distance to random points, whose critical
// points are known (Edelsbrunner; Siersma 1999: centres of simplices of Delaunay and Gabriel).
#include <random>

#include <gtest/gtest.h>

#include "topology/moving.h"

namespace isomotion::topology {
namespace {

const std::string around = "{ box = [[-2.1, -2.2, -2.3], [2.4, 2.5, 2.2]] }";

TEST(KinkedEvents, OfTwoBallsJoinedByMinIsAMerge) {
    for (const char* formula :
         {"min((x - s)^2 + y^2 + z^2 - 0.25, (x + s)^2 + y^2 + z^2 - 0.25)",
          "min(sqrt((x - s)^2 + y^2 + z^2) - 0.5, sqrt((x + s)^2 + y^2 + z^2) - 0.5)"}) {
        SCOPED_TRACE(formula);
        const Moving moving{formula, around, "s = \"0.8 - t\""};
        expect_events(events_of(moving, 0, 0.7), {{0.3, 1, 1, true}});
    }
}

TEST(KinkedEvents, OfTheLeastOfTwoBallsIsAMerge) {
    const Moving moving{"least(balls, (x - side*d)^2) + y^2 + z^2 - 1", "{ sphere = 4 }",
                        "d = \"2 - t\"", "[arrays.balls]\ncount = 2\nside = \"2*i - 1\""};
    expect_events(events_of(moving, 0, 1.5), {{1, 1, 1, true}});
}

// A hole in a ball reaches its wall from within; it leaves through its own opening.
TEST(KinkedEvents, OfABallLessABallIsAVoidThatOpens) {
    const Moving moving{"max(x^2 + y^2 + z^2 - 1, 0.25 - (x - s)^2 - y^2 - z^2)", around,
                        "s = \"t - 0.25\""};
    expect_events(events_of(moving, 0, 3), {{0.75, 1, 2, false}});
}

TEST(KinkedEvents, OfATorusWithARootAreAtItsAxis) {
    const Moving moving{"(sqrt(x^2 + y^2) - R)^2 + z^2 - 0.0625", around, "R = \"0.125 + t/2\""};
    expect_events(events_of(moving, 0, 1), {{0.25, 1, 2, false}});
}

// The distance has a cone at the centre: there a ball dies.
TEST(KinkedEvents, OfABallThatShrinksToItsCentreIsADeath) {
    const Moving moving{"sqrt(x^2 + 4*y^2 + z^2) - r", around, "r = \"0.5 - t\""};
    expect_events(events_of(moving, 0, 1), {{0.5, 1, 0, false}});
}

// On the axis beside the cone's tip F is z^2 - z + s.
TEST(KinkedEvents, NearAConeAreSeenBesideIt) {
    const Moving moving{"sqrt(x^2 + y^2 + z^2) - 2*z + z^2 + s", around, "s = \"t - 0.5\""};
    expect_events(events_of(moving, 0, 1), {{0.75, 1, 0, false}});
}

TEST(KinkedEvents, OfAnOctahedronAreItsBirth) {
    const Moving moving{"abs(x - 0.1) + abs(y) + abs(z) + s", around, "s = \"0.5 - t\""};
    expect_events(events_of(moving, 0, 1), {{0.5, 1, 0, true}});
}

// Two drills through a cube, at right angles, come together and part again.
TEST(KinkedEvents, OfDrillsThatMeetAndPart) {
    const Moving moving{"max(max(max(abs(x), abs(y)), abs(z)) - 1, "
                        "max(0.0625 - x^2 - (y - s)^2, 0.0625 - (y + s)^2 - z^2))",
                        around, "s = \"0.5 - t\""};
    expect_events(events_of(moving, 0, 1), {{0.25, 1, 2, false}, {0.75, 1, 2, true}});
}

// Kinks beside the surface, and edges and corners of it, change nothing.
TEST(KinkedEvents, AreNoneOfWhatOnlyMoves) {
    for (const char* formula :
         {"max(max(abs(x - s), abs(y)), abs(z - s/2)) - 0.7",
          "max(max(abs(0.6*(x - s) + 0.8*y), abs(0.8*(x - s) - 0.6*y)), abs(z)) - 0.7",
          "sqrt(max(abs(x) - 0.5, 0)^2 + max(abs(y) - 0.4, 0)^2 + max(abs(z) - s, 0)^2) - 0.2"}) {
        SCOPED_TRACE(formula);
        const Moving moving{formula, around, "s = \"0.2 + t/3\""};
        expect_events(events_of(moving, 0, 1), {});
    }
}

// Balls are born inside of another one, and outside of what they are cut out of.
TEST(KinkedEvents, AreNoneOfWhatIsHidden) {
    for (const char* formula : {"min(x^2 + y^2 + z^2 - 1, (x - 0.2)^2 + y^2 + z^2 - 0.2*s)",
                                "max(x^2 + y^2 + z^2 - 1, 0.2*s - (x - 1.6)^2 - y^2 - z^2)"}) {
        SCOPED_TRACE(formula);
        const Moving moving{formula, around, "s = \"t - 0.5\""};
        expect_events(events_of(moving, 0, 1), {});
    }
}

TEST(KinkedEvents, OfASuperquadricThroughAnOctahedronAreNone) {
    for (const char* m : {"0.7 + 0.6*t", "1.3 - 0.6*t"}) {
        const Moving moving{"abs(x)^m + abs(y)^m + abs(z)^m - 1", around,
                            fmt::format("m = \"{}\"", m)};
        expect_events(events_of(moving, 0, 1), {});
    }
}

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

// The centre of the points' smallest common sphere as weights of the points; by Gauss's elimination
// of 2 <p_i - p_0, p_j - p_0> w_j = |p_i - p_0|^2. Empty of points in a plane less than theirs.
std::optional<std::vector<double>> weights_of_centre(const std::vector<Vector>& points) {
    const std::size_t n = points.size() - 1;
    std::vector<std::vector<double>> a(n, std::vector<double>(n + 1));
    for (std::size_t i = 0; i < n; ++i) {
        const Vector v = minus(points[i + 1], points[0]);
        for (std::size_t j = 0; j < n; ++j) a[i][j] = 2 * dot(v, minus(points[j + 1], points[0]));
        a[i][n] = dot(v, v);
    }
    for (std::size_t k = 0; k < n; ++k) {
        if (std::abs(a[k][k]) < 1e-12) return std::nullopt;
        for (std::size_t i = 0; i < n; ++i) {
            if (i == k) continue;
            const double factor = a[i][k] / a[k][k];
            for (std::size_t j = k; j <= n; ++j) a[i][j] -= factor * a[k][j];
        }
    }
    std::vector<double> weights{1};
    for (std::size_t k = 0; k < n; ++k) {
        weights.push_back(a[k][n] / a[k][k]);
        weights[0] -= weights.back();
    }
    return weights;
}

struct Critical {
    double distance;
    int index;
};

// All critical values of the distance to the points above 0: of simplices that hold the centre of
// their sphere, with no point inside of it.
std::vector<Critical> critical_values(const std::vector<Vector>& points) {
    std::vector<Critical> found;
    const std::size_t n = points.size();
    for (std::size_t subset = 1; subset < std::size_t(1) << n; ++subset) {
        std::vector<Vector> of;
        for (std::size_t k = 0; k < n; ++k) {
            if (subset >> k & 1) of.push_back(points[k]);
        }
        if (of.size() < 2 || of.size() > 4) continue;
        const auto weights = weights_of_centre(of);
        if (!weights || std::ranges::min(*weights) <= 0) continue;
        Vector centre{};
        for (std::size_t k = 0; k < of.size(); ++k) {
            for (std::size_t i = 0; i < 3; ++i) centre[i] += (*weights)[k] * of[k][i];
        }
        const Vector r = minus(of[0], centre);
        const auto is_inside = [&](const Vector& p) {
            const Vector d = minus(p, centre);
            return dot(d, d) < dot(r, r) * (1 - 1e-9);
        };
        if (std::ranges::any_of(points, is_inside)) continue;
        found.push_back({std::sqrt(dot(r, r)), int(of.size()) - 1});
    }
    std::ranges::sort(found, {}, &Critical::distance);
    return found;
}

// The balls about random points grow: they meet, in pairs, threes and fours.
TEST(KinkedEvents, OfBallsThatGrowAreThoseOfTheirCentres) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
        SCOPED_TRACE(fmt::format("seed {}", seed));
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> place(-0.8, 0.8);
        std::vector<Vector> points(5);
        std::array<std::string, 3> columns;
        for (std::size_t i = 0; i < 3; ++i) {
            for (Vector& p : points) {
                p[i] = place(random);
                columns[i] += fmt::format("{}{:.17g}", columns[i].empty() ? "" : ", ", p[i]);
            }
        }
        // Greatest and least are mirrors of each other.
        const bool is_greatest = seed % 2 == 0;
        const std::string formula =
            is_greatest ? "greatest(balls, r - sqrt((x-cx)^2 + (y-cy)^2 + (z-cz)^2))"
                        : "least(balls, (x-cx)^2 + (y-cy)^2 + (z-cz)^2) - r^2";
        const Moving moving{
            formula, around, "r = \"0.05 + 0.9*t\"",
            fmt::format("[arrays.balls]\ncount = {}\ncx = [{}]\ncy = [{}]\ncz = [{}]",
                        points.size(), columns[0], columns[1], columns[2])};
        std::vector<Group> groups;
        for (const Critical& value : critical_values(points)) {
            if (value.distance < 0.95)
                groups.push_back({(value.distance - 0.05) / 0.9, 1, value.index, true});
        }
        const Side side = is_greatest ? Side::positive : Side::negative;
        expect_events(events_of(moving, 0, 1, side), groups);
    }
}

} // namespace
} // namespace isomotion::topology
