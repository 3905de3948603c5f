// Marching by cubics: closed forms, and that neither the unit of F nor that of length matters.
#include "render/drawing.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace isomotion::render::hermite_test {
namespace {

// A view without beams and with them: both sides of a formula's default.
struct View {
    double height = 2.4;
    int pixels = 64;
    bool beam = false;
};

// An orthographic picture along -x of a formula in a sphere: pixel (column, row) is the ray y, z =
// (column, row) from the middle, columns against y.
class Hermite : public Drawing {
protected:
    Picture look(const std::string& formula, const View& view = {}, double bounds = 1.5,
                 const std::string& more = {}) {
        return draw(*context, scene_of(fmt::format(R"([surface]
formula = "{}"
bounds = {{ sphere = {} }}
[camera]
position = [{}, 0, 0]
projection = "orthographic"
height = {}
[output]
size = [{}, {}]
[isolation]
method = "hermite"
beam = {}
{})",
                                                   formula, bounds, 4 * bounds, view.height,
                                                   view.pixels, view.pixels, view.beam, more)));
    }
};
ISOMOTION_ON_EVERY_BACKEND(Hermite);

float at(const Picture& picture, const char* channel, std::size_t pixel) {
    return picture.frame.find(channel)->samples[pixel];
}

Verdict verdict(const Picture& picture, std::size_t pixel) {
    return Verdict(int(at(picture, "verdict", pixel)));
}

bool is_found(Verdict verdict) {
    return verdict == Verdict::hit || verdict == Verdict::zero_gradient;
}

std::int64_t found(const Picture& picture) {
    return count(picture, Verdict::hit) + count(picture, Verdict::zero_gradient);
}

// Distance of the pixel's ray from the x axis.
double off_axis(const View& view, std::size_t pixel) {
    const double size = view.height / view.pixels, middle = 0.5 * (view.pixels - 1);
    const auto across = std::size_t(view.pixels);
    return size * std::hypot(double(pixel % across) - middle, double(pixel / across) - middle);
}

std::size_t pixels(const View& view) { return std::size_t(view.pixels) * std::size_t(view.pixels); }

// A sphere's powers: roots of order 1 to 4 along every ray. A ray of one pixel in 4000 passes as
// near to the silhouette as a hundredth of a pixel, where either is right.
TEST_P(Hermite, SpheresOfAnyOrderAreWhereTheyAre) {
    for (const bool beam : {false, true}) {
        for (const int power : {1, 2, 3, 4}) {
            SCOPED_TRACE(fmt::format("power {}, beam {}", power, beam));
            const View view{2.4, 64, beam};
            const Picture picture = look(fmt::format("(x^2 + y^2 + z^2 - 1)^{}", power), view);
            const double pixel = view.height / view.pixels;
            int missed = 0, false_hits = 0, far = 0;
            for (std::size_t k = 0; k < pixels(view); ++k) {
                const double off = off_axis(view, k);
                if (std::abs(off - 1) < 0.01 * pixel) continue;
                const bool hit = is_found(verdict(picture, k));
                missed += off < 1 && !hit;
                false_hits += off > 1 && hit && power < 4;
                // The fourth power is below float's 2^-24 within a sixtieth of the surface.
                const double reach = power < 4 ? 0.25 * pixel : pixel;
                if (hit && off < 0.95) {
                    far += std::abs(at(picture, "P.X", k) - std::sqrt(1 - off * off)) > reach;
                }
            }
            EXPECT_EQ(missed, 0);
            EXPECT_EQ(false_hits, 0);
            EXPECT_EQ(far, 0);
            EXPECT_EQ(count(picture, Verdict::step_limit), 0);
            EXPECT_EQ(count(picture, Verdict::nan), 0);
        }
    }
}

// What is linear along the ray takes a few samples.
TEST_P(Hermite, APlaneTakesFewSamples) {
    for (const double x : {0.0, 0.2, -0.7}) {
        const View view{0.8, 32};
        const Picture picture = look(fmt::format("x - {}", x), view);
        EXPECT_EQ(count(picture, Verdict::hit), 32 * 32);
        for (std::size_t k = 0; k < pixels(view); ++k) {
            ASSERT_NEAR(at(picture, "P.X", k), x, 1e-5);
            ASSERT_EQ(at(picture, "N.X", k), 1);
        }
        EXPECT_LE(picture.evaluations(), 14 * 32 * 32);
    }
}

// F = 0 to the last bit where a ray is sampled: at its begin, its middle, its end.
TEST_P(Hermite, ARootAtASampleIsARoot) {
    const std::string box = "[surface]\nbounds = { box = [[-1, -1, -1], [1, 1, 1]] }\n"
                            "[camera]\nposition = [5, 0, 0]\nprojection = \"orthographic\"\n"
                            "height = 1.5\n[output]\nsize = [32, 32]\n[isolation]\n"
                            "method = \"hermite\"\n";
    for (const char* formula :
         {"x", "-x", "x^3", "x^2", "-x^2", "x*(x - 0.5)", "x^2*(x + 0.5)", "x*(x^2 - 0.25)"}) {
        for (const bool beam : {false, true}) {
            SCOPED_TRACE(fmt::format("{}, beam {}", formula, beam));
            std::string text = box + fmt::format("beam = {}\n", beam);
            text.insert(text.find("bounds"), fmt::format("formula = \"{}\"\n", formula));
            const Picture picture = draw(*context, scene_of(text));
            EXPECT_EQ(found(picture), 32 * 32);
        }
    }
}

// Two sheets a thousandth apart, then closer than any step: as many hits as of one sheet.
TEST_P(Hermite, AThinShellIsNotSteppedOver) {
    const std::int64_t plane = found(look("x - 0.2"));
    EXPECT_GT(plane, 3000);
    for (const char* thickness : {"2.5e-7", "1e-9", "1e-12", "0"}) {
        const Picture picture = look(fmt::format("(x - 0.2)^2 - {}", thickness));
        EXPECT_NEAR(double(found(picture)), double(plane), 4) << thickness;
    }
    const Picture sphere = look("x^2 + y^2 + z^2 - 1");
    const Picture shell = look("(sqrt(x^2 + y^2 + z^2) - 1)^2 - 2.5e-7");
    int missed = 0;
    for (std::size_t k = 0; k < pixels({}); ++k) {
        missed += verdict(sphere, k) == Verdict::hit && !is_found(verdict(shell, k));
    }
    EXPECT_EQ(missed, 0);
}

// The first of two sheets is hit, however near the other is.
TEST_P(Hermite, TheFirstSheetIsHit) {
    for (const double apart : {0.5, 0.1, 1e-2, 1e-3}) {
        const View view{0.8, 32};
        const Picture picture = look(fmt::format("(x - 0.2)*(x - {})", 0.2 + apart), view);
        EXPECT_EQ(count(picture, Verdict::hit), 32 * 32);
        for (std::size_t k = 0; k < pixels(view); ++k) {
            ASSERT_NEAR(at(picture, "P.X", k), 0.2 + apart, 1e-5) << apart;
        }
    }
}

// A torus from its side, half a degree off its plane: rays graze its far and near walls.
TEST_P(Hermite, AGrazedTorusHasTheSilhouetteOfSigns) {
    for (const double z : {0.0, 0.05, 0.5}) {
        const std::string scene = fmt::format(R"toml([surface]
formula = "(x^2 + y^2 + z^2 + 0.75)^2 - 4*(x^2 + y^2)"
bounds = {{ sphere = 1.7 }}
[camera]
position = [6, 0, {}]
[output]
size = [96, 96]
[isolation]
step = 0.002
)toml",
                                              z);
        const Picture signs = draw(*context, scene_of(scene + "method = \"amp-sign\"\n"));
        const Picture cubics = draw(*context, scene_of(scene + "method = \"hermite\"\n"));
        int missed = 0, different = 0;
        for (std::size_t k = 0; k < 96 * 96; ++k) {
            const bool a = is_found(verdict(signs, k)), b = is_found(verdict(cubics, k));
            missed += a && !b;
            different += a != b;
            if (a && b) different += std::abs(at(signs, "Z", k) - at(cubics, "Z", k)) > 0.02;
        }
        EXPECT_EQ(missed, 0) << z;
        EXPECT_LE(different, 2) << z;
        EXPECT_GT(count(cubics, Verdict::hit), 1000);
        EXPECT_LT(cubics.evaluations(), signs.evaluations());
    }
}

constexpr const char* shapes[] = {
    "x^2 + y^2 + z^2 - 1", "(x^2 + y^2 + z^2 + 0.75)^2 - 4*(x^2 + y^2)",
    "x^2*y^2 + y^2*z^2 + z^2*x^2 - x*y*z", "sin(5*x) + sin(5*y) + sin(5*z)"};

// A power of two changes no digit of F, but what drivers make of the product may.
TEST_P(Hermite, TheUnitOfFDoesNotMatter) {
    for (const char* shape : shapes) {
        for (const bool beam : {false, true}) {
            const View view{2.4, 48, beam};
            const Picture unit = look(shape, view);
            EXPECT_GT(found(unit), 200) << shape;
            for (const double factor : {0x1p-27, 0x1p-3, 0x1p27}) {
                SCOPED_TRACE(fmt::format("{} times {}, beam {}", shape, factor, beam));
                const Picture scaled = look(fmt::format("({})*{:.17g}", shape, factor), view);
                EXPECT_EQ(scaled.verdicts, unit.verdicts);
                EXPECT_NEAR(double(scaled.evaluations()), double(unit.evaluations()),
                            1e-3 * double(unit.evaluations()));
                for (std::size_t k = 0; k < pixels(view); ++k) {
                    ASSERT_NEAR(at(scaled, "P.X", k), at(unit, "P.X", k), 1e-4) << k;
                }
            }
            for (const double factor : {1e-8, -1e-3, -1.0, 1e3, 1e8}) {
                SCOPED_TRACE(fmt::format("{} times {}, beam {}", shape, factor, beam));
                const Picture scaled = look(fmt::format("({})*({:.17g})", shape, factor), view);
                int different = 0;
                for (std::size_t k = 0; k < pixels(view); ++k) {
                    different += is_found(verdict(scaled, k)) != is_found(verdict(unit, k));
                }
                EXPECT_LE(different, 1);
            }
        }
    }
}

// So does the unit of length, from 10^-3 to 10^6.
TEST_P(Hermite, TheUnitOfLengthDoesNotMatter) {
    for (const bool beam : {false, true}) {
        const View unit_view{2.4, 48, beam};
        const Picture unit = look("(x^2 + y^2 + z^2 + 0.75)^2 - 4*(x^2 + y^2)", unit_view, 1.7);
        for (const double size : {1e-3, 0x1p-10, 10.0, 1e6}) {
            SCOPED_TRACE(fmt::format("size {}, beam {}", size, beam));
            const Picture picture = look(fmt::format("((x/r)^2 + (y/r)^2 + (z/r)^2 + 0.75)^2 - "
                                                     "4*((x/r)^2 + (y/r)^2)"),
                                         {2.4 * size, 48, beam}, 1.7 * size,
                                         fmt::format("[parameters]\nr = {}\n", size));
            int different = 0;
            for (std::size_t k = 0; k < pixels(unit_view); ++k) {
                different += is_found(verdict(picture, k)) != is_found(verdict(unit, k));
            }
            EXPECT_LE(different, 1);
        }
    }
}

// The eye inside of a sphere, and inside of a solid: what is behind it is not seen.
TEST_P(Hermite, ARayThatStartsInsideMeetsTheWallAhead) {
    for (const char* formula :
         {"x^2 + y^2 + z^2 - 1", "1 - x^2 - y^2 - z^2", "(x^2 + y^2 + z^2 - 1)^2"}) {
        for (const bool beam : {false, true}) {
            SCOPED_TRACE(fmt::format("{}, beam {}", formula, beam));
            const Picture picture =
                draw(*context, scene_of(fmt::format("[surface]\nformula = \"{}\"\nbounds = {{ "
                                                    "sphere = 1.5 }}\n[camera]\nposition = [0.4, "
                                                    "0, 0]\ntarget = [0, 0, 0]\nfov = 90\n"
                                                    "[output]\nsize = [48, 48]\n[isolation]\n"
                                                    "method = \"hermite\"\nbeam = {}\n",
                                                    formula, beam)));
            EXPECT_EQ(found(picture), 48 * 48);
            for (std::size_t k = 0; k < 48 * 48; ++k) {
                const double x = at(picture, "P.X", k), y = at(picture, "P.Y", k),
                             z = at(picture, "P.Z", k);
                ASSERT_NEAR(x * x + y * y + z * z, 1, 2e-3);
                ASSERT_LT(x, 0.4);
            }
        }
    }
}

TEST_P(Hermite, AConstantIsAMiss) {
    for (const char* formula : {"1 + 1e-30*x", "1e-36*x - 1e-30", "1e30 + 1e-7*x", "max(1, x - 5)",
                                "1e-20*x - 1", "x^2 + 1e-30 + 1"}) {
        for (const bool beam : {false, true}) {
            const Picture picture = look(formula, {2.4, 32, beam});
            EXPECT_EQ(count(picture, Verdict::miss), 32 * 32) << formula << ", beam " << beam;
            // Nothing to look at is not looked at for long.
            EXPECT_LE(picture.evaluations(), 40 * 32 * 32) << formula;
        }
    }
}

TEST_P(Hermite, WhereFHasNoValueThereIsNothing) {
    for (const bool beam : {false, true}) {
        SCOPED_TRACE(beam);
        const View view{2.4, 48, beam};
        const Picture undefined = look("log(x - 2) + y", view);
        EXPECT_EQ(count(undefined, Verdict::miss), 48 * 48);
        // Not a number in half of the picture alone.
        const Picture half = look("x - 0.2 + 1e-9*log(z)", view);
        EXPECT_GT(count(half, Verdict::miss), 500);
        EXPECT_GT(count(half, Verdict::hit), 500);
        EXPECT_EQ(count(half, Verdict::miss) + count(half, Verdict::hit), 48 * 48);
    }
}

TEST_P(Hermite, GivingUpIsReported) {
    for (const bool beam : {false, true}) {
        SCOPED_TRACE(beam);
        const View view{2.4, 48, beam};
        const Picture tired = look(beam ? "exp(x^2 + y^2 + z^2) - 2.7" : "x^2 + y^2 + z^2 - 1e-4",
                                   view, 1.5, "limit = 2\n");
        EXPECT_GT(count(tired, Verdict::step_limit), 500);
        EXPECT_EQ(count(tired, Verdict::hit), 0);
        for (const float evaluations : tired.frame.find("evaluations")->samples) {
            ASSERT_LE(evaluations, 2);
        }
    }
}

// They change the sign of F, which is 0 nowhere.
TEST_P(Hermite, JumpsAndPolesAreNoRoots) {
    for (const char* formula : {"sign(x - 0.2)", "1/(x - 0.2)", "x - floor(x) + 0.1 - 2*sign(x)"})
        EXPECT_EQ(found(look(formula, {0.8, 32})), 0) << formula;
}

} // namespace
} // namespace isomotion::render::hermite_test
