// Pictures of surfaces whose roots are known in closed form along every ray.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "view.h"

namespace isomotion::roots {
namespace {

using std::numbers::pi;

// Everything that a picture's answers say of their tubes' middle rays.
struct Tally {
    int hits = 0, misses = 0, uncertain = 0;
};

using Zeros = std::function<std::vector<double>(const Tube&)>;

// `zeros` gives a ray's roots, sorted.
Tally check(const View& view, const Zeros& zeros, double slack = 0) {
    Tally tally;
    for (std::size_t k = 0; k < view.roots.size(); ++k) {
        const Tube& tube = view.tubes[k];
        if (!(tube.near <= tube.far)) {
            EXPECT_EQ(view.roots[k].answer, Answer::miss);
            ++tally.misses;
            continue;
        }
        const Answer answer = view.roots[k].answer;
        EXPECT_TRUE(holds(view.roots[k], tube, zeros(tube), slack)) << "pixel " << k;
        ++(answer == Answer::hit    ? tally.hits
           : answer == Answer::miss ? tally.misses
                                    : tally.uncertain);
    }
    return tally;
}

// How far the middle ray passes from the origin.
double distance(const Tube& tube) {
    return glm::length(tube.anchor - glm::dot(tube.anchor, tube.direction) * tube.direction);
}

TEST(ClosedForms, OfASphereFromEverywhere) {
    const char* cameras[] = {
        from_aside,
        "position = [0, 0, 3]\nfov = 60",
        "position = [2e4, 1e4, -3e4]\nfov = 0.004",
        "position = [0, 0, 4]\nprojection = 'orthographic'\nheight = 2.5",
        "position = [3, 2, 1]\nprojection = 'orthographic'\nheight = 0.01",
    };
    for (const char* camera : cameras) {
        SCOPED_TRACE(camera);
        const View view = picture("x^2 + y^2 + z^2 - 1", camera);
        const Tally tally = check(
            view, [](const Tube& tube) { return on_sphere(tube, 1); }, 1e-12);
        EXPECT_GT(tally.hits, 100);
        for (std::size_t k = 0; k < view.roots.size(); ++k) {
            const double off = distance(view.tubes[k]) - 1;
            if (std::abs(off) < 4 * view.tubes[k].radius) continue;
            EXPECT_EQ(view.roots[k].answer, off < 0 ? Answer::hit : Answer::miss)
                << "pixel " << k << ": " << testing::PrintToString(view.roots[k]);
        }
    }
}

TEST(ClosedForms, OfASphereFromWithinIsBeforeTheEye) {
    const View view =
        picture("x^2 + y^2 + z^2 - 1", "position = [0.3, 0.2, -0.5]\ntarget = [1, 0, 0]\nfov = 90");
    const Tally tally = check(
        view, [](const Tube& tube) { return on_sphere(tube, 1); }, 1e-12);
    EXPECT_EQ(tally.hits, view.width * view.height);
    // Looking away from outside.
    const View away = picture("x^2 + y^2 + z^2 - 1", "position = [2, 0, 0]\ntarget = [3, 0, 0]");
    for (const FirstRoot& root : away.roots) EXPECT_EQ(root.answer, Answer::miss);
}

TEST(ClosedForms, OfASquareIsNeverACertainHitNorAMissWhereThereIsOne) {
    const char* surfaces[] = {
        "x^2 + y^2 + z^2 - 1",
        "x - 0.5*y + 0.25*z",
        "(sqrt(x^2 + y^2) - 0.875)^2 + z^2 - 0.140625",
        "x^3*y - y^3*z + z^3*x + 0.125*x*y - 0.0625",
    };
    for (const char* surface : surfaces) {
        SCOPED_TRACE(surface);
        const View simple = picture(surface, from_aside, 24);
        const View square = picture(fmt::format("({})^2", surface), from_aside, 24);
        int hits = 0, misses_known = 0;
        for (std::size_t k = 0; k < simple.roots.size(); ++k) {
            const FirstRoot &g = simple.roots[k], &gg = square.roots[k];
            SCOPED_TRACE(fmt::format("pixel {}: {} and {}", k, testing::PrintToString(g),
                                     testing::PrintToString(gg)));
            EXPECT_NE(gg.answer, Answer::hit);
            EXPECT_FALSE(gg.after_is_hit);
            if (g.answer == Answer::hit) {
                ++hits;
                EXPECT_EQ(gg.answer, Answer::touching);
                EXPECT_LE(gg.touch_low, g.high);
                EXPECT_GE(gg.touch_high, g.low);
            }
            if (g.answer == Answer::miss && gg.answer == Answer::miss) ++misses_known;
        }
        EXPECT_GT(hits, 100);
        EXPECT_GT(misses_known, 20);
    }
}

TEST(ClosedForms, OfAnOctahedronIsOnItsFirstFace) {
    const View view = picture("abs(x) + abs(y) + abs(z) - 1", from_aside, 48);
    const Tally tally = check(
        view,
        [](const Tube& tube) -> std::vector<double> {
            double enter = -HUGE_VAL, leave = HUGE_VAL;
            for (int corner = 0; corner < 8; ++corner) {
                const glm::dvec3 normal(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1,
                                        corner & 4 ? 1 : -1);
                const double slope = glm::dot(normal, tube.direction);
                const double t = (1 - glm::dot(normal, tube.anchor)) / slope;
                (slope < 0 ? enter : leave) = slope < 0 ? std::max(enter, t) : std::min(leave, t);
            }
            if (enter > leave) return {};
            return {enter, leave};
        },
        1e-12);
    EXPECT_GT(tally.hits, 300);
    EXPECT_GT(tally.misses, 300);
    EXPECT_LE(tally.uncertain, 2);
}

TEST(ClosedForms, OfANeedledSuperquadric) {
    constexpr double m = 0.4;
    const View view = picture(fmt::format("abs(x)^{0} + abs(y)^{0} + abs(z)^{0} - 1", m),
                              "position = [0, 0, 4]\nprojection = 'orthographic'\nheight = 2.1", 48,
                              "{ box = [[-1.05, -1.05, -1.05], [1.05, 1.05, 1.05]] }");
    const Tally tally = check(
        view,
        [](const Tube& tube) -> std::vector<double> {
            const double rest =
                1 - std::pow(std::abs(tube.anchor.x), m) - std::pow(std::abs(tube.anchor.y), m);
            if (rest < 0) return {};
            const double z = std::pow(rest, 1 / m);
            return {-z, z};
        },
        1e-6);
    EXPECT_GT(tally.hits, 100);
    EXPECT_GT(tally.misses, 1000);
}

TEST(ClosedForms, OfATorusAlongItsAxis) {
    for (const char* formula : {"(sqrt(x^2 + y^2) - 0.875)^2 + z^2 - 0.140625",
                                "(x^2 + y^2 + z^2 + 0.625)^2 - 3.0625*(x^2 + y^2)"}) {
        SCOPED_TRACE(formula);
        const View view =
            picture(formula, "position = [0, 0, 4]\nprojection = 'orthographic'\nheight = 3", 48);
        const Tally tally = check(
            view,
            [](const Tube& tube) -> std::vector<double> {
                const double off = std::hypot(tube.anchor.x, tube.anchor.y) - 0.875;
                const double square = 0.140625 - off * off;
                if (square < 0) return {};
                return {-std::sqrt(square), std::sqrt(square)};
            },
            1e-12);
        EXPECT_GT(tally.hits, 600);
        EXPECT_GT(tally.misses, 600);
        EXPECT_EQ(tally.uncertain, 0);
    }
}

// Rays through the planes z = levels[i].
Zeros planes(std::vector<double> levels) {
    return [levels](const Tube& tube) {
        std::vector<double> zeros;
        for (const double z : levels) zeros.push_back((z - tube.anchor.z) / tube.direction.z);
        std::sort(zeros.begin(), zeros.end());
        return zeros;
    };
}

TEST(ClosedForms, OfChebyshevSlabs) {
    for (const int n : {2, 9, 14, 22, 50}) {
        SCOPED_TRACE(n);
        std::vector<double> levels;
        for (int k = 0; k < n; ++k) levels.push_back(std::cos((2 * k + 1) * pi / (2 * n)));
        const View view = picture(fmt::format("chebyshev({}, z)", n), from_aside, 24);
        const Tally tally = check(view, planes(levels), 1e-9);
        EXPECT_GT(tally.hits, 300);
        // The outermost sheets of T_50 are nearer to each other than the shortest piece.
        EXPECT_LE(tally.uncertain, n < 50 ? 3 : 30);
    }
}

// T_n + 1 only touches zero, n/2 times (and crosses nowhere within for even n).
TEST(ClosedForms, OfChebyshevSlabsThatOnlyTouch) {
    for (const int n : {8, 22}) {
        SCOPED_TRACE(n);
        std::vector<double> levels;
        for (int k = 1; k < n; k += 2) levels.push_back(std::cos(k * pi / n));
        const View view = picture(fmt::format("chebyshev({}, z) + 1", n), from_aside, 16);
        const Tally tally = check(view, planes(levels), 1e-9);
        EXPECT_EQ(tally.hits, 0);
        EXPECT_GT(tally.uncertain, 150);
    }
}

TEST(ClosedForms, OfAPlaneSeenFromAlmostWithinIt) {
    // 2^-12 above the plane, which fills the lower half of the picture up to the horizon.
    const View view = picture("z",
                              "position = [0, -1, 0.000244140625]\n"
                              "target = [0, 1, 0.000244140625]\nup = [0, 0, 1]\nfov = 20",
                              32);
    const Tally tally = check(view, planes({0}), 1e-12);
    EXPECT_GT(tally.hits, 400);
    EXPECT_GT(tally.misses, 400);
}

TEST(ClosedForms, OfNothingIsAMissEverywhere) {
    for (const char* formula : {"x^2 + y^2 + z^2 + 0.001", "-exp(x + y*z)", "cos(x*y*z) + 1.01"}) {
        const View view = picture(formula, from_aside, 24);
        for (const FirstRoot& root : view.roots) {
            ASSERT_EQ(root.answer, Answer::miss) << formula << testing::PrintToString(root);
        }
    }
    // The bounds themselves are nowhere in the picture.
    const View aside = picture("x", "position = [0, 0, 9]\ntarget = [0, 9, 9]", 8);
    for (const FirstRoot& root : aside.roots) EXPECT_EQ(root.answer, Answer::miss);
}

} // namespace
} // namespace isomotion::roots
