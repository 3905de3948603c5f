// First roots where closed forms say where they are: nothing may be stated that they contradict,
// and away from where a tube is too thick to tell, the answer is known.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "view.h"

namespace isomotion::truth {
namespace {

using std::numbers::pi;

// The one answer of a ray along z.
FirstRoot answer(const View& view) { return view.roots.at(0); }

void expect_hit(const View& view, double at, double width = 1e-4) {
    SCOPED_TRACE(view.scene.surface.field->text);
    const FirstRoot root = answer(view);
    EXPECT_EQ(root.answer, Answer::hit) << testing::PrintToString(root);
    EXPECT_LE(root.low, at);
    EXPECT_GE(root.high, at);
    EXPECT_LE(double(root.high) - double(root.low), width);
}

// Something may touch zero all over [from, to] and not much further.
void expect_touching(const View& view, double from, double to, double width = 0.02) {
    SCOPED_TRACE(view.scene.surface.field->text);
    const FirstRoot root = answer(view);
    EXPECT_EQ(root.answer, Answer::touching) << testing::PrintToString(root);
    EXPECT_LE(root.touch_low, from);
    EXPECT_GE(root.touch_high, to);
    EXPECT_LE(double(root.touch_high) - double(root.touch_low), to - from + width);
}

void expect_miss(const View& view) {
    SCOPED_TRACE(view.scene.surface.field->text);
    EXPECT_EQ(answer(view).answer, Answer::miss) << testing::PrintToString(answer(view));
}

// ---- roots that only touch

TEST(FirstRoot, OfADoubleRootIsNoCertainHit) {
    expect_touching(along_z("(z - 0.25)^2"), 0.25, 0.25);
    expect_touching(along_z("-(z - 0.25)^2"), 0.25, 0.25);
    expect_touching(along_z("(z - 0.25)^4"), 0.25, 0.25, 0.2);
    expect_touching(along_z("abs(z - 0.25)"), 0.25, 0.25);
    EXPECT_FALSE(answer(along_z("(z - 0.25)^2")).after_is_hit);
}

TEST(FirstRoot, BehindADoubleRootIsFoundToo) {
    const std::string formula = "(z - 1)^2*(z + 1)";
    expect_hit(along_z(formula), -1);
    const View back = along_z(formula, {.backwards = true});
    expect_touching(back, -1, -1);
    EXPECT_TRUE(answer(back).after_is_hit);
    EXPECT_TRUE(holds(answer(back), back.tubes[0], {-1, 1}));
    EXPECT_LE(answer(back).high - answer(back).low, 1e-4);
}

TEST(FirstRoot, OfSeveralDoubleRootsHasThemAllBetween) {
    const View view = along_z("(z + 0.75)^2*(z + 0.25)^2*(z - 0.5)^2*(z - 1)");
    expect_touching(view, -0.75, 0.5);
    EXPECT_TRUE(answer(view).after_is_hit);
    EXPECT_TRUE(holds(answer(view), view.tubes[0], {-0.75, -0.25, 0.5, 1}));
}

TEST(FirstRoot, OfOddOrderIsACrossing) {
    for (const char* formula : {"z^3", "-z^5", "sign(z)*z^2", "sign(z)*sqrt(abs(z))"}) {
        const View view = along_z(formula);
        EXPECT_TRUE(holds(answer(view), view.tubes[0], {0})) << formula;
        EXPECT_EQ(answer(view).answer, Answer::hit) << formula;
    }
}

TEST(FirstRoot, WhereTheFieldIsZeroInAVolume) {
    expect_touching(along_z("max(x^2 + y^2 + z^2 - 1, 0)"), -1, 1);
    expect_touching(along_z("min(x^2 + y^2 + z^2 - 1, 0)"), -1.5, 1.5);
    // Zero on the way from one sign to the other: a crossing, wherever in it the root is said to
    // be.
    const View view = along_z("max(z - 0.25, 0) + min(z + 0.25, 0)");
    const FirstRoot root = answer(view);
    EXPECT_NE(root.answer, Answer::miss);
    EXPECT_LE(root.answer == Answer::touching ? root.touch_low : root.low, -0.25);
    EXPECT_GE(root.answer == Answer::touching ? root.touch_high : root.high, 0.25);
}

// A sign changes where nothing is zero: the shader, which looks for changes, may draw it.
TEST(FirstRoot, OfAJumpOrAPoleIsWhereTheSignChanges) {
    for (const char* formula : {"floor(z) + 0.5", "sign(z) + 0.5", "1/z", "z/abs(z)"}) {
        const View view = along_z(formula);
        EXPECT_NE(answer(view).answer, Answer::miss) << formula;
        EXPECT_TRUE(holds(answer(view), view.tubes[0], {0})) << formula;
    }
    for (const char* formula : {"floor(z) + 4.5", "1/z^2", "sign(z) + 2"}) {
        EXPECT_NE(answer(along_z(formula)).answer, Answer::hit) << formula;
    }
    expect_miss(along_z("floor(z) + 4.5"));
}

// ---- the ends of the bounds

TEST(FirstRoot, OnAnEndOfTheBoundsMayBeSeenOrNot) {
    for (const char* bounds : {"{ sphere = 1.5 }", "{ box = [[-1, -1, -1.5], [1, 1, 1.5]] }"}) {
        SCOPED_TRACE(bounds);
        for (const bool backwards : {false, true}) {
            const Axial ray{.backwards = backwards, .bounds = bounds};
            const double side = backwards ? -1 : 1;
            expect_touching(along_z("z - 1.5", ray), side * 1.5, side * 1.5);
            expect_touching(along_z("z + 1.5", ray), -side * 1.5, -side * 1.5);
            expect_touching(along_z("(z + 1.5)*(z - 1.5)", ray), -1.5, 1.5);
            const View inside = along_z("(z + 1.5)*(z - 0.5)*(z - 1.5)", ray);
            EXPECT_TRUE(
                holds(answer(inside), inside.tubes[0], {-1.5 * side, 0.5 * side, 1.5 * side}));
            EXPECT_EQ(answer(inside).answer, Answer::touching);
        }
    }
}

TEST(FirstRoot, NearAnEndOfTheBoundsIsCertain) {
    expect_hit(along_z("z + 1.4990234375"), -1.4990234375);
    expect_hit(along_z("z - 1.4990234375"), 1.4990234375);
    expect_miss(along_z("z + 1.5009765625"));
    expect_miss(along_z("z - 1.5009765625"));
    // Beyond the bounds behind it nothing counts, also where it is nearer to the eye.
    expect_hit(along_z("(z + 1.5009765625)*(z - 0.5)"), 0.5);
}

// ---- roots close together, and surfaces that graze

TEST(FirstRoot, OfTwoSheetsIsTheFirst) {
    // 1.2e-4 apart, with a third behind them.
    const View view = along_z("(z - 0.25)*(z - 0.2501220703125)*(z - 1)");
    expect_hit(view, 0.25, 1.2e-4);
    expect_hit(along_z("(z - 0.25)*(z - 0.2501220703125)", {.backwards = true}), -0.2501220703125,
               1.2e-4);
    expect_hit(along_z("(z - 0.25)*(z - 0.2501220703125)*(z - 0.250244140625)"), 0.25, 1.2e-4);
}

TEST(FirstRoot, OfSheetsTooCloseToTellApartIsNotLost) {
    for (int k = 10; k <= 40; ++k) {
        const double gap = std::ldexp(1, -k);
        const View view =
            along_z(fmt::format("(z - 0.25)*(z - 0.25 - {:.17g})*(z - 1)", gap), {.pixel = 0.125});
        EXPECT_TRUE(holds(answer(view), view.tubes[0], {0.25, 0.25 + gap, 1})) << "2^-" << k;
        EXPECT_NE(answer(view).answer, Answer::undecided) << "2^-" << k;
    }
}

// Roots on the sphere about the origin.
std::vector<double> on_sphere(const Tube& tube, double radius) {
    const double middle = -glm::dot(tube.anchor, tube.direction);
    const glm::dvec3 foot = tube.anchor + middle * tube.direction;
    const double square = radius * radius - glm::dot(foot, foot);
    if (square < 0) return {};
    return {middle - std::sqrt(square), middle + std::sqrt(square)};
}

TEST(FirstRoot, OfAGrazedSphereIsCertainOnlyOutsideOfTheTube) {
    const std::string sphere = "x^2 + y^2 + z^2 - 1";
    for (int k = 3; k <= 30; ++k) {
        const double off = std::ldexp(1, -k);
        SCOPED_TRACE(fmt::format("2^-{} off the silhouette", k));
        const View in = along_z(sphere, {.x = 1 - off}), out = along_z(sphere, {.x = 1 + off});
        for (const View* view : {&in, &out}) {
            const Tube& tube = view->tubes[0];
            EXPECT_TRUE(holds(answer(*view), tube, on_sphere(tube, 1), 1e-12));
        }
        const double radius = in.tubes[0].radius;
        if (off > 4 * radius) {
            EXPECT_EQ(answer(in).answer, Answer::hit);
            EXPECT_EQ(answer(out).answer, Answer::miss);
        } else if (off < 0.5 * radius) {
            // The tube has rays on both sides.
            EXPECT_EQ(answer(in).answer, Answer::touching);
            EXPECT_EQ(answer(out).answer, Answer::touching);
        }
    }
    const View on = along_z(sphere, {.x = 1});
    expect_touching(on, 0, 0);
}

// ---- pictures

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

View picture(const std::string& formula, const std::string& camera, int side = 32,
             const std::string& bounds = "{ sphere = 1.5 }") {
    return View(scene_of(fmt::format("[surface]\nformula = '''{}'''\nbounds = {}\n[camera]\n{}\n",
                                     formula, bounds, camera)),
                side, side);
}

constexpr const char* from_aside = "position = [2.1, -1.7, 3.3]\ntarget = [0.1, 0, 0]\nfov = 40";

// How far the middle ray passes from the origin.
double distance(const Tube& tube) {
    return glm::length(tube.anchor - glm::dot(tube.anchor, tube.direction) * tube.direction);
}

TEST(FirstRoot, OfASphereFromEverywhere) {
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

TEST(FirstRoot, OfASphereFromWithinIsBeforeTheEye) {
    const View view =
        picture("x^2 + y^2 + z^2 - 1", "position = [0.3, 0.2, -0.5]\ntarget = [1, 0, 0]\nfov = 90");
    const Tally tally = check(
        view, [](const Tube& tube) { return on_sphere(tube, 1); }, 1e-12);
    EXPECT_EQ(tally.hits, view.width * view.height);
    // Looking away from outside.
    const View away = picture("x^2 + y^2 + z^2 - 1", "position = [2, 0, 0]\ntarget = [3, 0, 0]");
    for (const FirstRoot& root : away.roots) EXPECT_EQ(root.answer, Answer::miss);
}

TEST(FirstRoot, OfASquareIsNeverACertainHitNorAMissWhereThereIsOne) {
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

TEST(FirstRoot, OfAnOctahedronIsOnItsFirstFace) {
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

TEST(FirstRoot, OfANeedledSuperquadric) {
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

TEST(FirstRoot, OfATorusAlongItsAxis) {
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

TEST(FirstRoot, OfChebyshevSlabs) {
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
TEST(FirstRoot, OfChebyshevSlabsThatOnlyTouch) {
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

TEST(FirstRoot, OfAPlaneSeenFromAlmostWithinIt) {
    // 2^-12 above the plane, which fills the lower half of the picture up to the horizon.
    const View view = picture("z",
                              "position = [0, -1, 0.000244140625]\n"
                              "target = [0, 1, 0.000244140625]\nup = [0, 0, 1]\nfov = 20",
                              32);
    const Tally tally = check(view, planes({0}), 1e-12);
    EXPECT_GT(tally.hits, 400);
    EXPECT_GT(tally.misses, 400);
}

TEST(FirstRoot, OfNothingIsAMissEverywhere) {
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

// ---- what must not matter

void expect_same(const FirstRoot& a, const FirstRoot& b) {
    EXPECT_EQ(a.answer, b.answer);
    EXPECT_EQ(a.after_is_hit, b.after_is_hit);
    EXPECT_EQ(a.low, b.low);
    EXPECT_EQ(a.high, b.high);
    EXPECT_EQ(a.touch_low, b.touch_low);
    EXPECT_EQ(a.touch_high, b.touch_high);
}

TEST(FirstRoot, IsTheSameAloneAndAmongOthers) {
    const View view = picture("(x^2 + y^2 - 0.5)^2 + (y*z - 0.125)^2 - 0.03125", from_aside, 24);
    const formula::EnclosurePrograms field = formula::enclosure_programs(*view.scene.surface.field);
    RootFinder finder(field, view.now);
    for (std::size_t k = 0; k < view.roots.size(); k += 7) {
        FirstRoot alone{Answer::undecided, true, 1, 2, 3, 4}; // what was there before goes
        finder.find({&view.tubes[k], 1}, {&alone, 1});
        expect_same(alone, view.roots[k]);
    }
}

TEST(FirstRoot, IsThatOfTheFieldTimesAnyPowerOfTwo) {
    const std::string formula = "x^4 + y^4 + z^4 - x^2 - y^2*z - 0.25*z + 0.1";
    const View view = picture(formula, from_aside, 24);
    for (const char* factor : {"-1", "1024", "-0.000030517578125"}) {
        SCOPED_TRACE(factor);
        const View other = picture(fmt::format("({})*({})", factor, formula), from_aside, 24);
        for (std::size_t k = 0; k < view.roots.size(); ++k) {
            expect_same(view.roots[k], other.roots[k]);
        }
    }
}

} // namespace
} // namespace isomotion::truth
