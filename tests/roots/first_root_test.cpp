// First roots of single rays along z: of even order, on the ends of the bounds, close together, at
// kinks and jumps. Nothing may be stated that they contradict, and where a tube is not too thick to
// tell, the answer is known.
#include <cmath>

#include "scene/error.h"
#include "view.h"

namespace isomotion::roots {
namespace {

// The one answer of a ray along z.
FirstRoot answer(const View& view) { return view.roots.at(0); }

void expect_hit(const View& view, double at, double width = 1e-4) {
    SCOPED_TRACE(view.scene.surfaces[0].field->text);
    const FirstRoot root = answer(view);
    EXPECT_EQ(root.answer, Answer::hit) << testing::PrintToString(root);
    EXPECT_LE(root.low, at);
    EXPECT_GE(root.high, at);
    EXPECT_LE(double(root.high) - double(root.low), width);
}

// Something may touch zero all over [from, to] and not much further.
void expect_touching(const View& view, double from, double to, double width = 0.02) {
    SCOPED_TRACE(view.scene.surfaces[0].field->text);
    const FirstRoot root = answer(view);
    EXPECT_EQ(root.answer, Answer::touching) << testing::PrintToString(root);
    EXPECT_LE(root.touch_low, from);
    EXPECT_GE(root.touch_high, to);
    EXPECT_LE(double(root.touch_high) - double(root.touch_low), to - from + width);
}

void expect_miss(const View& view) {
    SCOPED_TRACE(view.scene.surfaces[0].field->text);
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
    for (const char* formula : {"z^3", "-z^5", "z*abs(z)", "z*abs(z)^0.5"}) {
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

// A sign changes where nothing is zero: the shader, which looks for changes, may draw it. No bound
// tells a jump from a root, so neither is certain.
TEST(FirstRoot, OfAJumpIsNoCertainHit) {
    for (const char* formula : {"floor(z) + 0.5", "sign(z) + 0.5", "z/abs(z)",
                                "z + 1e-4*(floor(z) + 0.5)", "sign(z)*z^2 + 0.001*sign(z)"}) {
        const View view = along_z(formula);
        EXPECT_EQ(answer(view).answer, Answer::touching) << formula;
        EXPECT_TRUE(holds(answer(view), view.tubes[0], {0})) << formula;
    }
    for (const char* formula : {"floor(z) + 4.5", "sign(z) + 2"}) {
        EXPECT_NE(answer(along_z(formula)).answer, Answer::hit) << formula;
    }
    expect_miss(along_z("floor(z) + 4.5"));
}

// Numerators tell a pole from a root.
TEST(FirstRoot, OfAPoleIsAMiss) {
    for (const char* formula :
         {"1/z", "tan(z + pi/2)", "z^-3", "z^(-301)", "1/z^2", "min(tan(z + pi/2), 2)"})
        expect_miss(along_z(formula));
    expect_hit(along_z("1/z - 0.8"), 1.25);
    expect_hit(along_z("1/z^3 - 0.5"), std::cbrt(2));
    expect_hit(along_z("max(1/z - 1, z - 1.2)"), 1);
    expect_hit(along_z("tan(z + pi/2) + 1"), std::atan(1));
    expect_miss(along_z("z + 1/(z - 1)^3"));
}

// A quotient may jump from one bounded value to another where its numerator keeps off 0.
TEST(FirstRoot, OfAWallIsNoMissWhateverTheNumerator) {
    expect_touching(along_z("1/(floor(z) - 0.5)", {.jumps_are_walls = true}), 1, 1);
    expect_miss(along_z("1/(floor(z) - 0.5)"));
}

// Behind poles, where slopes on both sides of one have the same sign, there are roots all the same.
TEST(FirstRoot, BehindAPoleIsNoMiss) {
    for (const char* formula : {"tan(20*z + 2.141)", "tan(20*z)", "-tan(20*z) + 0.1*z"}) {
        for (const bool backwards : {false, true}) {
            // From pole to pole there is one root; a pole may be what is met first.
            const FirstRoot found = answer(along_z(formula, {.backwards = backwards}));
            EXPECT_NE(found.answer, Answer::miss) << formula;
            EXPECT_TRUE(found.answer == Answer::hit || found.after_is_hit) << formula;
        }
    }
    EXPECT_NE(answer(along_z("(z - 0.999)^(-301) + 2")).answer, Answer::miss);
    // What is cut off at 10^30 is level beyond, and grows on paper.
    for (const char* formula : {"min(exp(100*z), 2e30) - 1.5e30", "1e31*(z - 0.8) - exp(100*z)"}) {
        EXPECT_NE(answer(along_z(formula)).answer, Answer::hit) << formula;
        EXPECT_NE(answer(along_z(formula)).answer, Answer::miss) << formula;
    }
}

// Where F has no value nothing crosses, though what cuts or chooses hides it from its slopes.
TEST(FirstRoot, WhereThereIsNoValueIsNoCertainHit) {
    for (const char* formula :
         {"min(z, 3 + sin(log(z^2 - 0.01)))", "z*sign(2 + sin(log(z^2 - 0.01)))",
          "z + sqrt(-1 - abs(log(z^2 - 0.01)))"}) {
        EXPECT_NE(answer(along_z(formula)).answer, Answer::hit) << formula;
    }
}

// F comes to 0 where its values end: the last of them may be met.
TEST(FirstRoot, BeforeAGapMayTouch) {
    for (const char* formula : {"z^1.5", "z^1.5*(2 + sin(x))", "-z^0.7", "abs(z^1.5)"}) {
        const View view = along_z(formula, {.backwards = true});
        EXPECT_EQ(answer(view).answer, Answer::touching) << formula;
        EXPECT_FALSE(answer(view).after_is_hit) << formula;
        EXPECT_NEAR(answer(view).touch_high, 0, 1e-3) << formula;
    }
    // Behind the gap is another root.
    const View view = along_z("(z^2 - 0.25)^1.5 - 1", {.backwards = true});
    EXPECT_EQ(answer(view).answer, Answer::hit);
    EXPECT_NE(answer(along_z("(z^2 - 0.25)^1.5 + 1")).answer, Answer::hit) << "on both sides";
    EXPECT_EQ(answer(along_z("log(z - 3)")).answer, Answer::miss) << "no value anywhere";
}

// From 1 to 0.
TEST(FirstRoot, OfAPowerOf0WhoseExponentComesTo0IsNoCertainHit) {
    for (const char* formula :
         {"0^max(z, 0) - 0.5 - z", "0^abs(z) - 0.5", "max(x - 1, 0)^max(z, 0) - 0.5 - 0.1*z"}) {
        EXPECT_NE(answer(along_z(formula)).answer, Answer::hit) << formula;
    }
}

// Squares of lengths overflow in the shader: no ray is known. Scenes in which they underflow are
// refused with file, line and key, as no picture of them can be right.
TEST(FirstRoot, BeyondTheRangeOfFloatsIsUndecided) {
    for (const char* size : {"1e-30", "1e-20"}) {
        EXPECT_THROW(
            along_z(fmt::format("z/{}", size), {.bounds = fmt::format("{{ sphere = {} }}", size)}),
            scene::SceneError)
            << size;
    }
    for (const char* size : {"1e20", "1e30"}) {
        const View view =
            along_z(fmt::format("z/{}", size), {.bounds = fmt::format("{{ sphere = {} }}", size)});
        EXPECT_EQ(answer(view).answer, Answer::undecided) << size;
    }
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

// ---- what must not matter to a picture

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
    const formula::EnclosurePrograms field =
        formula::enclosure_programs(*view.scene.surfaces[0].field);
    RootFinder finder(field, view.now.surfaces[0]);
    for (std::size_t k = 0; k < view.roots.size(); k += 7) {
        FirstRoot alone{Answer::undecided, true, 1, 2, 3, 4, {}}; // what was there before goes
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
} // namespace isomotion::roots
